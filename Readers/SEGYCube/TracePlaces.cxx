// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TracePlaces.h"

#include "Common/Base/Errors.h"
#include "Common/Survey/PickTable.h"
#include "Common/Survey/SurveyMap.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t SampledPlaces = 1000;

/// Returns the traces with a place, or every n-th of them.
PickPlaces ListPlaces(
  const TraceTable& table, const LineNumbers& lines, const FieldPair& fields, std::int64_t stride = 1)
{
  PickPlaces picks;
  for (std::int64_t trace = 0; trace < table.Traces; trace += stride)
  {
    if (lines.IsUsed(trace) && HasPlace(table, fields, trace))
    {
      const Eigen::Vector2d place = TracePlace(table, fields, trace);
      picks.Inline.push_back(lines.Inline(trace));
      picks.Crossline.push_back(lines.Crossline(trace));
      picks.X.push_back(place.x());
      picks.Y.push_back(place.y());
    }
  }
  return picks;
}

std::string FieldsText(const FieldPair& fields)
{
  return "x and y of traces (bytes " + std::to_string(fields.First) + " and " + std::to_string(fields.Second) + ") ";
}

PlaceFit TryFields(const TraceTable& table, const LineNumbers& lines, const LineNumbering& numbering,
  const FieldPair& fields, double tolerance, const Monitor& monitor)
{
  if (AreFloats(table, lines, fields))
  {
    throw InputError(FieldsText(fields) + "have the bits of floats, expected integers");
  }
  const PickPlaces picks = ListPlaces(table, lines, fields);
  if (picks.X.empty())
  {
    throw InputError(FieldsText(fields) + "that are all 0, expected coordinates");
  }
  return FitLattice(picks, numbering, FieldsText(fields), tolerance, monitor);
}

/// Returns a warning if another pair of fields has another lattice.
std::string CompareFields(const TraceTable& table, const LineNumbers& lines, const LineNumbering& numbering,
  const PlacedTraces& placed, const FieldPair& other, double tolerance)
{
  if (AreSame(table, other) || AreLineNumbers(table, lines, other) || AreFloats(table, lines, other))
  {
    return {};
  }
  const PickPlaces picks = ListPlaces(table, lines, other, std::max<std::int64_t>(1, table.Traces / SampledPlaces));
  const double distance = picks.X.empty() ? 0.0 : LargestDistance(picks, numbering, placed.Fit.ToWorld);
  if (distance <= 1.0)
  {
    return {};
  }
  try
  {
    const PlaceFit fit = FitLattice(picks, numbering, FieldsText(other), tolerance, Monitor());
    const double scale = Scaled(1.0, table[TraceByte::PlaceScalar][0]);
    if (fit.Strays > 0 || FollowsLines(fit.ToWorld, numbering, scale))
    {
      return {};
    }
  }
  catch (const InputError&)
  {
    return {};
  }
  std::ostringstream text;
  text.precision(3);
  text << FieldsText(other) << "on another lattice, up to " << distance << " columns away from that at bytes "
       << placed.Fields.First << " and " << placed.Fields.Second
       << ", which is taken; set XByte and YByte for the other";
  return text.str();
}

std::int64_t TraceOfPlace(const TraceTable& table, const LineNumbers& lines, const FieldPair& fields, std::size_t place)
{
  std::int64_t trace = 0;
  for (std::size_t next = 0; trace < table.Traces; ++trace)
  {
    if (lines.IsUsed(trace) && HasPlace(table, fields, trace) && next++ == place)
    {
      break;
    }
  }
  return trace + 1;
}

void WarnOfStrays(PlacedTraces& placed, const TraceTable& table, const LineNumbers& lines)
{
  if (placed.Fit.Strays > 0)
  {
    std::ostringstream text;
    text << placed.Fit.Strays << " traces, the first of them "
         << TraceOfPlace(table, lines, placed.Fields, placed.Fit.FirstStray)
         << ", with x and y off the lattice of all others: put on it by their line numbers";
    placed.Warnings.push_back(text.str());
  }
}

std::vector<FieldPair> ListCandidates(const TraceTable& table, const FieldPair& given)
{
  if (given.First != 0)
  {
    return given.First > 0 ? std::vector<FieldPair>{ given } : std::vector<FieldPair>();
  }
  std::vector<FieldPair> candidates = ListPlaceFields();
  const auto areSame = [&](const FieldPair& fields) { return AreSame(table, fields); };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), areSame), candidates.end());
  return candidates;
}

PlacedTraces LinesForPlaces(const std::string& problems, const LineNumbering& numbering)
{
  PlacedTraces placed;
  if (!problems.empty())
  {
    placed.Warnings.push_back(problems + "; line numbers stand for x and y");
  }
  placed.Fields = { NoField, NoField };
  placed.Fit.ToWorld = LinesAsPlaces(numbering);
  return placed;
}

