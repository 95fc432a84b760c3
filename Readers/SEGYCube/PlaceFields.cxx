// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TracePlaces.h"

#include "Common/Base/Errors.h"
#include "Common/Survey/LatticeSearch.h"
#include "Common/Survey/PickTable.h"

#include <Eigen/LU>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

namespace SeismicHorizons
{
namespace
{
/// Returns x and y of all traces but dead ones without, or nothing.
std::optional<PickPlaces> ListAllPlaces(const TraceTable& table, const FieldPair& fields)
{
  PickPlaces places;
  for (std::int64_t trace = 0; trace < table.Traces; ++trace)
  {
    if (!IsFiller(table, fields, trace))
    {
      const Eigen::Vector2d place = TracePlace(table, fields, trace);
      places.X.push_back(place.x());
      places.Y.push_back(place.y());
      if (place == Eigen::Vector2d::Zero())
      {
        return std::nullopt;
      }
    }
  }
  return places;
}

/// Returns the indices of places on their lattice, from 1.
std::vector<Eigen::Vector2d> FindIndices(const PickPlaces& places, const Monitor& monitor)
{
  const PlaneMap map = FindLattice(places.X, places.Y, monitor);
  const Eigen::Matrix2d toColumns = map.Steps.inverse();
  std::vector<Eigen::Vector2d> indices;
  Eigen::Vector2d first = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  for (std::size_t trace = 0; trace < places.X.size(); ++trace)
  {
    const Eigen::Vector2d index = toColumns * (Eigen::Vector2d(places.X[trace], places.Y[trace]) - map.Origin);
    indices.emplace_back(index.array().round());
    first = first.cwiseMin(indices.back());
  }
  for (Eigen::Vector2d& index : indices)
  {
    index -= first - Eigen::Vector2d::Ones();
  }
  return indices;
}

/// A component of the indices as a field of a table.
TraceField MakeNumbers(
  const TraceTable& table, const FieldPair& fields, const std::vector<Eigen::Vector2d>& indices, int component)
{
  constexpr double largest = 1e9; // No grid is as large.
  TraceField field(table.Traces);
  std::size_t next = 0;
  RawVector<std::int32_t> part;
  for (std::int64_t trace = 0; trace < table.Traces; ++trace)
  {
    part.push_back(IsFiller(table, fields, trace) ? 0 : std::int32_t(std::min(largest, indices[next++][component])));
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
std::vector<FieldPair> ListPlaceFields(const TraceTable& table, const FieldPair& given)
{
  if (given.First != 0)
  {
    return given.First > 0 ? std::vector<FieldPair>{ given } : std::vector<FieldPair>();
  }
  std::vector<FieldPair> candidates;
  std::copy_if(PlacePairs.begin(), PlacePairs.end(), std::back_inserter(candidates),
    [&](const FieldPair& fields) { return !AreSame(table, fields); });
  return candidates;
}

//----------------------------------------------------------------------------------------------------------------------
bool AreSame(const TraceTable& table, const FieldPair& fields)
{
  return table[fields.First].IsConstant() && table[fields.Second].IsConstant();
}

//----------------------------------------------------------------------------------------------------------------------
bool AreLineNumbers(const LineNumbers& lines, const FieldPair& fields)
{
  const auto areAll = [&](auto&& placeOf)
  {
    for (std::int64_t trace = 0; trace < lines.Table.Traces; ++trace)
    {
      const Eigen::Vector2d numbers(lines.Inline(trace), lines.Crossline(trace));
      if (HasPlace(lines, fields, trace) && placeOf(trace) != numbers && placeOf(trace) != numbers.reverse())
      {
        return false;
      }
    }
    return true;
  };
  const auto stored = [&](std::int64_t trace)
  { return Eigen::Vector2d(lines.Table[fields.First][trace], lines.Table[fields.Second][trace]); };
  return areAll(stored) || areAll([&](std::int64_t trace) { return TracePlace(lines.Table, fields, trace); });
}

//----------------------------------------------------------------------------------------------------------------------
bool AreFloats(const LineNumbers& lines, const FieldPair& fields)
{
  constexpr std::int32_t least = 0x3f800000; // 1 as an IEEE float.
  constexpr std::int32_t largest = 0x4cbebc20; // 1e8 as an IEEE float; IBM floats from 1 to 1e8 are in the same range.
  const auto isFloat = [&](std::int32_t bits) { return bits >= least && bits <= largest; };
  std::int64_t places = 0;
  for (std::int64_t trace = 0; trace < lines.Table.Traces; trace += SamplingStride(lines.Table))
  {
    if (HasPlace(lines, fields, trace))
    {
      ++places;
      if (!isFloat(lines.Table[fields.First][trace]) || !isFloat(lines.Table[fields.Second][trace]))
      {
        return false;
      }
    }
  }
  return places > 0;
}

//----------------------------------------------------------------------------------------------------------------------
bool NumberByPlaces(TraceTable& table, const SEGYOptions& options, const Monitor& monitor)
{
  for (const FieldPair& fields : ListPlaceFields(table, options.PlaceFields))
  {
    const std::optional<PickPlaces> places = ListAllPlaces(table, fields);
    if (!places || places->X.size() < 4)
    {
      continue;
    }
    try
    {
      const std::vector<Eigen::Vector2d> indices = FindIndices(*places, monitor);
      table.Fields[TraceByte::LatticeColumn] = MakeNumbers(table, fields, indices, 0);
      table.Fields[TraceByte::LatticeRow] = MakeNumbers(table, fields, indices, 1);
      if (IsGrid(
            table, { TraceByte::LatticeRow, TraceByte::LatticeColumn }, options.Duplicates != DuplicateRule::Refuse))
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
}
