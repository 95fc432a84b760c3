// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultStage.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/SurveyFields.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"
#include "Filters/Common/CellWriter.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"
#include "Filters/Common/PlacedPoints.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t HorizonPort = 0;
constexpr std::size_t LinesPort = 1;
constexpr std::size_t SurfacesPort = 2;

// ---- Given lines ----------------------------------------------------------------------------------------------------

/// Whether names are such as "A 1", "A 2" and all different: of sticks, and not of faults.
bool AreNumbered(const std::vector<std::string>& names)
{
  const auto endsWithNumber = [](const std::string& name)
  {
    const std::size_t blank = name.rfind(' ');
    return blank != std::string::npos && blank > 0 && blank + 1 < name.size() &&
      name.find_first_not_of("0123456789", blank + 1) == std::string::npos;
  };
  return std::all_of(names.begin(), names.end(), endsWithNumber) &&
    std::set<std::string>(names.begin(), names.end()).size() == names.size();
}

/// `first` is the cell id of the first cell.
void AppendCells(
  const Horizon& lines, const Cells& cells, bool arePolygons, std::int64_t first, std::vector<FaultStick>& polylines)
{
  const auto find = [&lines](const char* name)
  {
    const DataArray* const array = lines.CellData.Find(name);
    const DataArray* const texts = array && array->IsText() ? array : nullptr;
    if (texts)
    {
      RequireTuples(*texts, lines.NumberOfCells(), "cells");
    }
    return texts;
  };
  const DataArray* const names = find(CellArray::FaultName);
  const bool haveNumbers = !find(CellArray::FaultStick) && names && AreNumbered(names->Texts());
  for (std::int64_t cell = 0; cell < cells.Size(); ++cell)
  {
    FaultStick polyline;
    for (std::int64_t n = 0; n < cells.Length(cell); ++n)
    {
      const std::int64_t point = cells.At(cell, n);
      if (point < 0 || point >= lines.NumberOfPoints())
      {
        throw InputError("point id " + std::to_string(point) + " in fault polyline " +
          std::to_string(polylines.size()) + ", expected 0 to " + std::to_string(lines.NumberOfPoints() - 1));
      }
      const Eigen::Vector3d place = lines.Place(point);
      polyline.Places.push_back({ place.x(), place.y(), place.z() });
    }
    if (arePolygons && !polyline.Places.empty())
    {
      polyline.Places.push_back(polyline.Places.front());
    }
    if (names)
    {
      const std::string& name = names->Texts()[std::size_t(first + cell)];
      polyline.Fault = haveNumbers ? name.substr(0, name.rfind(' ')) : name;
    }
    polylines.push_back(polyline);
  }
}

/// Heights are dropped.
std::vector<FaultPolyline> ToMap(const std::vector<FaultStick>& lines, const Lattice& lattice)
{
  std::vector<FaultPolyline> polylines;
  for (const FaultStick& line : lines)
  {
    polylines.emplace_back();
    for (const SpacePoint& world : line.Places)
    {
      const Eigen::Vector3d place = lattice.ToLattice(Eigen::Vector3d(world.X, world.Y, world.Z));
      polylines.back().push_back({ place.x(), place.y() });
    }
  }
  return polylines;
}

/// Converts world coordinates to columns and vertical indices, in place.
void ToLattice(std::vector<FaultSheet>& sheets, const Lattice& lattice)
{
  for (FaultSheet& sheet : sheets)
  {
    for (std::optional<SpacePoint>& given : sheet.Places)
    {
      if (given)
      {
        const Eigen::Vector3d place = lattice.ToLattice(Eigen::Vector3d(given->X, given->Y, given->Z));
        given = { place.x(), place.y(), place.z() };
      }
    }
  }
}

// ---- Output ---------------------------------------------------------------------------------------------------------

void WriteFaultSheets(const std::vector<FaultSheet>& sheets, Horizon& output)
{
  CellWriter cells;
  std::vector<std::string> names;
  for (std::size_t n = 0; n < sheets.size(); ++n)
  {
    const FaultSheet& sheet = sheets[n];
    std::vector<std::int64_t> ids(sheet.Places.size(), -1);
    for (const std::array<std::size_t, 3>& triangle : sheet.ListTriangles())
    {
      for (const std::size_t place : triangle)
      {
        if (ids[place] < 0)
        {
          const SpacePoint& at = *sheet.Places[place];
          ids[place] = cells.AddPoint({ at.X, at.Y, at.Z });
        }
        cells.Use(ids[place]);
      }
      cells.Close();
      names.push_back(NameOf(sheets, n));
    }
  }
  cells.Finish(output, &Horizon::Polygons);
  output.CellData.Add({ CellArray::FaultName, std::move(names) });
}

