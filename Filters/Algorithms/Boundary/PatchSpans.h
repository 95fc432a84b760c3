// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The patch of each point of a horizon, for points in the order of rows. A span holds successive points in one patch.
// It may go through many rows, so that spans take far less memory than a number per point.

#ifndef SeismicHorizonsPatchSpans_h
#define SeismicHorizonsPatchSpans_h

#include "Common/Horizon/Types.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace SeismicHorizons
{
class PatchSpans
{
public:
  PatchSpans() = default;
  explicit PatchSpans(std::size_t points)
    : Points(PointId(points))
  {
  }

  std::size_t NumberOfPoints() const { return std::size_t(this->Points); }
  std::size_t NumberOfSpans() const { return this->Spans.size(); }

  /// The points from `first` to the next call are in the patch. The first call is for point 0, and points ascend.
  void Append(PointId first, std::int32_t patch)
  {
    if (this->Spans.empty() || this->Spans.back().Patch != patch)
    {
      this->Spans.push_back({ first, patch });
    }
  }

  /// This is a binary search.
  std::int32_t PatchAt(PointId point) const { return this->Find(point)->Patch; }

  /// Calls visit(first, last, patch) for the spans of the points from `first` to before `last`.
  template <typename Visitor>
  void ForEach(PointId first, PointId last, Visitor&& visit) const
  {
    for (auto span = first < last ? this->Find(first) : this->Spans.end(); first < last; ++span)
    {
      const auto next = std::next(span);
      const PointId end = next == this->Spans.end() ? last : std::min(last, next->First);
      visit(first, end, span->Patch);
      first = end;
    }
  }

  /// Returns the number of points of each patch.
  std::vector<std::int64_t> CountPoints(std::size_t patches) const
  {
    std::vector<std::int64_t> counts(patches, 0);
    this->ForEach(0, this->Points,
      [&counts](PointId first, PointId last, std::int32_t patch)
      {
        if (patch != NoPatch)
        {
          counts[std::size_t(patch)] += last - first;
        }
      });
    return counts;
  }

  /// numbers[patch] is the new number of each patch.
  PatchSpans Renumbered(const std::vector<std::int32_t>& numbers) const
  {
    PatchSpans result(this->NumberOfPoints());
    for (const Span& span : this->Spans)
    {
      result.Append(span.First, span.Patch == NoPatch ? NoPatch : numbers[std::size_t(span.Patch)]);
    }
    return result;
  }

private:
  struct Span
  {
    PointId First;
    std::int32_t Patch;
  };

  std::vector<Span>::const_iterator Find(PointId point) const
  {
    const auto next = std::upper_bound(this->Spans.begin(), this->Spans.end(), point,
      [](PointId wanted, const Span& span) { return wanted < span.First; });
    return std::prev(next);
  }

  std::vector<Span> Spans; // in the order of their points
  PointId Points = 0;
};
}

#endif
