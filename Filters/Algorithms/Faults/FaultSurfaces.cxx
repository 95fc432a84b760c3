// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Sticks are grouped by the name of the fault.
// 2. SortAlongFault sorts sticks along the fault by nearest neighbours, then without crossings.
// 3. BuildSheet creates levels, interpolates sticks at these, and continues short sticks and ends.
// 4. SheetTracer follows lines down the sheet, half a column apart, to their passages through the horizon.

#include "FaultSurfaces.h"

#include "Common/Horizon/Median.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
using Place = Eigen::Vector3d;

/// Places are relative and at most 1 in size, so that differences are finite.
class LevelStick
{
public:
  std::vector<Place> Places;
  std::vector<double> Level;
  std::vector<SpacePoint> Given;

  Place Across() const { return this->Places.back() - this->Places.front(); }

  void Measure(const Place& direction)
  {
    if (this->Across().dot(direction) < 0.0)
    {
      std::reverse(this->Places.begin(), this->Places.end());
      std::reverse(this->Given.begin(), this->Given.end());
    }
    this->Level.clear();
    for (const Place& place : this->Places)
    {
      this->Level.push_back(place.dot(direction));
    }
    this->Top = *std::min_element(this->Level.begin(), this->Level.end());
    this->Bottom = *std::max_element(this->Level.begin(), this->Level.end());
  }

  double Least() const { return this->Top; }
  double Greatest() const { return this->Bottom; }

  /// Returns the first place at the level, or the nearest one.
  SpacePoint At(double level) const
  {
    const auto [segment, part] = this->Find(level);
    const SpacePoint& a = this->Given[segment];
    const SpacePoint& b = this->Given[std::min(segment + 1, this->Given.size() - 1)];
    return { Between(a.X, b.X, part), Between(a.Y, b.Y, part), Between(a.Z, b.Z, part) };
  }

  Place RelativeAt(double level) const
  {
    const auto [segment, part] = this->Find(level);
    const Place& next = this->Places[std::min(segment + 1, this->Places.size() - 1)];
    return this->Places[segment] + part * (next - this->Places[segment]);
  }

  /// Halves are added, as the difference may be infinite.
  static double Between(double from, double to, double part)
  {
    const double half = 0.5 * to - 0.5 * from;
    return from + part * half + part * half;
  }

private:
  std::pair<std::size_t, double> Find(double level) const
  {
    const double wanted = std::clamp(level, this->Top, this->Bottom);
    for (std::size_t n = 0; n + 1 < this->Level.size(); ++n)
    {
      const double from = this->Level[n];
      const double to = this->Level[n + 1];
      if (wanted >= std::min(from, to) && wanted <= std::max(from, to))
      {
        return { n, to == from ? 0.0 : (wanted - from) / (to - from) };
      }
    }
    return { 0, 0.0 };
  }

  double Top = 0.0;
  double Bottom = 0.0;
};

/// The distance is taken in the middle of the common levels, or between the nearest ends.
double Distance(const LevelStick& a, const LevelStick& b)
{
  const double least = std::max(a.Least(), b.Least());
  const double greatest = std::min(a.Greatest(), b.Greatest());
  const double middle = 0.5 * (least + greatest);
  return (a.RelativeAt(middle) - b.RelativeAt(middle)).norm();
}

// ---- Order ----------------------------------------------------------------------------------------------------------

using StickOrder = std::vector<std::size_t>;

/// Returns 0 beyond the ends.
double Way(const std::vector<LevelStick>& sticks, const StickOrder& order, std::ptrdiff_t from, std::ptrdiff_t to)
{
  const bool isInside = from >= 0 && to < std::ptrdiff_t(order.size());
  return isInside ? Distance(sticks[order[from]], sticks[order[to]]) : 0.0;
}

double LengthOf(const std::vector<LevelStick>& sticks, const StickOrder& order)
{
  double sum = 0.0;
  for (std::ptrdiff_t n = 1; n < std::ptrdiff_t(order.size()); ++n)
  {
    sum += Way(sticks, order, n - 1, n);
  }
  return sum;
}

