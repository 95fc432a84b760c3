// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlacedPoints.h"

#include "Common/Errors.h"
#include "Common/Survey/LatticeFrame.h"
#include "Common/Survey/Units.h"
#include "Common/TextWords.h"
#include "Common/VTK/SurveyFields.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr double LargestDeviation = 0.05;
constexpr double LargestColumn = 1 << 28;

/// Units in short, and the domain that they are of.
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
}

//----------------------------------------------------------------------------------------------------------------------
PlacedPoints PlaceOn(const Lattice& lattice, vtkPolyData* points, const HorizonNames& names)
{
  const std::string point = "a point of " + names.Placed + " at ";
  PlacedPoints placed;
  placed.Columns.reserve(std::size_t(points->GetNumberOfPoints()));
  placed.Height.reserve(placed.Columns.capacity());
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
  {
    const Eigen::Vector3d world(points->GetPoint(n));
    if (!world.allFinite())
    {
      throw InputError(point + ToText(world) + ", expected finite numbers");
    }
    const Eigen::Vector3d place = lattice.ToLattice(world);
    if (!(std::abs(place.z()) <= LargestHeight))
    {
      throw InputError(point + ToText(world) + ", expected at most 2^50 vertical indices up or down");
    }
    const Eigen::Vector2d column(std::floor(place.x() + 0.5), std::floor(place.y() + 0.5));
    if (!((place.head<2>() - column).cwiseAbs().maxCoeff() <= LargestDeviation) ||
      !(column.cwiseAbs().maxCoeff() < LargestColumn))
    {
      throw InputError(point + ToText(world) + ", which is not on a column of " + names.First +
        ", expected points on one lattice: Horizon From Points grids them there");
    }
    placed.Columns.push_back({ static_cast<std::int32_t>(column.x()), static_cast<std::int32_t>(column.y()) });
    placed.Height.push_back(place.z());
  }
  return placed;
}

//----------------------------------------------------------------------------------------------------------------------
SurveyDescription JoinSurveys(const SurveyDescription& first, vtkPolyData* other, const HorizonNames& names)
{
  const auto join = [&names](const std::string& name, std::string& known, const std::string& found)
  {
    if (!known.empty() && !found.empty() && ToLower(Trim(known)) != ToLower(Trim(found)))
    {
      throw InputError(
        names.Placed + " of the " + name + " \"" + found + "\", expected \"" + known + "\" as of " + names.First);
    }
    known = known.empty() ? found : known;
  };
  SurveyDescription joined = WithDomain(first);
  const SurveyDescription own = WithDomain(ReadSurveyFields(other->GetFieldData()));
  join("VerticalDomain", joined.VerticalDomain, own.VerticalDomain);
  join("VerticalUnit", joined.VerticalUnit, own.VerticalUnit);
  join("HorizontalUnit", joined.HorizontalUnit, own.HorizontalUnit);
  join("CoordinateSystem", joined.CoordinateSystem, own.CoordinateSystem);
  return joined;
}
}
