// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TracePlaces.h"

#include "Common/Base/Errors.h"
#include "Common/Survey/LatticeSearch.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
// In order of preference; the first pair is the standard since revision 1.
constexpr std::array<FieldPair, 7> UsualPairs = { { { 189, 193 }, { 9, 21 }, { 5, 21 }, { 9, 13 }, { 17, 13 },
  { 221, 225 }, { 181, 185 } } };
// Byte 21 is the number of the common depth point, 17 of the shot point.
constexpr std::array<FieldPair, 3> LinePairs = { { { 189, 193 }, { 9, 21 }, { 9, 17 } } };

constexpr double LeastDensity = 0.1;
constexpr double DensityMargin = 0.15;
// Fraction of the traces that may share a bin with another trace.
constexpr double FewRepeated = 0.05;
constexpr double MostRepeated = 0.5;
constexpr std::int64_t LargestFieldNumber = 99999; // x and y may have the same fields.

/// Step is the greatest common divisor of all differences.
struct FieldRange
{
  std::int64_t First = std::numeric_limits<std::int64_t>::max();
  std::int64_t Last = std::numeric_limits<std::int64_t>::min();
  std::int64_t Step = 0;
  std::int64_t Previous = 0;

  void Add(std::int64_t number)
  {
    if (this->First > this->Last)
    {
      this->First = this->Last = this->Previous = number;
      return;
    }
    const std::int64_t difference = number - this->Previous;
    if (difference != 0 && (this->Step == 0 || difference % this->Step != 0))
    {
      this->Step = std::gcd(this->Step, difference);
    }
    this->Previous = number;
    this->First = std::min(this->First, number);
    this->Last = std::max(this->Last, number);
  }

  bool IsConstant() const { return this->Step == 0; }
  std::int64_t Slots() const { return this->IsConstant() ? 1 : (this->Last - this->First) / this->Step + 1; }
  std::size_t Slot(std::int64_t number) const
  {
    return this->IsConstant() ? 0 : std::size_t((number - this->First) / this->Step);
  }
};

class PairFigures
{
public:
  PairFigures(const TraceTable& table, const FieldPair& pair)
    : Table(table)
    , Pair(pair)
  {
    this->ForEachTrace(
      [this](std::int64_t first, std::int64_t second)
      {
        this->Ranges[0].Add(first);
        this->Ranges[1].Add(second);
        ++this->Traces;
      });
  }

  double Density() const
  {
    return double(this->Traces) / (double(this->Ranges[0].Slots()) * double(this->Ranges[1].Slots()));
  }

  bool IsConstant(int which) const { return this->Ranges[which].IsConstant(); }
  std::int64_t Slots(int which) const { return this->Ranges[which].Slots(); }

  std::int64_t CountRepeated() const
  {
    std::vector<bool> isTaken(std::size_t(this->Ranges[0].Slots() * this->Ranges[1].Slots()), false);
    const auto width = std::size_t(this->Ranges[1].Slots());
    std::int64_t repeated = 0;
    this->ForEachTrace(
      [&](std::int64_t first, std::int64_t second)
      {
        std::vector<bool>::reference place =
          isTaken[this->Ranges[0].Slot(first) * width + this->Ranges[1].Slot(second)];
        repeated += place;
        place = true;
      });
    return repeated;
  }

  std::int64_t Largest() const
  {
    const auto largest = [](const FieldRange& r) { return std::max(std::abs(r.First), std::abs(r.Last)); };
    return std::max(largest(this->Ranges[0]), largest(this->Ranges[1]));
  }

  bool HaveRepetitions() const { return this->Repeats(0) && this->Repeats(1); }

  /// Accepts grids, and lines, for which one field is constant. Any file may have one repeated trace.
  bool IsFull(double mostRepeated) const
  {
    return this->Traces > 0 && this->Density() >= LeastDensity &&
      double(this->CountRepeated()) <= std::max(mostRepeated * double(this->Traces), this->Traces > 2 ? 1.0 : 0.0);
  }

  bool IsGrid(double mostRepeated) const
  {
    return !this->IsConstant(0) && !this->IsConstant(1) && this->IsFull(mostRepeated) && this->HaveRepetitions();
  }

private:
  template <typename Visit>
  void ForEachTrace(Visit&& visit) const
  {
    const TraceField& first = this->Table[this->Pair.First];
    const TraceField& second = this->Table[this->Pair.Second];
    for (std::int64_t trace = 0; trace < this->Table.Traces; ++trace)
    {
      if (!IsFiller(this->Table, this->Pair, trace))
      {
        visit(first[trace], second[trace]);
      }
    }
  }

