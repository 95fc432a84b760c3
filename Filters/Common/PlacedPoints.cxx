// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlacedPoints.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/LatticeFrame.h"
#include "Common/Survey/MeshSampling.h"
#include "Common/Survey/SurveyFields.h"
#include "Common/Survey/Units.h"
#include "Common/Text/TextWords.h"
#include "HorizonData.h"
#include "HorizonPoints.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
constexpr double LargestDeviation = 0.05;
constexpr double LargestColumn = 1 << 28;

SurveyDescription WithDomain(SurveyDescription survey)
{
  survey.HorizontalUnit = ShortUnit(survey.HorizontalUnit);
  survey.VerticalUnit = ShortUnit(survey.VerticalUnit);
  const bool isTime = survey.VerticalUnit == "ms" || survey.VerticalUnit == "s";
  const bool isLength = survey.VerticalUnit == "m" || survey.VerticalUnit == "ft";
  if (survey.VerticalDomain.empty() && (isTime || isLength))
  {
    survey.VerticalDomain = isTime ? "time" : "depth";
  }
  return survey;
}

Eigen::Vector3d PlaceOf(std::int64_t point, const Horizon& points, const Lattice& lattice, const HorizonNames& names)
{
  const Eigen::Vector3d world = points.Place(point);
  const char* const expected = !world.allFinite() ? "finite numbers" : "at most 2^50 vertical indices up or down";
  const Eigen::Vector3d place = lattice.ToLattice(world);
  if (!world.allFinite() || !(std::abs(place.z()) <= LargestHeight))
  {
    throw InputError("a point of " + names.Placed + " at " + ToText(world) + ", expected " + expected);
  }
  return place;
}

/// Returns nothing if no column is within LargestDeviation.
std::optional<PlanePoint> ColumnOf(const Eigen::Vector3d& place)
{
  const Eigen::Vector2d column(std::floor(place.x() + 0.5), std::floor(place.y() + 0.5));
  const bool isThere = (place.head<2>() - column).cwiseAbs().maxCoeff() <= LargestDeviation &&
    column.cwiseAbs().maxCoeff() < LargestColumn;
  return isThere ? std::optional<PlanePoint>({ std::int32_t(column.x()), std::int32_t(column.y()) }) : std::nullopt;
}

/// Places are relative to `least`, the least column.
std::vector<SpacePoint> ReadPlaces(
  const Lattice& lattice, const Horizon& mesh, const HorizonNames& names, Eigen::Array2d& least, Eigen::Array2d& most)
{
  std::vector<SpacePoint> places;
  least.setConstant(LargestColumn);
  most.setConstant(-LargestColumn);
  for (std::int64_t n = 0; n < mesh.NumberOfPoints(); ++n)
  {
    const Eigen::Vector3d place = PlaceOf(n, mesh, lattice, names);
    places.push_back({ place.x(), place.y(), place.z() });
    least = least.min(place.head<2>().array().floor());
    most = most.max(place.head<2>().array().ceil());
  }
  if (least.abs().maxCoeff() >= LargestColumn || most.abs().maxCoeff() >= LargestColumn)
  {
    throw InputError(names.Placed + " reaches over " + std::to_string(std::int64_t((most - least).maxCoeff())) +
      " columns, expected less than 2^28");
  }
  for (SpacePoint& place : places)
  {
    place.X -= least.x();
    place.Y -= least.y();
  }
  return places;
}

