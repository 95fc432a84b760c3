// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A horizon to decimate, and the errors of any mesh of it. Shares no code with the decimation, and vertices may be
// anywhere, as some peers put them between columns.

#ifndef SeismicHorizonsDecimationErrors_h
#define SeismicHorizonsDecimationErrors_h

#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "Tools/Patches.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace DecimationErrors
{
/// By column, its outline simplified.
struct Surface
{
  Surface(const Patches::Columns& columns, const std::vector<double>& heights, double tolerance);

  SeismicHorizons::BoundedHorizon Horizon;
  std::vector<SeismicHorizons::PlanePoint> Columns;
  /// Points with no column without a point nearer than six columns.
  std::vector<bool> IsInside;
};

/// In lattice units.
struct Mesh
{
  std::vector<std::array<double, 3>> Vertices;
  std::vector<std::array<std::size_t, 3>> Triangles;
};

/// Vertical, at all columns that the mesh covers. Where triangles overlap, the largest counts.
struct Errors
{
  double Mean = 0.0;
  double RootMeanSquare = 0.0;
  double Largest = 0.0;
  double LargestInside = 0.0;
  /// Triangles that face the other way in plan than most.
  std::size_t Folded = 0;
};

Errors Measure(const Surface& surface, const Mesh& mesh);
}

#endif
