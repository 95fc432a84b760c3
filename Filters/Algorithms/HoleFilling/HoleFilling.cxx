// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HoleFilling.h"

#include "Boundary/ColumnRaster.h"
#include "Boundary/EmptyBands.h"
#include "Common/Parallel.h"
#include "Common/Parameters.h"
#include "Common/PlaneGeometry.h"
#include "GapFiller.h"
#include "GapParts.h"
#include "GapSearch.h"
#include "SiteSolver.h"

#include <algorithm>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
/// Gaps that a thread takes at a time.
constexpr std::int64_t Grain = 16;

void CheckOptions(const HoleFillingOptions& options)
{
  CheckAtLeast<std::int64_t>("largest hole size", options.LargestHoleSize, 0, " columns");
  CheckWithin("rim smoothing", options.RimSmoothing, 0.0, LargestRimSmoothing, "");
  CheckWithin("rim width", options.RimWidth, 1, LargestRimWidth, " columns");
}

/// Numbers along an axis of the raster, of which some are known, at least one: the others go on from their neighbours.
std::vector<std::int32_t> Continued(std::vector<std::int32_t> numbers, const std::vector<bool>& isKnown)
{
  const std::size_t first = std::size_t(std::find(isKnown.begin(), isKnown.end(), true) - isKnown.begin());
  for (std::size_t n = first; n-- > 0;)
  {
    numbers[n] = numbers[n + 1] - 1;
  }
  for (std::size_t n = first + 1; n < numbers.size(); ++n)
  {
    numbers[n] = isKnown[n] ? numbers[n] : numbers[n - 1] + 1;
  }
  return numbers;
}

/// The column that each place of a raster stands for. Every row and column of it in which there is a gap has a point.
RasterFrame FindFrame(
  const std::vector<PlanePoint>& columns, const std::vector<PlanePoint>& near, const ColumnRaster& raster)
{
  std::vector<std::int32_t> columnOf(std::size_t(raster.Width()), 0);
  std::vector<std::int32_t> rowOf(std::size_t(raster.Height()), 0);
  std::vector<bool> isColumnKnown(columnOf.size());
  std::vector<bool> isRowKnown(rowOf.size());
  const std::int64_t first = columns.empty() ? 0 : raster.Place(near.front());
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    const std::size_t x = std::size_t(first % raster.Width() + near[point].X - near.front().X);
    const std::size_t y = std::size_t(first / raster.Width() + near[point].Y - near.front().Y);
    columnOf[x] = columns[point].X;
    rowOf[y] = columns[point].Y;
    isColumnKnown[x] = true;
    isRowKnown[y] = true;
  }
  return RasterFrame(raster, Continued(std::move(columnOf), isColumnKnown), Continued(std::move(rowOf), isRowKnown));
}

class HoleFiller
{
public:
  HoleFiller(const ColumnRaster& raster, const RasterFrame& frame, const std::vector<double>& heights,
    const std::vector<PointValue>& attributes, const HoleFillingOptions& options, const LinkCuts* cuts)
    : Raster(raster)
    , Frame(frame)
    , Heights(heights)
    , Attributes(attributes)
    , Options(options)
    , Cuts(cuts)
    , Gaps(FindGaps(raster))
  {
  }

  FilledColumns Run(const Monitor& monitor)
  {
    this->Allocate();
    // The largest, which are solved one by one, tell how far they are themselves; threads share the others.
    const auto small = std::partition(this->Closed.begin(), this->Closed.end(),
      [this](std::size_t gap) { return this->Gaps.Columns[gap] >= std::int64_t(MultigridSize); });
    const std::size_t large = std::size_t(small - this->Closed.begin());
    const double share = large == 0 ? 0.0 : large == this->Closed.size() ? 1.0 : 0.8;
    for (std::size_t n = 0; n < large; ++n)
    {
      this->Fill(
        this->Closed[n], monitor.Step(share * double(n) / double(large), share * double(n + 1) / double(large)));
    }
    ParallelFor(std::int64_t(this->Closed.size() - large), Grain, monitor.Step(share, 1.0),
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          this->Fill(this->Closed[large + std::size_t(n)], Monitor());
        }
      });
    return this->WithoutOpenGaps();
  }

