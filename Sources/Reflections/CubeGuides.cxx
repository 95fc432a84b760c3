// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CubeGuides.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/PlaceText.h"
#include "Common/Survey/LatticeFrame.h"
#include "Filters/Common/HorizonPoints.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Horizons read from line numbers alone have crosslines for x and inlines for y.
bool HasLinesAsPlaces(const ArrayTable& fields)
{
  const DataArray* const lines = FindNumbers(fields, FieldArray::LineNumbers);
  const DataArray* const map = FindNumbers(fields, FieldArray::LatticeToWorld);
  const auto is = [&](std::int64_t n, double value) { return map->Value(n) == value; };
  return lines && map && lines->Size() == 4 && map->Size() == 16 && is(0, lines->Value(3)) && is(1, 0.0) &&
    is(3, lines->Value(2)) && is(4, 0.0) && is(5, lines->Value(1)) && is(7, lines->Value(0));
}

/// Places are in columns and samples from the first trace and sample of the cube.
class CubePlaces
{
public:
  explicit CubePlaces(const ImageCube& cube)
    : First(cube.FirstIndex[0], cube.FirstIndex[1], cube.FirstIndex[2])
    , Last(cube.Traces.Size[0] - 1, cube.Traces.Size[1] - 1, cube.Traces.Size[2] - 1)
    , Lines(FindNumbers(cube.Image.FieldData, FieldArray::LineNumbers))
  {
    std::array<int, 3> dimensions = cube.Traces.Size;
    std::transform(dimensions.begin(), dimensions.end(), cube.FirstIndex.begin(), dimensions.begin(), std::plus<>());
    this->Lattice = SeismicHorizons::Lattice(
      dimensions, Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(cube.Frame.ToWorld().data()));
  }

  bool KnowsLinesOf(const Horizon& horizon) const
  {
    return this->Lines && this->Lines->Size() == 4 && HasLinesAsPlaces(horizon.FieldData);
  }

  Eigen::Vector3d ToWorld(const Eigen::Vector3d& place, bool isOfLines) const
  {
    if (!isOfLines)
    {
      return place;
    }
    const Eigen::Vector3d column((place.x() - this->Lines->Value(2)) / this->Lines->Value(3),
      (place.y() - this->Lines->Value(0)) / this->Lines->Value(1), 0.0);
    const Eigen::Vector3d world = this->Lattice.ToWorld(column);
    return { world.x(), world.y(), place.z() };
  }

  Eigen::Vector3d ToCube(const Eigen::Vector3d& world) const { return this->Lattice.ToLattice(world) - this->First; }

  bool HasTrace(const Eigen::Vector3d& place) const
  {
    return place.x() >= -0.5 && place.x() < this->Last.x() + 0.5 && place.y() >= -0.5 &&
      place.y() < this->Last.y() + 0.5;
  }

  bool HasSample(const Eigen::Vector3d& place) const
  {
    return this->HasTrace(place) && place.z() >= 0.0 && place.z() <= this->Last.z();
  }

  std::array<int, 2> TraceAt(const Eigen::Vector3d& place) const
  {
    assert(this->HasTrace(place));
    return { static_cast<int>(std::floor(place.x() + 0.5)), static_cast<int>(std::floor(place.y() + 0.5)) };
  }

  /// Of the first and last corner.
  std::string CornersText() const
  {
    return PlaceText(this->Lattice.ToWorld(this->First)) + " to " +
      PlaceText(this->Lattice.ToWorld(this->First + this->Last));
  }

private:
  SeismicHorizons::Lattice Lattice;
  Eigen::Vector3d First; // lattice index
  Eigen::Vector3d Last; // last trace and sample, in cube units
  const DataArray* Lines; // null where unknown
};

void AddPoint(const Eigen::Vector3d& world, const CubePlaces& places, GuidePicks& guide)
{
  if (!world.allFinite())
  {
    throw InputError(
      "guide \"" + guide.Given.Name + "\": a point at " + PlaceText(world) + ", expected finite numbers");
  }
  const Eigen::Vector3d place = places.ToCube(world);
  if (places.HasSample(place))
  {
    const auto [i, j] = places.TraceAt(place);
    guide.Given.Picks.push_back({ i, j, place.z() });
    guide.Places.push_back({ world.x(), world.y(), world.z() });
  }
  else if (guide.Outside++ == 0)
  {
    guide.FirstOutside = PlaceText(world);
  }
}

void RequirePicks(const std::vector<GuidePicks>& guides, const CubePlaces& places)
{
  if (guides.empty())
  {
    throw InputError("guides without points, expected picks");
  }
  for (const GuidePicks& guide : guides)
  {
    if (guide.Given.Picks.empty())
    {
      throw InputError("guide \"" + guide.Given.Name + "\": none of its " + std::to_string(guide.Outside) +
        " points is on the cube, the first is at " + guide.FirstOutside + ", expected points from " +
        places.CornersText());
    }
  }
}

