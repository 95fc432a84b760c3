// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From points and meshes to z at the columns of their lattice.

#ifndef SeismicHorizonsHorizonSampling_h
#define SeismicHorizonsHorizonSampling_h

#include "Common/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

#include <cstddef>
#include <cstdint>
#include <string>

class vtkPolyData;

namespace SeismicHorizons
{
/// Whether point arrays of that name are of readers and stages, and say nothing of the picks but their places.
bool IsOwnArray(const std::string& name);

/// How many columns the lattice of a horizon of some points has. Throws InputError from 2^31 on: a file with something
/// for each of them would fill disks, and mostly is of a few points that are far apart.
std::size_t CountColumns(int columns, int rows, std::int64_t points);

/// The horizon on the columns that it has, with z as `sign` times world z. Point arrays of real numbers, other than
/// those that stages keep for themselves, are attributes; meshes have none. Throws InputError on a horizon without a
/// lattice, on points off its columns where there are no triangles, and on polygons that are no triangles.
HorizonColumns SampleHorizon(vtkPolyData* horizon, int sign, const Monitor& monitor);

/// The same over its whole lattice, without attributes. Throws InputError on a lattice of 2^31 columns or more, on a
/// large one of which the horizon has hardly any, and on a mesh over no column.
HorizonGrid SampleWholeLattice(vtkPolyData* horizon, int sign, const Monitor& monitor);
}

#endif
