// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points of a horizon as a surface to look at: a cell between neighbouring columns that are known, not across a
// fault. Points that have no such neighbours remain points.

#ifndef HorizonSheet_h
#define HorizonSheet_h

class vtkPolyData;

namespace SeismicHorizons
{
/// Point and cell arrays of a sheet: the point of the horizon, which is also its vertex.
constexpr const char* SheetIds = "HorizonSheetIds";
/// Field array of a sheet: of how many columns along a side one is shown.
constexpr const char* SheetStep = "HorizonSheetStep";

/// Of `step` columns along each side, one is shown. Contours are at multiples of `interval`, or there are none if it is
/// 0. Returns false, and changes nothing, if the points are a row, at random, without columns, or already have cells.
bool MakeSheet(vtkPolyData* horizon, int step, double interval);
}

#endif