private:
  /// Finds which gaps are to be closed, and makes room for their columns.
  void Allocate()
  {
    this->Begin.assign(this->Gaps.Size(), 0);
    std::size_t size = 0;
    for (std::size_t gap = 0; gap < this->Gaps.Size(); ++gap)
    {
      this->Begin[gap] = size;
      if (this->Gaps.Columns[gap] <= this->Options.LargestHoleSize)
      {
        this->Closed.push_back(gap);
        size += std::size_t(this->Gaps.Columns[gap]);
      }
    }
    this->Result.Column.resize(size);
    this->Result.Height.resize(size);
    this->Result.Nearest.resize(size, NoPoint);
    this->Result.Attribute.assign(this->Attributes.size(), std::vector<double>(size));
  }

  /// The places of a gap, in their order.
  std::vector<std::int64_t> Places(std::size_t gap) const
  {
    std::vector<std::int64_t> places;
    places.reserve(std::size_t(this->Gaps.Columns[gap]));
    for (const GapRun* run = this->Gaps.begin(gap); run != this->Gaps.end(gap); ++run)
    {
      for (std::int64_t place = run->First; place <= run->Last; ++place)
      {
        places.push_back(place);
      }
    }
    return places;
  }

  void Fill(std::size_t gap, const Monitor& monitor)
  {
    const std::vector<std::int64_t> places = this->Places(gap);
    if (!this->Cuts)
    {
      this->FillPart(places, this->Begin[gap], monitor);
      return;
    }
    std::size_t begin = this->Begin[gap];
    for (const std::vector<std::int64_t>& part : SplitGap(this->Raster, this->Frame, *this->Cuts, places))
    {
      this->FillPart(part, begin, monitor);
      begin += part.size();
    }
  }

  void FillPart(const std::vector<std::int64_t>& places, std::size_t begin, const Monitor& monitor)
  {
    const GapRegion region(this->Raster, this->Frame, this->Cuts, places, this->Options.RimWidth);
    const GapFill fill = FillGap(region, this->Heights, this->Attributes, this->Options, monitor);
    if (fill.Nearest.empty())
    {
      return;
    }
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      this->Result.Column[begin + n] = this->Frame.Column(places[n]);
    }
    std::copy(fill.Height.begin(), fill.Height.end(), this->Result.Height.begin() + std::ptrdiff_t(begin));
    std::copy(fill.Nearest.begin(), fill.Nearest.end(), this->Result.Nearest.begin() + std::ptrdiff_t(begin));
    for (std::size_t a = 0; a < fill.Attribute.size(); ++a)
    {
      std::copy(
        fill.Attribute[a].begin(), fill.Attribute[a].end(), this->Result.Attribute[a].begin() + std::ptrdiff_t(begin));
    }
  }

  /// The result without the columns of parts that nothing known is linked to.
  FilledColumns WithoutOpenGaps()
  {
    std::int64_t cutOff = 0;
    for (const std::size_t gap : this->Closed)
    {
      const auto begin = this->Result.Nearest.begin() + std::ptrdiff_t(this->Begin[gap]);
      cutOff += std::count(begin, begin + this->Gaps.Columns[gap], NoPoint) > 0 ? 1 : 0;
    }
    this->Result.FilledGaps = std::int64_t(this->Closed.size()) - cutOff;
    this->Result.OpenGaps = std::int64_t(this->Gaps.Size()) - this->Result.FilledGaps;
    if (cutOff > 0)
    {
      this->DropCutOff();
    }
    return std::move(this->Result);
  }

  void DropCutOff()
  {
    std::size_t kept = 0;
    for (std::size_t n = 0; n < this->Result.Nearest.size(); ++n)
    {
      if (this->Result.Nearest[n] != NoPoint)
      {
        this->Result.Column[kept] = this->Result.Column[n];
        this->Result.Height[kept] = this->Result.Height[n];
        this->Result.Nearest[kept] = this->Result.Nearest[n];
        for (std::vector<double>& values : this->Result.Attribute)
        {
          values[kept] = values[n];
        }
        ++kept;
      }
    }
    this->Result.Column.resize(kept);
    this->Result.Height.resize(kept);
    this->Result.Nearest.resize(kept);
    for (std::vector<double>& values : this->Result.Attribute)
    {
      values.resize(kept);
    }
  }

  const ColumnRaster& Raster;
  const RasterFrame& Frame;
  const std::vector<double>& Heights;
  const std::vector<PointValue>& Attributes;
  const HoleFillingOptions& Options;
  const LinkCuts* const Cuts;
  const GapList Gaps;
  std::vector<std::size_t> Closed; // gaps
  std::vector<std::size_t> Begin; // of the columns of each gap in the result
  FilledColumns Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
FilledColumns FillHoles(const std::vector<PlanePoint>& columns, const std::vector<double>& heights,
  const std::vector<PointValue>& attributes, const HoleFillingOptions& options, const LinkCuts* cuts,
  const Monitor& monitor)
{
  CheckOptions(options);
  return WithoutWideBands(columns, options.RimWidth,
    [&](const std::vector<PlanePoint>& near)
    {
      // Rings, and what stencils look at, stay in the raster.
      const ColumnRaster raster(near, options.RimWidth + SiteBox::Margin);
      const RasterFrame frame = FindFrame(columns, near, raster);
      monitor.Progress(0.1);
      return HoleFiller(raster, frame, heights, attributes, options, cuts).Run(monitor.Step(0.1, 1.0));
    });
}
}
