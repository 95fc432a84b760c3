// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultLines.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
CutLink MeasureCut(const ColumnHeights& heights, std::int64_t link, bool isForward)
{
  const double before = heights[LinkGrid::FirstColumn(link)];
  const double beyond = heights[heights.Grid().SecondColumn(link)];
  const double middle = std::isnan(before) ? beyond : std::isnan(beyond) ? before : 0.5 * (before + beyond);
  return { heights.Grid().ToLink(link), beyond - before, middle, isForward };
}

//----------------------------------------------------------------------------------------------------------------------
void FaultLines::Append(const FaultLines& other)
{
  for (const std::size_t end : other.Ends)
  {
    this->Ends.push_back(this->Links.size() + end);
  }
  this->Links.insert(this->Links.end(), other.Links.begin(), other.Links.end());
}

//----------------------------------------------------------------------------------------------------------------------
void FaultLines::Close()
{
  const std::size_t start = this->Ends.empty() ? 0 : this->Ends.back();
  if (this->Links.size() == start)
  {
    return;
  }
  double sum = 0.0;
  for (std::size_t n = start; n < this->Links.size(); ++n)
  {
    const double left = this->Links[n].LeftThrow();
    sum += std::isfinite(left) ? left : 0.0;
  }
  if (sum < 0.0)
  {
    const auto first = this->Links.begin() + std::ptrdiff_t(start);
    std::reverse(first, this->Links.end());
    std::for_each(first, this->Links.end(), [](CutLink& link) { link.IsForward = !link.IsForward; });
  }
  this->Ends.push_back(this->Links.size());
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<LinkOfLine> SortLinks(const FaultLines& lines)
{
  std::vector<LinkOfLine> sorted;
  sorted.reserve(lines.NumberOfLinks());
  for (std::size_t line = 0; line < lines.Size(); ++line)
  {
    for (std::size_t n = lines.Start(line); n < lines.End(line); ++n)
    {
      sorted.push_back({ n, line });
    }
  }
  const auto key = [&lines](const LinkOfLine& item)
  {
    const LatticeLink& link = lines[item.Link].Place;
    return std::make_tuple(link.Column.Y, link.Column.X, link.Side);
  };
  // Stable, so that the first line that has a link comes first.
  std::stable_sort(
    sorted.begin(), sorted.end(), [&key](const LinkOfLine& a, const LinkOfLine& b) { return key(a) < key(b); });
  sorted.erase(std::unique(sorted.begin(), sorted.end(),
                 [&key](const LinkOfLine& a, const LinkOfLine& b) { return key(a) == key(b); }),
    sorted.end());
  return sorted;
}
}
