// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Surface.h"

#include "Common/Horizon/SpacePoints.h"
#include "Filters/Algorithms/BoundarySimplification/FewestPoints.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
constexpr std::int32_t NotOnSeam = -1;
// FewestPoints keeps points with this number of visits.
constexpr unsigned char Stays = 2;

/// Points are numbered from left to right.
class Seam
{
public:
  Seam(PlanePoints columns, std::int32_t row, bool isUpper, const BoundaryOptions& options)
    : Columns(columns)
    , IsUpper(isUpper)
    , Radius(options.Radius)
    , LongestEdge(std::max(options.Radius, options.Seams.LongestEdge))
    , Number(columns.size(), NotOnSeam)
  {
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      if (columns[point].Y == row)
      {
        this->Points.push_back(PointId(point));
      }
    }
    std::sort(this->Points.begin(), this->Points.end(), [&](PointId a, PointId b) { return this->X(a) < this->X(b); });
    for (std::size_t n = 0; n < this->Points.size(); ++n)
    {
      this->Number[this->Points[n]] = std::int32_t(n);
    }
    this->IsNode.assign(this->Points.size(), 0);
  }

  void FindNodes(const std::vector<double>& height, double heightTolerance)
  {
    std::vector<PlanePoint> places;
    std::vector<double> heights;
    for (const PointId point : this->Points)
    {
      places.push_back({ this->X(point), 0 });
      heights.push_back(height[point]);
    }
    const std::vector<unsigned char> visits(places.size(), Stays);
    const SpacePoints points(places, heights, 1);
    const ColumnIndex index(places);
    FewestPoints fewest(points, index, visits, 0.0, heightTolerance, []() {});
    for (std::size_t from = 0; from < this->Points.size();)
    {
      std::size_t to = from + 1;
      for (; to < this->Points.size() && this->StepTo(to) <= this->LongestEdge; ++to)
      {
      }
      std::vector<PointId> chain(to - from);
      std::iota(chain.begin(), chain.end(), PointId(from));
      for (const std::size_t position : fewest.SimplifyChain(std::move(chain)))
      {
        this->IsNode[from + position] = 1;
      }
      from = to;
    }
    this->IsKept = this->IsNode;
  }

  /// Turns of loops are kept, and ends of gaps that loops follow on the side of the surface.
  void KeepTurns(const PointId* loop, std::size_t length)
  {
    for (std::size_t n = 0; n < length; ++n)
    {
      const std::int32_t before = this->Number[loop[(n + length - 1) % length]];
      const std::int32_t here = this->Number[loop[n]];
      const std::int32_t after = this->Number[loop[(n + 1) % length]];
      if (here != NotOnSeam && (before == NotOnSeam || after == NotOnSeam || after - here != here - before))
      {
        this->IsKept[here] = 1;
      }
      // Along the other side, loops run right on an upper seam, left on a lower seam.
      const bool isInside = here != NotOnSeam && after != NotOnSeam && after - here == (this->IsUpper ? -1 : 1);
      if (isInside && this->StepTo(std::size_t(std::max(here, after))) > this->Radius)
      {
        this->IsKept[here] = 1;
        this->IsKept[after] = 1;
        this->OpenGaps.push_back(this->Points[std::min(here, after)]);
      }
    }
  }

  bool IsDropped(PointId point) const
  {
    const std::int32_t number = this->Number[point];
    return number != NotOnSeam && this->IsKept[number] == 0;
  }

  void Write(const std::vector<double>& height, SeamChains& result) const
  {
    result.OpenGaps.insert(result.OpenGaps.end(), this->OpenGaps.begin(), this->OpenGaps.end());
    for (std::size_t n = 0; n < this->Points.size(); ++n)
    {
      if (this->IsNode[n] == 0)
      {
        this->WriteBetweenNodes(n, height, result);
      }
      if (this->IsKept[n] != 0)
      {
        result.Kept.push_back(this->Points[n]);
      }
      else
      {
        const PointId left = this->Points[this->Before(n, this->IsKept)];
        const PointId right = this->Points[this->After(n, this->IsKept)];
        const std::int32_t x = this->X(this->Points[n]);
        result.Dropped.push_back({ this->Points[n], this->X(right) - x < x - this->X(left) ? right : left });
      }
    }
  }

private:
  std::int32_t X(PointId point) const { return this->Columns[point].X; }
  std::int32_t StepTo(std::size_t n) const { return this->X(this->Points[n]) - this->X(this->Points[n - 1]); }

  /// The ends of a seam are marked, which ends the search.
  static std::size_t Before(std::size_t n, const std::vector<unsigned char>& marks)
  {
    for (--n; marks[n] == 0; --n)
    {
    }
    return n;
  }
  static std::size_t After(std::size_t n, const std::vector<unsigned char>& marks)
  {
    for (++n; marks[n] == 0; ++n)
    {
    }
    return n;
  }

  void WriteBetweenNodes(std::size_t n, const std::vector<double>& height, SeamChains& result) const
  {
    const auto place = [&](std::size_t number)
    {
      const PointId point = this->Points[number];
      return Eigen::Vector3d(double(this->X(point)), 0.0, height[point]);
    };
    const Eigen::Vector3d left = place(this->Before(n, this->IsNode));
    const Eigen::Vector3d right = place(this->After(n, this->IsNode));
    const Eigen::Vector3d here = place(n);
    result.Deviation = std::max(result.Deviation, SpanningEdge(left, right).InSpace(here));
    const double fraction = (here.x() - left.x()) / (right.x() - left.x());
    const double onLine = left.z() + fraction * (right.z() - left.z());
    result.HeightDeviation = std::max(result.HeightDeviation, std::abs(here.z() - onLine));
    if (this->IsKept[n] != 0)
    {
      result.Pins.push_back({ this->Points[n], onLine });
    }
  }

  const PlanePoints Columns;
  const bool IsUpper;
  const std::int32_t Radius;
  const std::int32_t LongestEdge;
  std::vector<PointId> Points;
  std::vector<std::int32_t> Number; // by point
  std::vector<unsigned char> IsNode;
  std::vector<unsigned char> IsKept;
  std::vector<PointId> OpenGaps;
};
}

//----------------------------------------------------------------------------------------------------------------------
SeamChains SimplifySeams(PlanePoints columns, const std::vector<double>& height, const Loops& boundary,
  const BoundaryOptions& options, double heightTolerance)
{
  assert(columns.size() == height.size());
  std::vector<Seam> seams;
  for (const bool isUpper : { false, true })
  {
    const std::optional<std::int32_t>& row = isUpper ? options.Seams.Upper : options.Seams.Lower;
    const auto isOnRow = [&row](const PlanePoint& column) { return column.Y == *row; };
    if (row && std::any_of(columns.begin(), columns.end(), isOnRow))
    {
      seams.emplace_back(columns, *row, isUpper, options);
    }
  }
  SeamChains result;
  for (Seam& seam : seams)
  {
    seam.FindNodes(height, heightTolerance);
    for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
    {
      seam.KeepTurns(boundary.begin(loop), boundary.Length(loop));
    }
    seam.Write(height, result);
  }
  const auto isDropped = [&seams](PointId point)
  { return std::any_of(seams.begin(), seams.end(), [point](const Seam& seam) { return seam.IsDropped(point); }); };
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    std::for_each(boundary.begin(loop), boundary.end(loop),
      [&](PointId point)
      {
        if (!isDropped(point))
        {
          result.Boundary.Append(point);
        }
      });
    result.Boundary.Close();
  }
  return result;
}
}
