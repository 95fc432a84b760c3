// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Removes vertices, and flips edges, of triangles that enclose bodies. What is closed and not pierced stays so, since
// each change is tested before it is made:
//
// - A vertex moves to the other end of an edge, one on a line along the line. The neighbours that both ends have in
//   common are corners of the triangles between them (Dey et al. 1999, "Topology preserving edge contraction").
// - On the plane of its sheet, each triangle stays counter-clockwise.
// - No new triangle meets another one but at common corners and edges.
// - Heights of the sheet are within its error, and places that lines had within the error of lines.
// - No angle gets smaller than the smallest allowed, or than it was.

#ifndef SeismicHorizonsSealedImprover_h
#define SeismicHorizonsSealedImprover_h

#include "Common/Base/Monitor.h"
#include "SealedComplex.h"
#include "Sheets.h"

#include <vector>

namespace SeismicHorizons
{
constexpr double MostGap = 3.0; // errors; the height of strips beyond the tips of a fault that may be closed

struct SheetShape
{
  SheetHeights Heights; // empty for level sheets
  double Error = 0.0;
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();

  bool IsLevel() const { return this->Heights.Heights.empty(); }
};

struct ImproverOptions
{
  double LineError;
  double SmallestAngle; // degrees
  double Column; // the size of small triangles
};

SealedComplex Improve(SealedComplex complex, const std::vector<SheetShape>& shapes, const ImproverOptions& options,
  const Monitor& monitor = Monitor());

/// The largest distance of heights from triangles of their sheet.
double MeasureLargestError(const SealedComplex& complex, const std::vector<SheetShape>& shapes);
}

#endif