MapPlace EndOf(const FaultedLink& cut, bool isLast)
{
  const double shift = cut.IsForward == isLast ? 0.5 : -0.5;
  const PlanePoint column = cut.Place.Column;
  return cut.Place.Side == LinkSide::East ? MapPlace{ column.X + 0.5, column.Y + shift }
                                          : MapPlace{ column.X + shift, column.Y + 0.5 };
}

/// A link without a height takes the previous one, or else the first known one, or else `otherwise`. Heights from one
/// side only, as at a hole, count only if no link of the line has both.
std::vector<double> FindHeights(const FaultLines& lines, std::size_t line, double otherwise)
{
  const std::size_t start = lines.Start(line);
  const std::size_t end = lines.End(line);
  bool hasBoth = false;
  for (std::size_t n = start; n < end; ++n)
  {
    hasBoth = hasBoth || !std::isnan(lines[n].Throw);
  }
  const auto heightOr = [&lines, hasBoth](std::size_t n, double last)
  { return std::isnan(hasBoth ? lines[n].Throw : lines[n].Middle) ? last : lines[n].Middle; };
  double last = otherwise;
  for (std::size_t n = end; n-- > start;)
  {
    last = heightOr(n, last);
  }
  std::vector<double> heights;
  for (std::size_t n = start; n < end; ++n)
  {
    last = heightOr(n, last);
    heights.push_back(last);
  }
  return heights;
}

/// A polyline runs through the middles of faulted links. Throw is positive where the left side of the line is higher.
/// Links without a height take one from their line, or else `height`.
void WriteDetectedLines(const FaultLines& lines, const Lattice& lattice, double height, Horizon& output)
{
  CellWriter cells;
  std::vector<double> throws;
  std::vector<int> numbers;
  const auto append = [&](const MapPlace& place, double z, const FaultedLink& link)
  {
    cells.Add(lattice.ToWorld(Eigen::Vector3d(place.X, place.Y, z)));
    throws.push_back(link.LeftThrow());
  };
  for (std::size_t line = 0; line < lines.Size(); ++line)
  {
    const std::size_t start = lines.Start(line);
    const std::size_t end = lines.End(line);
    assert(start < end);
    const std::vector<double> heights = FindHeights(lines, line, height);
    append(EndOf(lines[start], false), heights.front(), lines[start]);
    for (std::size_t n = start; n < end; ++n)
    {
      const PlanePoint before = lines[n].Place.Column;
      const PlanePoint beyond = lines[n].Place.Beyond();
      append({ 0.5 * (before.X + beyond.X), 0.5 * (before.Y + beyond.Y) }, heights[n - start], lines[n]);
      if (n + 1 < end && lines[n + 1].Place == lines[n].Place) // The line turns back beyond the link.
      {
        append(EndOf(lines[n], true), heights[n - start], lines[n]);
      }
    }
    append(EndOf(lines[end - 1], true), heights.back(), lines[end - 1]);
    cells.Close();
    numbers.push_back(int(line));
  }
  cells.Finish(output, &Horizon::Lines);
  AddArray<double>(output.PointData, PointArray::Throw, throws);
  output.PointData.SetActiveScalars(PointArray::Throw);
  AddArray<int>(output.CellData, CellArray::FaultLine, numbers);
  output.CellData.Add({ CellArray::FaultName, NamesOf(lines) });
}

