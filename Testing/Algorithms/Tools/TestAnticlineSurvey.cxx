// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The generated survey has what it promises. TestHorizonGenerator compares it with the sample.

#include "Check.h"
#include "Generator/AnticlineSurvey.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <sstream>
#include <utility>

using namespace SeismicHorizons;

namespace
{
/// Horizon 2 lies below horizon 1. Where it is cut off the two have the same times.
void CheckTruncation(const SparseMatrix& matrix)
{
  const LatticeHorizon& upper = matrix.Horizons.at(0);
  const LatticeHorizon& lower = matrix.Horizons.at(1);
  std::map<std::pair<int, int>, std::size_t> above;
  for (std::size_t voxel = 0; voxel < upper.Column.size(); ++voxel)
  {
    above[{ upper.Column[voxel].X, upper.Column[voxel].Y }] = voxel;
  }
  int same = 0;
  int thick = 0;
  for (std::size_t voxel = 0; voxel < lower.Column.size(); ++voxel)
  {
    const auto found = above.find({ lower.Column[voxel].X, lower.Column[voxel].Y });
    if (found != above.end())
    {
      const double thickness = lower.RealZ[voxel] - upper.RealZ[found->second]; // ms
      CHECK(lower.K[voxel] > upper.K[found->second]);
      CHECK(thickness > -2.0 && thickness < 80.0);
      same += thickness == 0.0 ? 1 : 0;
      thick += thickness > 20.0 ? 1 : 0;
    }
  }
  CHECK(same > 1500 && same < 4000);
  CHECK(thick > 8000);
}

/// Two horizons in time, at the samples nearest to it, with steps at faults.
void AnticlineIsASurvey()
{
  std::stringstream stream;
  const std::map<int, std::int64_t> counts = WriteAnticlineSurvey(stream);
  const SparseMatrix matrix = ReadSparseMatrix(stream);
  CHECK((matrix.Size == AnticlineSurveySize));
  CHECK_EQUAL(matrix.Horizons.size(), 2u);
  for (const LatticeHorizon& horizon : matrix.Horizons)
  {
    CHECK_EQUAL(counts.at(horizon.SurfaceId), static_cast<std::int64_t>(horizon.Column.size()));
    CHECK_EQUAL(horizon.DroppedDuplicates, 0);
    CHECK(horizon.Column.size() > 15000u);
    int steps = 0; // from one pick of a row to the next, over the heave
    for (std::size_t voxel = 0; voxel < horizon.Column.size(); ++voxel)
    {
      const double late = 4.0 * horizon.K[voxel] - horizon.RealZ[voxel];
      CHECK(late >= -2.0 - 1e-9 && late <= (horizon.SurfaceId == 1 ? 2.0 : 12.0) + 1e-9);
      const bool hasLast = voxel > 0 && horizon.Column[voxel].Y == horizon.Column[voxel - 1].Y;
      const bool isNear = hasLast && horizon.Column[voxel].X - horizon.Column[voxel - 1].X <= 5;
      steps += isNear && std::abs(horizon.RealZ[voxel] - horizon.RealZ[voxel - 1]) > 30.0 ? 1 : 0;
    }
    CHECK(steps > 60);
  }
  CheckTruncation(matrix);
  std::ostream broken(nullptr);
  CHECK_THROWS_WITH(WriteAnticlineSurvey(broken), "writing failed");
}
}

int TestAnticlineSurvey(int, char*[])
{
  AnticlineIsASurvey();
  return Check::Result();
}