/// More than 2^30 columns would exceed memory.
void RequireColumns(const std::vector<SpacePoint>& places, const std::vector<std::array<PointId, 3>>& triangles,
  const HorizonNames& names)
{
  constexpr double most = double(1 << 30);
  double area = 0.0;
  for (const auto& [a, b, c] : triangles)
  {
    area += 0.5 *
      std::abs((places[b].X - places[a].X) * (places[c].Y - places[a].Y) -
        (places[b].Y - places[a].Y) * (places[c].X - places[a].X));
  }
  if (area > most)
  {
    throw InputError("triangles of " + names.Placed + " over " + std::to_string(std::int64_t(area)) + " columns of " +
      names.First + ", expected at most 2^30");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
PlacedPoints PlaceOn(const Lattice& lattice, const Horizon& points, const HorizonNames& names)
{
  PlacedPoints placed;
  placed.Columns.reserve(std::size_t(points.NumberOfPoints()));
  placed.Height.reserve(placed.Columns.capacity());
  for (std::int64_t n = 0; n < points.NumberOfPoints(); ++n)
  {
    const Eigen::Vector3d place = PlaceOf(n, points, lattice, names);
    const std::optional<PlanePoint> column = ColumnOf(place);
    if (!column)
    {
      throw InputError("a point of " + names.Placed + " at " + ToText(points.Place(n).head<2>()) +
        ", which is not on a column of " + names.First +
        ", expected points on one lattice: Horizon From Points grids them there");
    }
    placed.Columns.push_back(*column);
    placed.Height.push_back(place.z());
  }
  return placed;
}

//----------------------------------------------------------------------------------------------------------------------
PlacedPoints SampleOn(const Lattice& lattice, const Horizon& mesh, const HorizonNames& names, const Monitor& monitor)
{
  if (const std::int64_t hidden = mesh.NumberOfPoints() - CountVisiblePoints(mesh))
  {
    throw InputError(std::to_string(hidden) + " points of " + names.Placed +
      ", a mesh, are hidden by the array vtkGhostType, expected none");
  }
  Eigen::Array2d least;
  Eigen::Array2d most;
  const std::vector<SpacePoint> places = ReadPlaces(lattice, mesh, names, least, most);
  const std::vector<std::array<PointId, 3>> triangles = ReadOpenTriangles(mesh);
  RequireColumns(places, triangles, names);
  const Eigen::Array2d size = most - least + 1.0;
  MeshSampling sampling({ int(size.x()), int(size.y()) });
  sampling.AddTriangles(places, triangles, monitor);
  sampling.AddBarePoints(places, [&places](std::size_t point) { return places[point].Z; });
  PlacedPoints placed;
  sampling.Tiles.ForEachPlace(
    [&](int i, int j, std::size_t place)
    {
      if (!std::isnan(sampling.Heights[place]))
      {
        placed.Columns.push_back({ i + std::int32_t(least.x()), j + std::int32_t(least.y()) });
        placed.Height.push_back(sampling.Heights[place]);
      }
    });
  return placed;
}

//----------------------------------------------------------------------------------------------------------------------
SurveyDescription JoinSurveys(const SurveyDescription& first, const Horizon& other, const HorizonNames& names)
{
  const auto join = [&names](const std::string& what, std::string& known, const std::string& found)
  {
    if (!known.empty() && !found.empty() && ToLower(Trim(known)) != ToLower(Trim(found)))
    {
      throw InputError(names.Placed + " with " + what + " \"" + found + "\", expected \"" + known + "\" as in " +
        names.First + ": convert one of them");
    }
    known = known.empty() ? found : known;
  };
  SurveyDescription joined = WithDomain(first);
  const SurveyDescription own = WithDomain(ReadSurveyFields(other.FieldData));
  join("z in", joined.VerticalDomain, own.VerticalDomain);
  join("z in", joined.VerticalUnit, own.VerticalUnit);
  join("x and y in", joined.HorizontalUnit, own.HorizontalUnit);
  join("the coordinate system", joined.CoordinateSystem, own.CoordinateSystem);
  return joined;
}

//----------------------------------------------------------------------------------------------------------------------
std::string WarnOfDirections(const Horizon& first, const Horizon& other, const HorizonNames& names)
{
  const auto isUp = [](const Horizon& horizon) -> std::optional<bool>
  {
    const DataArray* const direction = horizon.FieldData.Find(FieldArray::VerticalDirection);
    const bool isKnown = direction && direction->Tuples() == 1;
    return isKnown ? std::optional<bool>(direction->At(0) > 0.0) : std::nullopt;
  };
  const std::optional<bool> one = isUp(first);
  const std::optional<bool> two = isUp(other);
  return !one || !two || *one == *two
    ? ""
    : "z of the file increases " + std::string(*two ? "upwards" : "downwards") + " in " + names.Placed + " and " +
      (*one ? "upwards" : "downwards") + " in " + names.First + "; VerticalDirection sets it if one was misread";
}

//----------------------------------------------------------------------------------------------------------------------
std::string WarnOfHeights(const Horizon& first, const Horizon& other, const HorizonNames& names)
{
  const std::string unit = WithDomain(ReadSurveyFields(first.FieldData)).VerticalUnit;
  const std::string unitOfOther = WithDomain(ReadSurveyFields(other.FieldData)).VerticalUnit;
  if (unit.empty() == unitOfOther.empty())
  {
    return WarnOfDirections(first, other, names);
  }
  const auto& [without, with] =
    unit.empty() ? std::tie(names.First, names.Placed) : std::tie(names.Placed, names.First);
  return "z without a unit in " + without + ", taken as " + unit + unitOfOther + " as in " + with +
    "; VerticalUnit of its reader sets it";
}
}
