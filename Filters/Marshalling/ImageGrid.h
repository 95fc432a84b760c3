// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From images to grids of columns.

#ifndef SeismicHorizonsImageGrid_h
#define SeismicHorizonsImageGrid_h

#include "Common/Survey/HorizonGrid.h"
#include "Common/Survey/NullValues.h"

#include <string>

class vtkImageData;

namespace SeismicHorizons
{
/// The grid of a level image of one layer, whose columns are its points, or the centres of its cells where z is an
/// array of these. `zArray` is the name of the array with z; empty for the active scalars, or where there are none for
/// the first array of one component, of points before cells. Other arrays of numbers on the same become attributes.
/// z counts upwards where the array has the name that ParaView's readers of GeoTIFF and DEM files give to elevations.
/// Points and cells that are blanked have no z. Throws InputError where there is no such array, and on an image that is
/// not level or has several layers.
HorizonGrid MakeHorizonGrid(vtkImageData* image, const std::string& zArray, const NullValues& nulls);
}

#endif