/// Starts at the stick farthest from the first.
StickOrder OrderByNearest(const std::vector<LevelStick>& sticks)
{
  StickOrder rest(sticks.size());
  std::iota(rest.begin(), rest.end(), std::size_t(0));
  std::vector<double> ways;
  const auto measureFrom = [&](std::size_t stick)
  {
    ways.resize(rest.size());
    std::transform(
      rest.begin(), rest.end(), ways.begin(), [&](std::size_t n) { return Distance(sticks[stick], sticks[n]); });
  };
  measureFrom(0);
  auto next = std::max_element(ways.begin(), ways.end()) - ways.begin();
  StickOrder order;
  for (;;)
  {
    order.push_back(rest[next]);
    rest.erase(rest.begin() + next);
    if (rest.empty())
    {
      return order;
    }
    measureFrom(order.back());
    next = std::min_element(ways.begin(), ways.end()) - ways.begin();
  }
}

void Uncross(const std::vector<LevelStick>& sticks, StickOrder& order)
{
  constexpr std::size_t mostToUncross = 1000; // The cost is quadratic.
  constexpr int mostRounds = 20;
  const auto size = std::ptrdiff_t(order.size());
  bool isShorter = order.size() <= mostToUncross;
  for (int round = 0; isShorter && round < mostRounds; ++round)
  {
    isShorter = false;
    for (std::ptrdiff_t first = 0; first + 1 < size; ++first)
    {
      for (std::ptrdiff_t last = first + 1; last < size; ++last)
      {
        const double now = Way(sticks, order, first - 1, first) + Way(sticks, order, last, last + 1);
        const double then = Way(sticks, order, first - 1, last) + Way(sticks, order, first, last + 1);
        if (then < now * (1.0 - 1e-9))
        {
          std::reverse(order.begin() + first, order.begin() + last + 1);
          isShorter = true;
        }
      }
    }
  }
}

void SortAlongFault(std::vector<LevelStick>& sticks)
{
  StickOrder asGiven(sticks.size());
  std::iota(asGiven.begin(), asGiven.end(), std::size_t(0));
  StickOrder order = OrderByNearest(sticks);
  Uncross(sticks, order);
  Uncross(sticks, asGiven);
  if (!(LengthOf(sticks, order) < LengthOf(sticks, asGiven)))
  {
    order = asGiven;
  }
  const auto place = [&](std::size_t n)
  {
    const SpacePoint& at = sticks[n].Given.front();
    return std::make_tuple(at.X, at.Y, at.Z);
  };
  if (place(order.front()) < place(order.back())) // Both ways are as long; that of the file does not matter.
  {
    std::reverse(order.begin(), order.end());
  }
  std::vector<LevelStick> sorted;
  for (const std::size_t n : order)
  {
    sorted.push_back(std::move(sticks[n]));
  }
  sticks.swap(sorted);
}

// ---- Sheets ---------------------------------------------------------------------------------------------------------

// The unit is the height of the sheet.
constexpr double LevelStep = 0.01;

std::vector<double> ListLevels(const std::vector<LevelStick>& sticks)
{
  std::vector<double> all;
  for (const LevelStick& stick : sticks)
  {
    all.insert(all.end(), stick.Level.begin(), stick.Level.end());
  }
  std::sort(all.begin(), all.end());
  const double step = LevelStep * (all.back() - all.front());
  std::vector<double> levels;
  for (const double level : all)
  {
    if (levels.empty() || level > levels.back() + step)
    {
      levels.push_back(level);
    }
  }
  if (levels.size() > 1)
  {
    levels.back() = all.back();
  }
  return levels;
}

SpacePoint Continue(const SpacePoint& from, const SpacePoint& beyond)
{
  return { beyond.X + (beyond.X - from.X), beyond.Y + (beyond.Y - from.Y), beyond.Z + (beyond.Z - from.Z) };
}

