// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnGuess.h"

#include "Common/Lattice.h"
#include "Common/LineErrors.h"
#include "Common/Survey/PlaneFit.h"
#include "Common/Survey/Units.h"
#include "Common/TextFields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
// Whole numbers up to here may be line numbers; coordinates of surveys are larger.
constexpr double LargestLineNumber = 99999.0;
constexpr double LeastCoordinate = 1e4;
constexpr double LargestPlace = 1e9; // on Earth, in any unit of length; beyond are no places, but whatever z may be
// How far places may be off those that line numbers give, as a part of a step: they are rounded, but to less than that.
constexpr double LargestMisfit = 0.1;
// Places that are wrong in part, bent or noisy follow lines as roughly as this.
constexpr double RoughlyOff = 0.15;
constexpr double LeastSine = 0.3;
// The same as a part of the extent of the sample, where that is more.
constexpr double LargestPartOff = 0.02;

/// How many of some lines tell what they all are: of a few all, of more nine of ten.
std::size_t MostOf(std::size_t lines)
{
  return lines - lines / 10;
}

/// Whether a line has so many fields. The last one may be empty behind a separator at the end.
bool HasFields(std::string_view line, FieldSeparator separator, std::size_t count)
{
  std::size_t fields = 0;
  FieldCursor cursor(line, separator);
  for (std::string_view field; cursor.Next(field);)
  {
    ++fields;
  }
  return fields == count || (fields + 1 == count && cursor.EndsInSeparator());
}

/// The first column of text that is left out has the names of horizons, where no other one has.
void NameByText(std::vector<TextColumn>& columns, const TextLines& sample, const TextLayout& layout)
{
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    if (columns[column].Role == ColumnRole::HorizonName)
    {
      return;
    }
  }
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    const ColumnValues values = LookAt(sample, layout, column);
    if (columns[column].Role == ColumnRole::Ignored && values.AreText && values.AreNames && !values.AreAllDifferent)
    {
      columns[column] = { ColumnRole::HorizonName, "Name" };
      return;
    }
  }
}

