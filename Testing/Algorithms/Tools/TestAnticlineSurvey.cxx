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
/// Horizon 2 lies below horizon 1 in most columns, and above it by no more than a sample, where it is truncated.
void CheckTruncation(const SparseMatrix& matrix)
{
  const LatticeHorizon& lower = matrix.Horizons.at(1);
  std::map<std::pair<int, int>, int> above;
  for (std::size_t voxel = 0; voxel < matrix.Horizons.at(0).Column.size(); ++voxel)
  {
    above[{ matrix.Horizons[0].Column[voxel].X, matrix.Horizons[0].Column[voxel].Y }] = matrix.Horizons[0].K[voxel];
  }
  int common = 0;
  int crossing = 0;
  for (std::size_t voxel = 0; voxel < lower.Column.size(); ++voxel)
  {
    const auto found = above.find({ lower.Column[voxel].X, lower.Column[voxel].Y });
    if (found != above.end())
    {
      const int thickness = lower.K[voxel] - found->second;
      CHECK(thickness >= -1 && thickness <= 25);
      ++common;
      crossing += thickness < 0 ? 1 : 0;
    }
  }
  CHECK(common > 14000);
  CHECK(crossing > 500 && crossing < 2000);
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
      CHECK(std::abs(horizon.RealZ[voxel] - 4.0 * horizon.K[voxel]) <= 2.0 + 1e-9);
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