/// A stick that ends short between two longer sticks is continued parallel to the line between them.
void ContinueShortSticks(const std::vector<LevelStick>& sticks, const std::vector<double>& levels, FaultSheet& sheet)
{
  for (std::size_t stick = 1; stick + 1 < sticks.size(); ++stick)
  {
    for (std::size_t level = 0; level < levels.size(); ++level)
    {
      const auto reaches = [&](const LevelStick& other)
      { return levels[level] >= other.Least() && levels[level] <= other.Greatest(); };
      if (sheet.Places[sheet.At(stick, level)] || !reaches(sticks[stick - 1]) || !reaches(sticks[stick + 1]))
      {
        continue;
      }
      const SpacePoint& before = *sheet.Places[sheet.At(stick - 1, level)];
      const SpacePoint& after = *sheet.Places[sheet.At(stick + 1, level)];
      const double end = std::clamp(levels[level], sticks[stick].Least(), sticks[stick].Greatest());
      const SpacePoint atEnd = sticks[stick].At(end);
      const SpacePoint beforeEnd = sticks[stick - 1].At(end);
      const SpacePoint afterEnd = sticks[stick + 1].At(end);
      const double toBefore = Distance(sticks[stick], sticks[stick - 1]);
      const double toAfter = Distance(sticks[stick], sticks[stick + 1]);
      const double part = toBefore + toAfter > 0.0 ? toBefore / (toBefore + toAfter) : 0.5;
      const auto continued = [part](double from, double to, double fromEnd, double toEnd, double place)
      { return place + (LevelStick::Between(from, to, part) - LevelStick::Between(fromEnd, toEnd, part)); };
      sheet.Places[sheet.At(stick, level)] = { continued(before.X, after.X, beforeEnd.X, afterEnd.X, atEnd.X),
        continued(before.Y, after.Y, beforeEnd.Y, afterEnd.Y, atEnd.Y),
        continued(before.Z, after.Z, beforeEnd.Z, afterEnd.Z, atEnd.Z) };
    }
  }
}

FaultSheet BuildSheet(const std::string& fault, const std::vector<LevelStick>& sticks, bool extend)
{
  const std::vector<double> levels = ListLevels(sticks);
  const double reach = LevelStep * (levels.back() - levels.front());
  FaultSheet sheet{ fault, sticks.size(), levels.size() };
  for (std::size_t stick = 0; stick < sticks.size(); ++stick)
  {
    for (std::size_t level = 0; level < levels.size(); ++level)
    {
      if (levels[level] >= sticks[stick].Least() - reach && levels[level] <= sticks[stick].Greatest() + reach)
      {
        sheet.Places[sheet.At(stick, level)] = sticks[stick].At(levels[level]);
      }
    }
  }
  ContinueShortSticks(sticks, levels, sheet);
  if (!extend)
  {
    return sheet;
  }
  FaultSheet extended{ fault, sticks.size() + 2, levels.size() };
  std::copy(sheet.Places.begin(), sheet.Places.end(), extended.Places.begin() + extended.At(1, 0));
  const std::size_t last = sticks.size() - 1;
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    for (const auto& [from, to, beyond] : { std::array<std::size_t, 3>{ 1, 0, 0 }, { last - 1, last, last + 2 } })
    {
      const std::optional<SpacePoint>& a = sheet.Places[sheet.At(from, level)];
      const std::optional<SpacePoint>& b = sheet.Places[sheet.At(to, level)];
      const SpacePoint place = a && b ? Continue(*a, *b) : SpacePoint();
      if (a && b && std::isfinite(place.X) && std::isfinite(place.Y) && std::isfinite(place.Z))
      {
        extended.Places[extended.At(beyond, level)] = place;
      }
    }
  }
  return extended;
}

void Prepare(std::vector<LevelStick>& sticks)
{
  Place origin(sticks[0].Given[0].X, sticks[0].Given[0].Y, sticks[0].Given[0].Z);
  double largest = origin.cwiseAbs().maxCoeff();
  for (const LevelStick& stick : sticks)
  {
    for (const SpacePoint& place : stick.Given)
    {
      largest = std::max({ largest, std::abs(place.X), std::abs(place.Y), std::abs(place.Z) });
    }
  }
  const double scale = largest > 0.0 ? 1.0 / largest : 1.0;
  const LevelStick* longest = nullptr;
  for (LevelStick& stick : sticks)
  {
    stick.Places.clear();
    for (const SpacePoint& place : stick.Given)
    {
      stick.Places.push_back(Place(place.X, place.Y, place.Z) * scale - origin * scale);
    }
    longest = !longest || stick.Across().norm() > longest->Across().norm() ? &stick : longest;
  }
  const Place guide = longest->Across();
  Place direction = Place::Zero();
  for (const LevelStick& stick : sticks)
  {
    const Place across = stick.Across();
    direction += across.dot(guide) < 0.0 ? -across : across;
  }
  const double length = direction.norm();
  direction = length > 0.0 ? Place(direction / length) : Place::UnitZ();
  // Downwards in the world, so that the ends at which sticks were begun do not matter.
  direction = direction.z() > 0.0 ? Place(-direction) : direction;
  for (LevelStick& stick : sticks)
  {
    stick.Measure(direction);
  }
}

