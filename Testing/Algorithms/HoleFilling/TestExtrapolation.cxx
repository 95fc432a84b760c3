// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Columns outside that are filled.

#include "HoleFixtures.h"

#include "Tools/Check.h"

#include <map>
#include <set>
#include <utility>

using namespace HoleFixtures;

namespace
{
using Places = std::set<std::pair<int, int>>;

Places PlacesOf(const std::vector<PlanePoint>& columns, std::size_t first)
{
  Places places;
  for (std::size_t n = first; n < columns.size(); ++n)
  {
    CHECK(places.insert({ columns[n].X, columns[n].Y }).second);
  }
  return places;
}

/// All that is near a point and in a box, and no point.
Places NearPoints(const Patches::Columns& columns, int distance, const PlaneBox& box)
{
  Places near;
  for (const PlanePoint& column : columns)
  {
    for (int n = 0; n < (2 * distance + 1) * (2 * distance + 1); ++n)
    {
      const int x = column.X + n % (2 * distance + 1) - distance;
      const int y = column.Y + n / (2 * distance + 1) - distance;
      if (x >= box.Least.X && x <= box.Greatest.X && y >= box.Least.Y && y <= box.Greatest.Y)
      {
        near.insert({ x, y });
      }
    }
  }
  for (const PlanePoint& column : columns)
  {
    near.erase({ column.X, column.Y });
  }
  return near;
}

double Plane(double x, double y)
{
  return 100.0 + 2.0 * x - 0.5 * y;
}

/// A horseshoe, with a hole in it; its bay is to the right.
Patches::Columns Horseshoe()
{
  return Square(40,
    [](int x, int y)
    {
      const double away = std::hypot(x - 20.0, y - 20.0);
      const bool isHole = x >= 8 && x < 10 && y >= 19 && y < 21;
      return away < 8.0 || away > 16.0 || (x > 20 && std::abs(y - 20) < 4) || isHole;
    });
}

/// What is near, whatever the patch; a plane goes on as it is.
void TestWhichAndPlane()
{
  const Patches::Columns columns = Horseshoe();
  const Horizon horizon = OnSurface(columns, Plane);
  PlaneBox all;
  all.Add({ -100, -100 });
  all.Add({ 200, 200 });
  PlaneBox survey;
  survey.Add({ 2, 0 });
  survey.Add({ 37, 40 });
  for (const FillMethod method : { FillMethod::Automatic, FillMethod::Plate })
  {
    for (const int distance : { 1, 3, 12, 60 })
    {
      for (const bool isClipped : { false, true })
      {
        HoleFillingOptions options;
        options.Method = method;
        options.LargestHoleSize = 10; // the outside has no limit
        options.ExtrapolationDistance = distance;
        options.Survey = isClipped ? std::optional<PlaneBox>(survey) : std::nullopt;
        const FilledColumns filled = Fill(horizon, options);
        CHECK_EQUAL(filled.FilledHoles, 1);
        CHECK_EQUAL(filled.OpenHoles, 0);
        CHECK_EQUAL(filled.FirstOutside, 4u);
        Places expected = NearPoints(columns, distance, isClipped ? survey : all);
        for (const auto& place : PlacesOf({ filled.Column.begin(), filled.Column.begin() + 4 }, 0))
        {
          CHECK_EQUAL(expected.erase(place), 1u);
        }
        CHECK(PlacesOf(filled.Column, 4) == expected);
        CHECK(LargestError(filled, Plane) < 1e-6);
      }
    }
  }
}

/// A membrane stays between the heights it knows; holes that are too large stay open.
void TestMembraneAndLimits()
{
  const Horizon horizon = OnSurface(Horseshoe(), Plane);
  HoleFillingOptions options = AllHoles(FillMethod::Membrane);
  options.LargestHoleSize = 3;
  options.ExtrapolationDistance = 5;
  const FilledColumns filled = Fill(horizon, options);
  CHECK_EQUAL(filled.OpenHoles, 1);
  CHECK_EQUAL(filled.FilledHoles, 0);
  CHECK_EQUAL(filled.FirstOutside, 0u);
  const auto ends = std::minmax_element(horizon.Heights.begin(), horizon.Heights.end());
  for (const double height : filled.Height)
  {
    CHECK(height >= *ends.first - 1e-9 && height <= *ends.second + 1e-9);
  }
}

/// A disc in a survey, whose surroundings are solved by multigrid.
void TestLargeSurvey()
{
  const int size = 300;
  const Patches::Columns columns = Square(size, [](int x, int y) { return std::hypot(x - 150.0, y - 140.0) > 100.0; });
  HoleFillingOptions options = AllHoles(FillMethod::Plate, 1.0);
  options.ExtrapolationDistance = size;
  options.Survey = PlaneBox({ { 0, 0 }, { size - 1, size - 1 } });
  const FilledColumns filled = Fill(OnSurface(columns, Plane), options);
  CHECK_EQUAL(filled.Column.size() + columns.size(), std::size_t(size * size));
  CHECK(LargestError(filled, Plane) < 1e-4);
}

void TestNothingAndErrors()
{
  HoleFillingOptions options;
  options.ExtrapolationDistance = 3;
  CHECK(Fill({}, options).Column.empty());
  for (const int distance : { -1, 10001 })
  {
    options.ExtrapolationDistance = distance;
    CHECK_THROWS_WITH(
      Fill({}, options), "extrapolation distance " + std::to_string(distance) + ", expected 0 to 10000");
  }
}
}

int TestExtrapolation(int, char*[])
{
  TestWhichAndPlane();
  TestMembraneAndLimits();
  TestLargeSurvey();
  TestNothingAndErrors();
  return Check::Result();
}
