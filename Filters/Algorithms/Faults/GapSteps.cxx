// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GapSteps.h"

#include "Common/FixedChunks.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
// A plane goes through the points of this many columns, along the row and across it.
constexpr std::int64_t Along = 4;
constexpr std::int64_t Across = 1; // to each side of the row
constexpr int FewestPoints = 6; // of twelve

/// Columns as seen along a row to the east, or along a file to the north.
class Strip
{
public:
  Strip(const ColumnHeights& heights, LinkSide side)
    : Heights(heights)
    , Kind(side)
  {
  }

  std::int64_t Length() const { return this->IsEast() ? this->Grid().Width() : this->Grid().Height(); }
  std::int64_t Number() const { return this->IsEast() ? this->Grid().Height() : this->Grid().Width(); }

  std::int64_t Column(std::int64_t along, std::int64_t strip) const
  {
    return this->IsEast() ? strip * this->Grid().Width() + along : along * this->Grid().Width() + strip;
  }

  bool Has(std::int64_t along, std::int64_t strip) const
  {
    return along >= 0 && along < this->Length() && strip >= 0 && strip < this->Number() &&
      this->Heights.Has(this->Column(along, strip));
  }

  double Height(std::int64_t along, std::int64_t strip) const { return this->Heights[this->Column(along, strip)]; }
  std::int64_t LinkFrom(std::int64_t along, std::int64_t strip) const
  {
    return this->Grid().LinkOf(this->Column(along, strip), this->Kind);
  }

private:
  const LinkGrid& Grid() const { return this->Heights.Grid(); }
  bool IsEast() const { return this->Kind == LinkSide::East; }

  const ColumnHeights& Heights;
  const LinkSide Kind;
};

/// The height at `place` of the plane through columns from `first` on, in the direction of `step`; nan where there are
/// too few of them, or all in a line.
double ExtendPlane(const Strip& strips, std::int64_t strip, std::int64_t first, std::int64_t step, double place)
{
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  int points = 0;
  for (std::int64_t n = 0; n < Along; ++n)
  {
    const std::int64_t along = first + n * step;
    for (std::int64_t across = -Across; across <= Across; ++across)
    {
      if (strips.Has(along, strip + across))
      {
        const Eigen::Vector3d row(1.0, double(along) - place, double(across));
        matrix += row * row.transpose();
        right += row * strips.Height(along, strip + across);
        ++points;
      }
    }
  }
  // Whole numbers, but for halves: the determinant of points in a line is nothing but rounding.
  constexpr double Nothing = 1e-6;
  if (points < FewestPoints || matrix.determinant() < Nothing)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return matrix.ldlt().solve(right)[0];
}

void FindStripSteps(const Strip& strips, std::int64_t strip, int longest, double smallest, std::vector<GapStep>& steps)
{
  std::int64_t before = -1; // the last column that is there
  for (std::int64_t along = 0; along < strips.Length(); ++along)
  {
    if (!strips.Has(along, strip))
    {
      continue;
    }
    const std::int64_t missing = along - before - 1;
    if (before >= 0 && missing >= 1 && missing <= longest)
    {
      const double middle = 0.5 * double(before + along);
      const double low = ExtendPlane(strips, strip, before, -1, middle);
      const double high = ExtendPlane(strips, strip, along, 1, middle);
      if (std::abs(high - low) >= smallest)
      {
        steps.push_back({ strips.LinkFrom(before, strip), strips.LinkFrom((before + along) / 2, strip),
          strips.LinkFrom(along - 1, strip), high - low, 0.5 * (low + high) });
      }
    }
    before = along;
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<GapStep> FindGapSteps(const ColumnHeights& heights, int longest, double smallest, const Monitor& monitor)
{
  std::vector<GapStep> all;
  for (const LinkSide side : { LinkSide::East, LinkSide::North })
  {
    const Strip strips(heights, side);
    constexpr std::int64_t ChunkSize = 16; // rows or files
    std::vector<std::vector<GapStep>> parts(CountChunks(strips.Number(), ChunkSize));
    ForEachChunk(strips.Number(), ChunkSize, monitor,
      [&](std::size_t chunk, std::int64_t first, std::int64_t last)
      {
        for (std::int64_t strip = first; strip < last; ++strip)
        {
          FindStripSteps(strips, strip, longest, smallest, parts[chunk]);
        }
      });
    for (const std::vector<GapStep>& part : parts)
    {
      all.insert(all.end(), part.begin(), part.end());
    }
  }
  std::sort(all.begin(), all.end(), [](const GapStep& a, const GapStep& b) { return a.Middle < b.Middle; });
  return all;
}
}