/// Splits where neighbours are farther apart than the median by a factor.
std::vector<std::vector<LevelStick>> SplitAtJumps(std::vector<LevelStick> sticks)
{
  constexpr double largestWay = 5.0;
  std::vector<double> ways;
  for (std::size_t n = 0; n + 1 < sticks.size(); ++n)
  {
    ways.push_back(Distance(sticks[n], sticks[n + 1]));
  }
  std::vector<double> reordered = ways;
  const double largest = largestWay * UpperMedian(reordered);
  std::vector<std::vector<LevelStick>> parts(1);
  for (std::size_t n = 0; n < sticks.size(); ++n)
  {
    if (n > 0 && ways[n - 1] > largest)
    {
      parts.emplace_back();
    }
    parts.back().push_back(std::move(sticks[n]));
  }
  return parts;
}

double LengthAsGiven(const std::vector<LevelStick>& sticks)
{
  StickOrder order(sticks.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  return LengthOf(sticks, order);
}

/// Sticks without a name may be of several faults. Files list them fault by fault, so that their order counts unless
/// another one is far shorter; a tour of all sticks would cross from fault to fault in many places.
std::vector<std::vector<LevelStick>> SplitIntoFaults(std::vector<LevelStick> sticks)
{
  constexpr double farShorter = 0.5;
  std::vector<LevelStick> sorted = sticks;
  SortAlongFault(sorted);
  const bool isSorted = LengthAsGiven(sorted) < farShorter * LengthAsGiven(sticks);
  return SplitAtJumps(std::move(isSorted ? sorted : sticks));
}

// ---- Traces ---------------------------------------------------------------------------------------------------------

class SheetTracer
{
public:
  SheetTracer(const ColumnHeights& heights, const FaultSheet& sheet, std::vector<FaultPolyline>& traces)
    : Heights(heights)
    , Sheet(sheet)
    , Traces(traces)
  {
  }

  void Follow()
  {
    for (std::size_t stick = 0; stick + 1 < this->Sheet.Sticks; ++stick)
    {
      this->FollowStrip(stick);
    }
    this->End();
  }

private:
  static constexpr double LinesPerColumn = 2.0;
  // Passages of neighbouring lines must not be farther apart, in columns.
  static constexpr double LargestJump = 8.0;

  void FollowStrip(std::size_t stick)
  {
    std::vector<std::array<SpacePoint, 2>> rungs;
    double width = 0.0;
    const LinkGrid& grid = this->Heights.Grid();
    for (std::size_t level = 0; level < this->Sheet.Levels; ++level)
    {
      const std::optional<SpacePoint>& a = this->Sheet.Places[this->Sheet.At(stick, level)];
      const std::optional<SpacePoint>& b = this->Sheet.Places[this->Sheet.At(stick + 1, level)];
      if (a && b)
      {
        rungs.push_back({ *a, *b });
        width = std::max(width, std::hypot(b->X - a->X, b->Y - a->Y));
      }
    }
    if (rungs.size() < 2)
    {
      this->End();
      return;
    }
    const double most = 4.0 * double(grid.Width() + grid.Height());
    const auto lines = std::int64_t(std::ceil(std::clamp(LinesPerColumn * width, 1.0, most)));
    const double jump = LargestJump + 2.0 * width / double(lines);
    std::vector<SpacePoint> line(rungs.size());
    for (std::int64_t n = this->Trace.empty() ? 0 : 1; n <= lines; ++n)
    {
      const double part = double(n) / double(lines);
      for (std::size_t rung = 0; rung < rungs.size(); ++rung)
      {
        const auto& [a, b] = rungs[rung];
        line[rung] = { LevelStick::Between(a.X, b.X, part), LevelStick::Between(a.Y, b.Y, part),
          LevelStick::Between(a.Z, b.Z, part) };
      }
      this->Append(line, jump);
    }
  }

  /// A horizon that steps down a dipping fault without a break is passed three times: above, at the step, and below.
  /// The middle passage is chosen, or else the one nearest to the previous passage.
  void Append(const std::vector<SpacePoint>& line, double jump)
  {
    const std::vector<MapPlace> passages = FindPassages(this->Heights, line);
    const auto distance = [this](const MapPlace& place)
    { return this->Trace.empty() ? 0.0 : std::hypot(place.X - this->Trace.back().X, place.Y - this->Trace.back().Y); };
    if (passages.empty())
    {
      this->End();
      return;
    }
    MapPlace chosen = passages[passages.size() / 2];
    if (passages.size() % 2 == 0 || distance(chosen) > jump)
    {
      chosen = *std::min_element(passages.begin(), passages.end(),
        [&distance](const MapPlace& a, const MapPlace& b) { return distance(a) < distance(b); });
    }
    if (distance(chosen) > jump)
    {
      this->End();
    }
    this->Trace.push_back(chosen);
  }

  /// Sticks are picked on rows; a trace that ends on a row would leave the link there whole, hence half a column more.
  void End()
  {
    if (this->Trace.size() > 1)
    {
      const FaultPolyline ends = { Beyond(this->Trace[1], this->Trace[0]),
        Beyond(this->Trace[this->Trace.size() - 2], this->Trace.back()) };
      this->Trace.front() = ends[0];
      this->Trace.back() = ends[1];
      this->Traces.push_back(this->Trace);
    }
    this->Trace.clear();
  }

  static MapPlace Beyond(const MapPlace& from, const MapPlace& to)
  {
    const double length = std::hypot(to.X - from.X, to.Y - from.Y);
    const double part = length > 0.0 ? 0.5 / length : 0.0;
    return { to.X + part * (to.X - from.X), to.Y + part * (to.Y - from.Y) };
  }

  const ColumnHeights& Heights;
  const FaultSheet& Sheet;
  std::vector<FaultPolyline>& Traces;
  FaultPolyline Trace;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::array<std::size_t, 3>> FaultSheet::ListTriangles() const
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t stick = 0; stick + 1 < this->Sticks; ++stick)
  {
    for (std::size_t level = 0; level + 1 < this->Levels; ++level)
    {
      std::vector<std::size_t> corners;
      for (const std::size_t place : { this->At(stick, level), this->At(stick + 1, level),
             this->At(stick + 1, level + 1), this->At(stick, level + 1) })
      {
        if (this->Places[place])
        {
          corners.push_back(place);
        }
      }
      for (std::size_t n = 2; n < corners.size(); ++n)
      {
        triangles.push_back({ corners[0], corners[n - 1], corners[n] });
      }
    }
  }
  return triangles;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<FaultSheet> MakeFaultSheets(const std::vector<FaultStick>& sticks, bool extend)
{
  std::vector<std::pair<std::string, std::vector<LevelStick>>> faults;
  std::map<std::string, std::size_t> numbers;
  for (std::size_t n = 0; n < sticks.size(); ++n)
  {
    RequireFinite(sticks[n].Places, n);
    if (sticks[n].Places.size() < 2)
    {
      continue;
    }
    const auto place = numbers.emplace(sticks[n].Fault, faults.size());
    if (place.second)
    {
      faults.push_back({ sticks[n].Fault, {} });
    }
    LevelStick stick;
    stick.Given = sticks[n].Places;
    faults[place.first->second].second.push_back(std::move(stick));
  }
  std::vector<FaultSheet> sheets;
  for (auto& [name, ofFault] : faults)
  {
    if (ofFault.size() < 2)
    {
      continue;
    }
    Prepare(ofFault);
    std::vector<std::vector<LevelStick>> parts;
    if (name.empty())
    {
      parts = SplitIntoFaults(std::move(ofFault));
    }
    else
    {
      parts.push_back(std::move(ofFault));
    }
    for (std::vector<LevelStick>& part : parts)
    {
      if (part.size() > 1)
      {
        Prepare(part);
        SortAlongFault(part);
        sheets.push_back(BuildSheet(name, part, extend));
      }
    }
  }
  return sheets;
}

//----------------------------------------------------------------------------------------------------------------------
std::string NameOf(const std::vector<FaultSheet>& sheets, std::size_t n)
{
  return sheets[n].Fault.empty() ? "sticks " + std::to_string(n + 1) : sheets[n].Fault;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<FaultPolyline> FindTraces(const ColumnHeights& heights, const std::vector<FaultSheet>& sheets)
{
  std::vector<FaultPolyline> traces;
  for (const FaultSheet& sheet : sheets)
  {
    SheetTracer(heights, sheet, traces).Follow();
  }
  return traces;
}
}