  bool Repeats(int which) const
  {
    if (this->Slots(which) < this->Traces)
    {
      return true;
    }
    std::vector<bool> isTaken(std::size_t(this->Slots(which)), false);
    bool repeats = false;
    this->ForEachTrace(
      [&](std::int64_t first, std::int64_t second)
      {
        std::vector<bool>::reference place = isTaken[this->Ranges[which].Slot(which == 0 ? first : second)];
        repeats = repeats || place;
        place = true;
      });
    return repeats;
  }

  const TraceTable& Table;
  const FieldPair Pair;
  std::array<FieldRange, 2> Ranges;
  std::int64_t Traces = 0;
};

std::optional<FieldPair> FindGrid(const TraceTable& table, double mostRepeated, const Monitor& monitor)
{
  std::optional<FieldPair> found;
  std::vector<double> densities; // 0 for pairs that form no grid.
  for (const FieldPair& pair : UsualPairs)
  {
    monitor.Progress(double(densities.size()) / double(UsualPairs.size()));
    densities.push_back(0.0);
    if (table[pair.First].IsConstant() || table[pair.Second].IsConstant())
    {
      continue;
    }
    const PairFigures figures(table, pair);
    const bool isGrid = figures.IsGrid(mostRepeated) && (!IsPlacePair(pair) || figures.Largest() <= LargestFieldNumber);
    densities.back() = isGrid ? figures.Density() : 0.0;
  }
  const double densest = *std::max_element(densities.begin(), densities.end());
  for (std::size_t n = 0; n < densities.size() && !found; ++n)
  {
    if (densities[n] > 0.0 && densities[n] >= densest - DensityMargin)
    {
      found = UsualPairs[n];
    }
  }
  return found;
}

/// If both numbers of the standard vary without a grid, other fields do not help.
std::optional<FieldPair> FindLine(const TraceTable& table, double mostRepeated)
{
  for (const FieldPair& pair : LinePairs)
  {
    const bool isFirstConstant = table[pair.First].IsConstant();
    const bool isSecondConstant = table[pair.Second].IsConstant();
    if (!isFirstConstant && !isSecondConstant && pair.First == UsualPairs[0].First)
    {
      return std::nullopt;
    }
    if ((isFirstConstant || isSecondConstant) && PairFigures(table, pair).IsFull(mostRepeated))
    {
      return pair;
    }
  }
  return std::nullopt;
}

/// Shots and channels of gathers would form a grid, too.
void RefuseGathers(const TraceTable& table)
{
  const TraceField& offsets = table[TraceByte::Offset];
  std::int64_t first = 0;
  for (std::int64_t trace = 0; trace < table.Traces && !offsets.IsConstant(); ++trace)
  {
    first = table.IsDead(first) ? trace : first;
    if (offsets[trace] != offsets[first] && !table.IsDead(trace))
    {
      std::ostringstream text;
      text << "offset " << offsets[first] << " of trace " << first + 1 << " and " << offsets[trace] << " of trace "
           << trace + 1
           << " (byte 37), as in pre-stack data; expected one trace for each inline and crossline. If the "
              "file is post-stack, set InlineByte and CrosslineByte";
      throw InputError(text.str());
    }
  }
}

