// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From tables and point sets to picks.

#ifndef SeismicHorizonsPickColumns_h
#define SeismicHorizonsPickColumns_h

#include "Common/Survey/ColumnRole.h"
#include "Common/Survey/NullValues.h"
#include "Common/Survey/PickTable.h"

#include <map>
#include <string>

class vtkDataObject;

namespace SeismicHorizons
{
/// Which array has a role, by name. Roles that are not listed are looked for by the names of the arrays.
using ColumnChoice = std::map<ColumnRole, std::string>;

/// The picks of a vtkTable or a vtkPointSet: numbers of its arrays, and, where no array is chosen for them, the
/// coordinates of points as x, y and z. Points that are ghosts are left out. Throws InputError where an array that is
/// chosen is not there, where z or the place is missing, and at a place that is not finite.
PickTable MakePickTable(vtkDataObject* data, const ColumnChoice& choice, const NullValues& nulls);
}

#endif