/// Uses fields that follow the line numbers, with a warning, for lack of better fields.
PlacedTraces UseDoubtful(PlacedTraces doubtful, bool areLineNumbers, const LineNumbering& numbering)
{
  if (areLineNumbers)
  {
    return LinesForPlaces(FieldsText(doubtful.Fields) + "that equal the line numbers, expected coordinates", numbering);
  }
  doubtful.Warnings.push_back(FieldsText(doubtful.Fields) +
    "with the steps of line numbers, expected coordinates; if they are lines as well, set XByte and YByte");
  return doubtful;
}
}

//----------------------------------------------------------------------------------------------------------------------
bool HasPlace(const TraceTable& table, const FieldPair& fields, std::int64_t trace)
{
  return table[fields.First][trace] != 0 || table[fields.Second][trace] != 0;
}

//----------------------------------------------------------------------------------------------------------------------
Eigen::Vector2d TracePlace(const TraceTable& table, const FieldPair& fields, std::int64_t trace)
{
  const int scalar = table[TraceByte::PlaceScalar][trace];
  return { Scaled(table[fields.First][trace], scalar), Scaled(table[fields.Second][trace], scalar) };
}

//----------------------------------------------------------------------------------------------------------------------
bool AreSame(const TraceTable& table, const FieldPair& fields)
{
  return table[fields.First].IsConstant() && table[fields.Second].IsConstant();
}

//----------------------------------------------------------------------------------------------------------------------
bool AreLineNumbers(const TraceTable& table, const LineNumbers& lines, const FieldPair& fields)
{
  const auto areAll = [&](auto&& same)
  {
    for (std::int64_t trace = 0; trace < table.Traces; ++trace)
    {
      if (lines.IsUsed(trace) && HasPlace(table, fields, trace) && !same(trace))
      {
        return false;
      }
    }
    return true;
  };
  const auto areThese = [&](double inlineNumber, double crossline, const Eigen::Vector2d& place)
  { return place == Eigen::Vector2d(inlineNumber, crossline) || place == Eigen::Vector2d(crossline, inlineNumber); };
  return areAll(
           [&](std::int64_t trace)
           {
             const Eigen::Vector2d stored(table[fields.First][trace], table[fields.Second][trace]);
             return areThese(lines.Inline(trace), lines.Crossline(trace), stored);
           }) ||
    areAll([&](std::int64_t trace)
      { return areThese(lines.Inline(trace), lines.Crossline(trace), TracePlace(table, fields, trace)); });
}

//----------------------------------------------------------------------------------------------------------------------
bool AreFloats(const TraceTable& table, const LineNumbers& lines, const FieldPair& fields)
{
  constexpr std::int32_t least = 0x3f800000; // 1 as an IEEE float.
  constexpr std::int32_t largest = 0x4cbebc20; // 1e8 as an IEEE float; IBM floats from 1 to 1e8 are in the same range.
  const auto isFloat = [&](std::int32_t bits) { return bits >= least && bits <= largest; };
  const std::int64_t stride = std::max<std::int64_t>(1, table.Traces / SampledPlaces);
  std::int64_t places = 0;
  for (std::int64_t trace = 0; trace < table.Traces; trace += stride)
  {
    if (lines.IsUsed(trace) && HasPlace(table, fields, trace))
    {
      ++places;
      if (!isFloat(table[fields.First][trace]) || !isFloat(table[fields.Second][trace]))
      {
        return false;
      }
    }
  }
  return places > 0;
}

//----------------------------------------------------------------------------------------------------------------------
PlacedTraces PlaceTraces(const TraceTable& table, const LineNumbers& lines, const LineNumbering& numbering,
  const SEGYOptions& options, bool isLine, const Monitor& monitor)
{
  const FieldPair given = options.PlaceFields;
  const bool isGiven = given.First > 0;
  std::optional<PlacedTraces> found, doubtful;
  std::string problems;
  for (const FieldPair& fields : ListCandidates(table, given))
  {
    if (found)
    {
      const std::string other = CompareFields(table, lines, numbering, *found, fields, options.Tolerance);
      found->Warnings.insert(found->Warnings.end(), other.empty() ? 0 : 1, other);
      continue;
    }
    try
    {
      PlacedTraces placed;
      placed.Fields = fields;
      placed.Fit = TryFields(table, lines, numbering, fields, options.Tolerance, monitor);
      WarnOfStrays(placed, table, lines);
      const double scale = Scaled(1.0, table[TraceByte::PlaceScalar][0]);
      const bool isDoubtful = !isGiven && FollowsLines(placed.Fit.ToWorld, numbering, scale);
      std::optional<PlacedTraces>& which = isDoubtful ? doubtful : found;
      which = which ? which : placed;
    }
    catch (const InputError& error)
    {
      if (isGiven && !isLine)
      {
        throw;
      }
      problems += (problems.empty() ? "" : "; ") + std::string(error.what());
    }
  }
  if (found || doubtful)
  {
    return found ? *found : UseDoubtful(*doubtful, AreLineNumbers(table, lines, doubtful->Fields), numbering);
  }
  return LinesForPlaces(problems, numbering);
}
}