/// Numbers the indices of places along i or j, from 1. Returns 0 for fillers.
TraceField NumberIndices(const TraceTable& table, const FieldPair& fields, const PlaneMap& map, int axis)
{
  constexpr double largest = 1e9; // No grid is as large.
  const Eigen::Matrix2d toColumns = map.Steps.inverse();
  const auto isFiller = [&](std::int64_t trace) { return IsFiller(table, fields, trace); };
  const auto index = [&](std::int64_t trace)
  { return std::round((toColumns * (TracePlace(table, fields, trace) - map.Origin))[axis]); };
  double first = largest;
  for (std::int64_t trace = 0; trace < table.Traces; ++trace)
  {
    first = isFiller(trace) ? first : std::min(first, index(trace));
  }
  TraceField field(table.Traces);
  RawVector<std::int32_t> part;
  for (std::int64_t trace = 0; trace < table.Traces; ++trace)
  {
    part.push_back(isFiller(trace) ? 0 : std::int32_t(std::min(largest, index(trace) - first + 1.0)));
    if (trace + 1 == table.Traces || (trace + 1) % TraceField::PartSize == 0)
    {
      field.SetPart(std::size_t(trace / TraceField::PartSize), part);
      part.clear();
    }
  }
  return field;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<int> ListFields()
{
  std::vector<int> bytes;
  const auto add = [&bytes](const FieldPair& pair) { bytes.insert(bytes.end(), { pair.First, pair.Second }); };
  std::for_each(UsualPairs.begin(), UsualPairs.end(), add);
  std::for_each(LinePairs.begin(), LinePairs.end(), add);
  std::for_each(PlacePairs.begin(), PlacePairs.end(), add);
  return bytes;
}

//----------------------------------------------------------------------------------------------------------------------
bool IsFiller(const TraceTable& table, const FieldPair& lines, std::int64_t trace)
{
  const auto isZero = [&](int byte) { return byte == NoField || table[byte][trace] == 0; };
  return table.IsDead(trace) && isZero(lines.First) && isZero(lines.Second);
}

//----------------------------------------------------------------------------------------------------------------------
bool IsPlacePair(const FieldPair& pair)
{
  return std::any_of(PlacePairs.begin(), PlacePairs.end(), [&](const FieldPair& p) { return p.First == pair.First; });
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<FieldPair> FindAnyGrid(const TraceTable& table)
{
  std::vector<int> candidates;
  for (const auto& [byte, field] : table.Fields)
  {
    if (!field.IsConstant() && !IsPlacePair({ byte, 0 }) && !IsPlacePair({ byte - 4, 0 }))
    {
      candidates.push_back(byte);
    }
  }
  for (const int first : candidates)
  {
    for (const int second : candidates)
    {
      if (second > first && PairFigures(table, { first, second }).IsGrid(FewRepeated))
      {
        return FieldPair{ first, second };
      }
    }
  }
  return std::nullopt;
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<FieldPair> FindLineFields(const TraceTable& table, bool mayRepeat, const Monitor& monitor)
{
  const double mostRepeated = mayRepeat ? MostRepeated : FewRepeated;
  RefuseGathers(table);
  const std::optional<FieldPair> grid = FindGrid(table, mostRepeated, monitor);
  return grid ? grid : FindLine(table, mostRepeated);
}

//----------------------------------------------------------------------------------------------------------------------
bool NumberByPlaces(TraceTable& table, const SEGYOptions& options, const Monitor& monitor)
{
  for (const FieldPair& fields : ListPlaceFields(table, options.PlaceFields))
  {
    std::vector<double> x, y;
    for (std::int64_t trace = 0; trace < table.Traces; ++trace)
    {
      const Eigen::Vector2d place = TracePlace(table, fields, trace);
      x.insert(x.end(), IsFiller(table, fields, trace) ? 0 : 1, place.x());
      y.insert(y.end(), IsFiller(table, fields, trace) ? 0 : 1, place.y());
    }
    try
    {
      const PlaneMap map = FindLattice(x, y, monitor);
      const FieldPair lines = { TraceByte::LatticeRow, TraceByte::LatticeColumn };
      table.Fields[lines.First] = NumberIndices(table, fields, map, 1);
      table.Fields[lines.Second] = NumberIndices(table, fields, map, 0);
      if (PairFigures(table, lines).IsGrid(options.Duplicates != DuplicateRule::Refuse ? MostRepeated : FewRepeated))
      {
        return true;
      }
    }
    catch (const InputError&)
    {
      continue; // The lines that are missing are the error.
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
std::string OtherLinesText(const std::optional<FieldPair>& other)
{
  std::string text = "Where line numbers are elsewhere, set InlineByte and CrosslineByte";
  if (other)
  {
    text += "; bytes " + std::to_string(other->First) + " and " + std::to_string(other->Second) + " make a grid";
  }
  return text;
}

//----------------------------------------------------------------------------------------------------------------------
void RefuseLines(const TraceTable& table, const std::optional<FieldPair>& other)
{
  std::ostringstream text;
  text << "no line numbers that make a grid of " << table.Traces << " traces";
  for (const FieldPair& pair : UsualPairs)
  {
    const PairFigures figures(table, pair);
    if (!figures.IsConstant(0) || !figures.IsConstant(1))
    {
      text << (text.str().find(':') == std::string::npos ? ": bytes " : ", bytes ") << pair.First << " and "
           << pair.Second << " span " << figures.Slots(0) << " x " << figures.Slots(1)
           << (figures.Density() >= LeastDensity && figures.CountRepeated() > 0 ? " with several traces at one position"
                                                                                : "")
           << (IsPlacePair(pair) && figures.Largest() > LargestFieldNumber ? " with numbers above 99999, as in coordinates"
                                                                           : "");
    }
  }
  text << "; expected one trace for each inline and crossline, and at least a tenth of the grid. To allow several "
          "traces at one position, set DuplicatePolicy. "
       << OtherLinesText(other);
  throw InputError(text.str());
}
}
