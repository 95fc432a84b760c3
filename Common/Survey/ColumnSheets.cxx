// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnSheets.h"

#include "Common/Base/DisjointSets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
using Point = std::int32_t;

struct Contact
{
  Point Surface = 0;
  Point Layer = 0;
  std::int64_t Count = 0;
};

class SheetSplitter
{
public:
  SheetSplitter(PlanePoints columns, const std::vector<double>& heights)
    : Columns(columns)
    , Heights(heights)
    , Parts(heights.size())
    , ColumnOf(heights.size())
  {
    for (Point point = 0; point < Point(heights.size()); ++point)
    {
      if (point == 0 || this->Place(point) != this->Place(point - 1))
      {
        this->Starts.push_back(point);
      }
      this->ColumnOf[point] = std::int32_t(this->Starts.size()) - 1;
    }
    this->Starts.push_back(Point(heights.size()));
  }

  bool IsSingle() const { return this->Starts.size() == this->Heights.size() + 1; }

  /// Returns the sheet of each point, or -1 for dropped points.
  std::vector<int> Split()
  {
    this->JoinNeighbours();
    this->ListConflicts();
    for (const Contact& contact : this->CountContacts())
    {
      this->JoinUnlessAbove(contact.Surface, contact.Layer);
    }
    return this->DealOut();
  }

private:
  std::pair<int, int> Place(Point point) const { return { this->Columns[point].Y, this->Columns[point].X }; }

  int Size(std::int32_t column) const { return this->Starts[column + 1] - this->Starts[column]; }

  /// Comparisons are quadratic, and points beyond MostSheets have no sheet anyway.
  Point End(std::int32_t column) const { return this->Starts[column] + std::min(this->Size(column), MostSheets); }

  std::int32_t FindColumn(const std::pair<int, int>& place) const
  {
    const auto last = this->Starts.end() - 1;
    const auto found = std::lower_bound(this->Starts.begin(), last, place,
      [this](Point point, const std::pair<int, int>& wanted) { return this->Place(point) < wanted; });
    return found != last && this->Place(*found) == place ? std::int32_t(found - this->Starts.begin()) : -1;
  }

  /// Ties go to the first point.
  Point FindNearest(Point point, std::int32_t column) const
  {
    const double height = this->Heights[point];
    const auto distance = [this, height](Point of) { return std::abs(this->Heights[of] - height); };
    Point nearest = this->Starts[column];
    for (Point other = nearest + 1; other < this->End(column); ++other)
    {
      nearest = distance(other) < distance(nearest) ? other : nearest;
    }
    return nearest;
  }

  void JoinNeighbours()
  {
    // The other four neighbours look at this column.
    constexpr std::array<std::array<int, 2>, 4> steps = { { { 0, 1 }, { 1, -1 }, { 1, 0 }, { 1, 1 } } };
    for (std::int32_t column = 0; column + 1 < std::int32_t(this->Starts.size()); ++column)
    {
      const std::pair<int, int> place = this->Place(this->Starts[column]);
      for (const std::array<int, 2>& step : steps)
      {
        const std::int32_t other = this->FindColumn({ place.first + step[0], place.second + step[1] });
        if (other >= 0)
        {
          this->JoinColumns(column, other);
        }
      }
    }
  }

  void JoinColumns(std::int32_t column, std::int32_t other)
  {
    for (Point point = this->Starts[column]; point < this->End(column); ++point)
    {
      const Point nearest = this->FindNearest(point, other);
      if (this->FindNearest(nearest, column) != point)
      {
        continue;
      }
      if ((this->Size(column) == 1) == (this->Size(other) == 1))
      {
        this->Parts.Join(point, nearest);
      }
      else
      {
        this->Touching.push_back(this->Size(column) == 1 ? Contact{ point, nearest, 1 } : Contact{ nearest, point, 1 });
      }
    }
  }

  void ListConflicts()
  {
    this->Above.resize(this->Heights.size());
    for (std::int32_t column = 0; column + 1 < std::int32_t(this->Starts.size()); ++column)
    {
      for (Point point = this->Starts[column]; point < this->End(column); ++point)
      {
        for (Point other = this->Starts[column]; other < point; ++other)
        {
          const Point a = this->Parts.Find(point);
          const Point b = this->Parts.Find(other);
          if (a != b)
          {
            this->AddAbove(a, b);
            this->AddAbove(b, a);
          }
        }
      }
    }
    for (std::vector<Point>& parts : this->Above)
    {
      LeaveOneOfEach(parts);
    }
  }

  /// Layers overlap in many columns; duplicates are removed before the list grows.
  void AddAbove(Point part, Point other)
  {
    std::vector<Point>& parts = this->Above[part];
    if (parts.size() == parts.capacity())
    {
      LeaveOneOfEach(parts);
      parts.reserve(2 * parts.size() + 1);
    }
    parts.push_back(other);
  }