/// The largest size of the numbers in a column.
double LargestOf(const TextLines& sample, const TextLayout& layout, std::size_t column)
{
  double largest = 0.0;
  for (const std::string_view line : sample)
  {
    const Fields fields = Split(line, layout.Separator);
    double value = 0.0;
    if (column < fields.size() && ReadNumber(fields[column], value) == NumberKind::Finite &&
      !layout.Nulls.IsNullNumber(value))
    {
      largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

/// How two columns belong to two others.
struct PairFit
{
  bool AreTelling = false; // enough lines, not all on one inline
  bool AreAffine = false; // an affine map leads from the first pair to the second
  bool AreMostlyAffine = false; // of most, roughly: what is wrong with others nobody can tell
  bool AreLarger = false; // steps of the second pair are longer than those of the first
  bool AreCoordinates = true; // all numbers of the second pair are as large as coordinates mostly are
};

/// The numbers of two columns, and those of two others in the same line.
struct Pair
{
  Eigen::Vector2d Index, Place;
};

/// The pairs of the lines that have all four numbers; nothing where most do not.
std::vector<Pair> ReadPairs(const TextLines& sample, const TextLayout& layout, std::size_t from, std::size_t to)
{
  std::vector<Pair> pairs;
  for (const std::string_view line : sample)
  {
    const Fields fields = Split(line, layout.Separator);
    std::array<double, 4> values = {};
    bool areNumbers = true;
    for (const std::size_t n : { 0, 1, 2, 3 })
    {
      const std::size_t column = n < 2 ? from + n : to + n - 2;
      areNumbers = areNumbers && column < fields.size() &&
        ReadNumber(fields[column], values[n]) == NumberKind::Finite && std::abs(values[n]) < LargestPlace;
    }
    if (areNumbers)
    {
      pairs.push_back({ { values[0], values[1] }, { values[2], values[3] } });
    }
  }
  return pairs.size() >= MostOf(sample.size()) ? pairs : std::vector<Pair>();
}

/// How far each pair is off a map, and the map of all but those that are off most: a few lines may be wrong.
struct TrimmedFit
{
  std::optional<PlaneMap> Map; // of differences from the first pair
  std::vector<double> Off; // ascending
  Eigen::Vector2d Extent = Eigen::Vector2d::Zero(); // of the places that count

  /// Of pairs in the order of how likely they are right.
  explicit TrimmedFit(std::vector<Pair> pairs)
  {
    for (int round = 0; round < 2; ++round)
    {
      this->Extent.setZero();
      for (std::size_t n = 0; n < MostOf(pairs.size()); ++n)
      {
        this->Extent = this->Extent.cwiseMax((pairs[n].Place - pairs.front().Place).cwiseAbs());
      }
      this->Map = Sort(pairs, MostOf(pairs.size()), &Pair::Index, &Pair::Place, this->Off);
      if (!this->Map)
      {
        return;
      }
    }
  }

  /// Fits a map to the first pairs, and sorts all by how far they are off it. Nothing where there is none.
  static std::optional<PlaneMap> Sort(std::vector<Pair>& pairs, std::size_t counting, Eigen::Vector2d Pair::*from,
    Eigen::Vector2d Pair::*to, std::vector<double>& sorted)
  {
    const Pair first = pairs.empty() ? Pair() : pairs.front();
    PlaneFit fit;
    for (std::size_t n = 0; n < counting; ++n)
    {
      fit.Add(pairs[n].*from - first.*from, pairs[n].*to - first.*to);
    }
    const std::optional<PlaneMap> map = fit.Solve();
    if (map)
    {
      const auto off = [&](const Pair& pair)
      { return (pair.*to - first.*to - map->Origin - map->Steps * (pair.*from - first.*from)).norm(); };
      std::stable_sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) { return off(a) < off(b); });
      sorted.clear();
      std::transform(pairs.begin(), pairs.end(), std::back_inserter(sorted), off);
    }
    return map;
  }
};

/// A number far from all others bends the map so that it is hardly off, but only that map which leads from it: of both
/// ways the one counts that is better in the end.
TrimmedFit FitMost(const std::vector<Pair>& pairs)
{
  std::vector<Pair> forward = pairs;
  std::vector<Pair> backward = pairs;
  std::vector<double> off;
  TrimmedFit::Sort(forward, pairs.size(), &Pair::Index, &Pair::Place, off);
  TrimmedFit::Sort(backward, pairs.size(), &Pair::Place, &Pair::Index, off);
  const TrimmedFit a(std::move(forward));
  const TrimmedFit b(std::move(backward));
  const std::size_t last = MostOf(pairs.size()) - 1;
  return a.Map && (!b.Map || a.Off[last] <= b.Off[last]) ? a : b;
}

/// Places are rounded, or off the lines by some noise, but they lie far apart: what is off counts beside their extent.
/// Where lines are of three dimensions anything but a place has no such map.
PairFit FitPairs(const TextLines& sample, const TextLayout& layout, std::size_t from, std::size_t to)
{
  const std::vector<Pair> pairs = ReadPairs(sample, layout, from, to);
  PairFit result;
  result.AreCoordinates = !pairs.empty() &&
    std::all_of(
      pairs.begin(), pairs.end(), [](const Pair& pair) { return pair.Place.cwiseAbs().minCoeff() > LeastCoordinate; });
  const TrimmedFit fit = FitMost(pairs);
  const std::optional<PlaneMap>& map = fit.Map;
  constexpr std::size_t fewest = 4; // three make a map whatever they are
  result.AreTelling = map && pairs.size() >= fewest;
  // As with a plane z and a constant attribute, steps may be parallel.
  if (!result.AreTelling || AreParallel(map->Steps.col(0), map->Steps.col(1)))
  {
    return result;
  }
  const double step = map->Steps.colwise().norm().minCoeff();
  const double most = std::max(LargestMisfit * step, LargestPartOff * fit.Extent.minCoeff());
  result.AreLarger = std::abs(map->Steps.determinant()) >= 0.999; // rounded
  result.AreAffine = fit.Off[MostOf(pairs.size()) - 1] <= most;
  // Steps of a slope and of what goes with it are nearly parallel.
  const double sine = std::abs(map->Steps.determinant()) / (map->Steps.col(0).norm() * map->Steps.col(1).norm());
  result.AreMostlyAffine = sine > LeastSine && fit.Off[pairs.size() * 3 / 4] <= RoughlyOff * fit.Extent.minCoeff();
  return result;
}

/// Line numbers whose places are partly wrong, bent or noisy are neither reading.
[[noreturn]] void RefuseDoubt(std::size_t lines, std::size_t places)
{
  throw InputError("columns " + std::to_string(lines + 1) + " and " + std::to_string(lines + 2) +
    " that look like line numbers, and columns " + std::to_string(places + 1) + " and " + std::to_string(places + 2) +
    " that may be their places but do not follow them, expected places that do or other numbers: name the columns in "
    "Columns, such as Inline, "
    "Crossline, X, Y, Z");
}

/// Whether columns hold line numbers and the places that belong to them, in this order. Where the lines have too few
/// numbers to tell, coordinates are taken for what they mostly are: large.
bool AreLinesAndPlaces(const TextLines& sample, const TextLayout& layout, std::size_t lines, std::size_t places)
{
  const PairFit fit = FitPairs(sample, layout, lines, places);
  if (fit.AreTelling)
  {
    const bool areLines = LookAt(sample, layout, lines).AreLines && LookAt(sample, layout, lines + 1).AreLines;
    if (!fit.AreAffine && ((fit.AreMostlyAffine && fit.AreLarger) || (fit.AreCoordinates && areLines)))
    {
      RefuseDoubt(lines, places);
    }
    return fit.AreAffine && fit.AreLarger;
  }
  return fit.AreCoordinates && LookAt(sample, layout, lines).AreLines && LookAt(sample, layout, lines + 1).AreLines;
}

/// What neither reading explains is refused: coordinates would become z.
void RefuseLargeZ(const TextLines& sample, const TextLayout& layout, const std::vector<TextColumn>& columns)
{
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    const double largest = columns[column].Role == ColumnRole::Z ? LargestOf(sample, layout, column) : 0.0;
    if (largest > LargestLineNumber && largest < LargestPlace)
    {
      std::ostringstream text;
      text.precision(12);
      text << "column " << column + 1 << " with numbers up to " << largest << ", expected Z of at most "
           << LargestLineNumber << ": name the columns in Columns, such as Inline, Crossline, X, Y, Z";
      throw InputError(text.str());
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
Fields Split(std::string_view line, FieldSeparator separator)
{
  Fields fields;
  FieldCursor cursor(line, separator);
  std::string_view field;
  while (cursor.Next(field))
  {
    fields.push_back(field);
  }
  return fields;
}

//----------------------------------------------------------------------------------------------------------------------
bool HaveFields(const TextLines& sample, FieldSeparator separator, std::size_t count)
{
  return std::all_of(sample.begin(), sample.end(),
    [separator, count](std::string_view line) { return HasFields(line, separator, count); });
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t CountFields(const TextLines& sample, FieldSeparator separator)
{
  const std::size_t fields = Split(sample.front(), separator).size();
  const bool hasMore = HasFields(sample.front(), separator, fields + 1) &&
    std::any_of(sample.begin(), sample.end(),
      [separator, fields](std::string_view line) { return Split(line, separator).size() == fields + 1; });
  return hasMore ? fields + 1 : fields;
}

//----------------------------------------------------------------------------------------------------------------------
ColumnValues LookAt(const TextLines& sample, const TextLayout& layout, std::size_t column)
{
  ColumnValues values;
  bool hasNumbers = false;
  bool areWhole = true;
  bool areUnits = true;
  std::size_t lines = 0;
  std::set<std::string_view> different;
  for (const std::string_view line : sample)
  {
    const Fields fields = Split(line, layout.Separator);
    double value = 0.0;
    if (column >= fields.size())
    {
      continue; // reading the line will say so
    }
    const bool isNumber = ReadNumber(fields[column], value) != NumberKind::NotANumber;
    hasNumbers = hasNumbers || isNumber;
    areWhole = areWhole && (!isNumber || value == std::round(value));
    const std::string unit = ShortUnit(fields[column]);
    areUnits = areUnits && (unit == "m" || unit == "ft" || unit == "ms" || unit == "s");
    different.insert(fields[column]);
    values.AreText = values.AreText || !(isNumber || layout.Nulls.IsNullText(fields[column]));
    lines += isNumber && value == std::round(value) && value >= 0.0 && value <= LargestLineNumber ? 1 : 0;
  }
  values.AreLines = lines >= MostOf(sample.size());
  values.AreText = values.AreText && !hasNumbers; // else reading the line of the text will say so
  constexpr std::size_t few = 20;
  values.AreNames = !areUnits && areWhole && (!hasNumbers || different.size() <= few);
  values.AreAllDifferent = sample.size() > few && different.size() == sample.size();
  return values;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TextColumn> GuessColumns(const TextLines& sample, const TextLayout& layout)
{
  const std::size_t count = CountFields(sample, layout.Separator);
  std::vector<TextColumn> columns;
  std::size_t first = 0;
  if (count > 0 && LookAt(sample, layout, 0).AreText)
  {
    const bool areIds = LookAt(sample, layout, 0).AreAllDifferent;
    columns.push_back({ areIds ? ColumnRole::Ignored : ColumnRole::HorizonName, areIds ? "-" : "Name" });
    first = 1;
  }
  const auto areLines = [&](std::size_t column)
  { return LookAt(sample, layout, first + column).AreLines && LookAt(sample, layout, first + column + 1).AreLines; };
  const auto areBoth = [&](std::size_t lines, std::size_t places)
  { return count >= first + 5 && AreLinesAndPlaces(sample, layout, first + lines, first + places); };
  using Role = ColumnRole;
  std::vector<Role> roles = { Role::X, Role::Y, Role::Z };
  if (areBoth(0, 2))
  {
    roles = { Role::Inline, Role::Crossline, Role::X, Role::Y, Role::Z };
  }
  else if (areBoth(2, 0))
  {
    roles = { Role::X, Role::Y, Role::Inline, Role::Crossline, Role::Z };
  }
  else if (areLines(0))
  {
    roles = { Role::Inline, Role::Crossline, Role::Z };
  }
  for (std::size_t column = 0; first + column < count; ++column)
  {
    const Role role = column < roles.size() ? roles[column] : Role::Attribute;
    const bool isText = LookAt(sample, layout, first + column).AreText;
    columns.push_back({ isText ? Role::Ignored : role,
      role == Role::Attribute ? "Attribute " + std::to_string(column - roles.size() + 1) : RoleWord(role) });
  }
  NameByText(columns, sample, layout);
  RefuseLargeZ(sample, layout, columns);
  return columns;
}
}