/// nan without a point on the trace
std::vector<double> ReadSamples(const NamedHorizon& limit, const ImageCube& cube, const CubePlaces& places)
{
  const std::array<int, 3>& size = cube.Traces.Size;
  std::vector<double> samples(std::size_t(size[0]) * std::size_t(size[1]), std::nan(""));
  CheckArraySizes(limit.Data);
  const Horizon shown = WithoutHiddenPoints(limit.Data);
  bool isOnTraces = false;
  bool isOnSamples = false;
  const bool areLines = places.KnowsLinesOf(shown);
  for (std::int64_t n = 0; n < shown.NumberOfPoints(); ++n)
  {
    const Eigen::Vector3d world = places.ToWorld(shown.Place(n), areLines);
    if (!world.allFinite())
    {
      throw InputError("limit \"" + limit.Name + "\": a point at " + PlaceText(world) + ", expected finite numbers");
    }
    const Eigen::Vector3d place = places.ToCube(world);
    if (places.HasTrace(place))
    {
      const auto [i, j] = places.TraceAt(place);
      double& sample = samples[std::size_t(i) + std::size_t(size[0]) * std::size_t(j)];
      if (!std::isnan(sample))
      {
        throw InputError("limit \"" + limit.Name + "\": two points on one trace, the second at " + PlaceText(world) +
          ", expected one: a horizon on the traces of the cube");
      }
      sample = place.z();
      isOnTraces = true;
      isOnSamples = isOnSamples || places.HasSample(place);
    }
  }
  if (isOnTraces && !isOnSamples) // This happens if z has the other sign.
  {
    throw InputError("limit \"" + limit.Name +
      "\": all of its points are above or below the samples of the cube, expected points from " + places.CornersText());
  }
  return samples;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<GuidePicks> ReadGuides(const std::vector<NamedHorizon>& horizons, const ImageCube& cube)
{
  const CubePlaces places(cube);
  std::vector<GuidePicks> guides;
  std::map<std::string, std::size_t> numbers; // by given names
  for (const auto& [given, data] : horizons)
  {
    CheckArraySizes(data);
    const Horizon shown = WithoutHiddenPoints(data);
    const DataArray* const names = shown.PointData.Find("Horizon");
    if (names && names->Components() != 1)
    {
      throw InputError("guide array Horizon of " + std::to_string(names->Components()) +
        " components, expected the number or the name of the horizon of each point");
    }
    const bool areLines = places.KnowsLinesOf(shown);
    for (std::int64_t n = 0; n < shown.NumberOfPoints(); ++n)
    {
      const std::string name = names ? TextOf(*names, n) : given;
      const auto [number, isNew] = numbers.insert({ name, guides.size() });
      if (isNew)
      {
        guides.emplace_back();
        guides.back().Given.Name = name.empty() ? "Guide " + std::to_string(guides.size()) : name;
      }
      AddPoint(places.ToWorld(shown.Place(n), areLines), places, guides[number->second]);
    }
  }
  RequirePicks(guides, places);
  return guides;
}

//----------------------------------------------------------------------------------------------------------------------
ExtractionLimits ReadLimits(const std::vector<NamedHorizon>& horizons, const ImageCube& cube, LimitSide side)
{
  if (horizons.empty() || horizons.size() > 2)
  {
    throw InputError("limits of " + std::to_string(horizons.size()) + " horizons, expected one or two");
  }
  const CubePlaces places(cube);
  ExtractionLimits limits;
  limits.Traces.First = ReadSamples(horizons.front(), cube, places);
  if (horizons.size() == 2)
  {
    limits.Traces.Last = ReadSamples(horizons.back(), cube, places);
  }
  else
  {
    limits.Traces.Last = limits.Traces.First;
    std::vector<double>& open = side == LimitSide::Below ? limits.Traces.Last : limits.Traces.First;
    std::transform(open.begin(), open.end(), open.begin(),
      [&](double sample) { return std::isnan(sample)    ? sample
                             : side == LimitSide::Below ? Infinity
                                                        : -Infinity; });
  }
  for (std::size_t trace = 0; trace < limits.Traces.First.size(); ++trace)
  {
    double& first = limits.Traces.First[trace];
    double& last = limits.Traces.Last[trace];
    if (last < first)
    {
      std::swap(first, last);
    }
    limits.Limited += first <= last ? 1 : 0; // nan fails the comparison.
  }
  if (limits.Limited == 0)
  {
    throw InputError("limits on no trace of the cube, expected horizons with points from " + places.CornersText());
  }
  return limits;
}
}