  static void LeaveOneOfEach(std::vector<Point>& parts)
  {
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  }

  std::vector<Contact> CountContacts()
  {
    for (Contact& contact : this->Touching)
    {
      contact = { this->Parts.Find(contact.Surface), this->Parts.Find(contact.Layer), 1 };
    }
    const auto key = [](const Contact& contact) { return std::make_tuple(contact.Surface, contact.Layer); };
    std::sort(this->Touching.begin(), this->Touching.end(),
      [&key](const Contact& a, const Contact& b) { return key(a) < key(b); });
    std::vector<Contact> counted;
    for (const Contact& contact : this->Touching)
    {
      if (counted.empty() || key(counted.back()) != key(contact))
      {
        counted.push_back({ contact.Surface, contact.Layer, 0 });
      }
      ++counted.back().Count;
    }
    std::stable_sort(
      counted.begin(), counted.end(), [](const Contact& a, const Contact& b) { return a.Count > b.Count; });
    return counted;
  }

  void JoinUnlessAbove(Point a, Point b)
  {
    a = this->Parts.Find(a);
    b = this->Parts.Find(b);
    if (this->Above[a].size() < this->Above[b].size())
    {
      std::swap(a, b);
    }
    std::vector<Point>& few = this->Above[b];
    const bool isAbove =
      std::any_of(few.begin(), few.end(), [this, a](Point other) { return this->Parts.Find(other) == a; });
    if (a == b || isAbove)
    {
      return;
    }
    std::vector<Point> all = std::move(this->Above[a]);
    all.insert(all.end(), few.begin(), few.end());
    few.clear();
    this->Parts.Join(a, b);
    this->Above[this->Parts.Find(a)] = std::move(all);
  }

  /// Prefers the given sheet; returns MostSheets if all are taken.
  static int FindFreeSheet(std::uint64_t taken, int preferred)
  {
    const auto isTaken = [taken](int sheet) { return sheet < MostSheets && (taken >> sheet & 1U) != 0; };
    int sheet = isTaken(preferred) ? 0 : preferred;
    while (isTaken(sheet))
    {
      ++sheet;
    }
    return sheet;
  }

  /// The largest part goes first, to the first sheet without its columns.
  std::vector<int> DealOut()
  {
    const std::size_t size = this->Heights.size();
    std::vector<Point> order(size);
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::int64_t> sizes(size, 0);
    for (const Point point : order)
    {
      ++sizes[this->Parts.Find(point)];
    }
    std::stable_sort(order.begin(), order.end(),
      [this, &sizes](Point a, Point b)
      {
        const Point partA = this->Parts.Find(a);
        const Point partB = this->Parts.Find(b);
        return std::make_tuple(-sizes[partA], partA) < std::make_tuple(-sizes[partB], partB);
      });
    std::vector<std::uint64_t> taken(this->Starts.size(), 0); // a bit per sheet with a point in the column
    std::vector<int> sheets(size, -1);
    for (std::size_t first = 0; first < size;)
    {
      std::size_t last = first;
      std::uint64_t used = 0;
      for (; last < size && this->Parts.Find(order[last]) == this->Parts.Find(order[first]); ++last)
      {
        used |= taken[this->ColumnOf[order[last]]];
      }
      const int sheet = FindFreeSheet(used, 0);
      for (; first < last; ++first)
      {
        // A part that lies above itself, as on a dip of the distance between its layers, continues on other sheets.
        std::uint64_t& ofColumn = taken[this->ColumnOf[order[first]]];
        const int own = FindFreeSheet(ofColumn, sheet);
        if (own < MostSheets)
        {
          ofColumn |= std::uint64_t(1) << own;
          sheets[order[first]] = own;
        }
      }
    }
    return sheets;
  }

  const PlanePoints Columns;
  const std::vector<double>& Heights;
  DisjointSets Parts;
  std::vector<Point> Starts; // first point per column, and the end
  std::vector<std::int32_t> ColumnOf;
  std::vector<Contact> Touching;
  std::vector<std::vector<Point>> Above; // by part
};
}

//----------------------------------------------------------------------------------------------------------------------
ColumnSheets SplitIntoSheets(PlanePoints columns, const std::vector<double>& heights)
{
  SheetSplitter splitter(columns, heights);
  const std::vector<int> sheetOf = splitter.IsSingle() ? std::vector<int>(heights.size(), 0) : splitter.Split();
  const int last = sheetOf.empty() ? 0 : *std::max_element(sheetOf.begin(), sheetOf.end());
  ColumnSheets sheets;
  sheets.Points.resize(last + 1);
  for (std::size_t point = 0; point < sheetOf.size(); ++point)
  {
    if (sheetOf[point] < 0)
    {
      ++sheets.Dropped;
    }
    else
    {
      sheets.Points[sheetOf[point]].push_back(Point(point));
    }
  }
  return sheets;
}
}