/// Returns true if points were blanked.
bool UsePolygons(PolygonUse use, std::vector<FaultPolyline>& polylines, LatticePoints& points, Horizon& output)
{
  if (use == PolygonUse::Leave)
  {
    for (FaultPolyline& polyline : polylines)
    {
      polyline = IsClosed(polyline) ? FaultPolyline() : polyline;
    }
  }
  if (use != PolygonUse::Blank)
  {
    return false;
  }
  const KeptPoints outside = FindOutside(points.Column, polylines);
  const std::size_t inside = points.Height.size() - outside.size();
  AddValue<std::int64_t>(output.FieldData, FieldArray::BlankedPoints, std::int64_t(inside));
  if (outside.empty())
  {
    throw InputError("fault polygons enclose all " + std::to_string(inside) + " points, expected some outside");
  }
  if (inside > 0)
  {
    Horizon rest;
    CopyPoints(points.Horizon, outside, rest);
    rest.FieldData = points.Horizon.FieldData;
    points = ReadColumns(rest);
  }
  return inside > 0;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<FaultStick> ReadFaultSticks(const NamedHorizon& block)
{
  const Horizon& lines = block.Data;
  std::vector<FaultStick> sticks;
  AppendCells(lines, lines.Lines, false, lines.Vertices.Size(), sticks);
  AppendCells(lines, lines.Polygons, true, lines.Vertices.Size() + lines.Lines.Size(), sticks);
  for (FaultStick& stick : sticks)
  {
    stick.Fault = stick.Fault.empty() ? block.Name : stick.Fault;
  }
  return sticks;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<FaultStick> ReadFaultSticks(const std::vector<NamedHorizon>& blocks)
{
  std::vector<FaultStick> sticks;
  for (const NamedHorizon& block : blocks)
  {
    std::vector<FaultStick> own = ReadFaultSticks(block);
    std::move(own.begin(), own.end(), std::back_inserter(sticks));
  }
  return sticks;
}

//----------------------------------------------------------------------------------------------------------------------
void RunFaults(const Horizon& horizon, GivenFaults& faultsGiven, FaultStageOptions options,
  std::vector<Horizon>& outputs, const Monitor& monitor)
{
  const std::vector<FaultStick>& given = faultsGiven.Sticks;
  CheckOptions(options);
  LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon));
  WriteDeviation(points, outputs);
  Horizon& output = outputs[HorizonPort];
  std::vector<FaultPolyline> polylines;
  std::vector<std::string> faults; // of each polyline
  IdleLines idle;
  bool doCut = false;
  if (!options.AreSticks && !given.empty())
  {
    polylines = ToMap(given, points.Lattice);
    std::transform(
      given.begin(), given.end(), std::back_inserter(faults), [](const FaultStick& line) { return line.Fault; });
    idle = FindIdleLines(given, polylines, points);
    doCut = UsePolygons(options.Polygons, polylines, points, output);
  }
  const double indices = IndicesPerUnit(options.ThrowUnit, points.Column, points.Height, points.Lattice);
  options.Noise *= indices;
  options.SmallestThrow = options.SmallestThrow > 0.0 ? options.SmallestThrow * indices
                                                      : ThrowAboveNoise(points.Column, points.Height, options.Noise);
  const ColumnHeights heights(points.Column, points.Height);
  if (options.AreSticks)
  {
    for (const NamedHorizon& block : faultsGiven.Blocks)
    {
      JoinSurveys(ReadSurveyFields(horizon.FieldData), block.Data, { "the fault sticks", "the horizon" });
    }
    std::vector<FaultSheet> sheets = MakeFaultSheets(given, options.ExtendSticks);
    WriteFaultSheets(sheets, outputs[SurfacesPort]);
    ToLattice(sheets, points.Lattice);
    std::vector<std::size_t> traces;
    for (std::size_t n = 0; n < sheets.size(); ++n)
    {
      const std::vector<FaultPolyline> ofSheet = FindTraces(heights, { sheets[n] });
      traces.push_back(ofSheet.size());
      polylines.insert(polylines.end(), ofSheet.begin(), ofSheet.end());
      faults.resize(polylines.size(), NameOf(sheets, n));
    }
    idle = FindIdleSticks(given, sheets, traces, options.ExtendSticks, points);
  }
  monitor.Progress(0.2);
  FaultLines lines = CutAlong(heights, polylines, faults);
  faultsGiven.Add(idle, doCut || lines.Size() > 0);
  const ArrayTable figures = output.FieldData;
  output = points.Horizon;
  output.FieldData = figures;
  if (options.Detect)
  {
    const FaultDetection detection = DetectFaults(heights, options, monitor.Step(0.2, 0.95));
    lines.Append(detection.Lines);
    AddValue<double>(output.FieldData, FieldArray::FaultNoise, detection.Noise);
    AddValue<double>(output.FieldData, FieldArray::SmallestFaultThrow, detection.High);
  }
  WriteCuts(lines, output.FieldData);
  const double sum = std::accumulate(points.Height.begin(), points.Height.end(), 0.0);
  WriteDetectedLines(lines, points.Lattice, sum / double(points.Height.size()), outputs[LinesPort]);
}
}
