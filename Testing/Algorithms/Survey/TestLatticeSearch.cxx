// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lattices are found again from points that are turned, stretched, sheared, full of holes, shuffled and rounded.

#include "Common/Survey/LatticeSearch.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr double Pi = 3.14159265358979323846;

struct Cloud
{
  std::vector<double> X, Y;

  void Add(const Eigen::Vector2d& place)
  {
    this->X.push_back(place.x());
    this->Y.push_back(place.y());
  }

  void Shuffle(Patches::Random& random)
  {
    for (std::size_t n = this->X.size(); n > 1; --n)
    {
      const auto other = std::size_t(random.Below(int(n)));
      std::swap(this->X[n - 1], this->X[other]);
      std::swap(this->Y[n - 1], this->Y[other]);
    }
  }
};

/// A survey far from the origin.
PlaneMap MakeSurvey(double length, double ratio, double degrees, double shear)
{
  const double angle = degrees * Pi / 180.0;
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d across(-along.y(), along.x());
  PlaneMap map;
  map.Origin = { 459621.05, 5934843.01 };
  map.Steps << length * along, length * (ratio * across + shear * along);
  return map;
}

Cloud MakeCloud(const PlaneMap& map, int columns, int rows, double missing, double rounding, Patches::Random& random)
{
  Cloud cloud;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      if (!random.Chance(missing))
      {
        const Eigen::Vector2d place = map.Origin + map.Steps * Eigen::Vector2d(i, j);
        cloud.Add(rounding > 0.0 ? Eigen::Vector2d((place / rounding).array().round() * rounding) : place);
      }
    }
  }
  return cloud;
}

/// The largest distance of a point to its column, in columns.
double LargestDistance(const Cloud& cloud, const PlaneMap& map)
{
  const Eigen::Matrix2d toColumns = map.Steps.inverse();
  double largest = 0.0;
  for (std::size_t n = 0; n < cloud.X.size(); ++n)
  {
    const Eigen::Vector2d column = toColumns * (Eigen::Vector2d(cloud.X[n], cloud.Y[n]) - map.Origin);
    const Eigen::Vector2d index = column.array().round();
    largest = std::max(largest, (column - index).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// The lattice is the one the points were made with: they are on its columns, and it has no others between them.
void CheckFound(const Cloud& cloud, const PlaneMap& expected, double tolerance)
{
  const PlaneMap found = FindLattice(cloud.X, cloud.Y);
  CHECK(LargestDistance(cloud, found) <= tolerance);
  const double cells = found.Steps.determinant() / std::abs(expected.Steps.determinant());
  CHECK(std::abs(cells - 1.0) < 0.01);
  const Eigen::Vector2d along = found.Steps.col(0);
  CHECK(along.x() > 0.0 && std::abs(along.y()) <= along.x() * (1.0 + 1e-6));
}

void TestSurveys()
{
  Patches::Random random(1);
  for (const double ratio : { 1.0, 2.0, 5.0, 20.0 })
  {
    for (const double degrees : { 0.0, 1.0, 30.0, 45.0, 66.58, 90.0, 140.000015, 200.0 })
    {
      for (const double missing : { 0.0, 0.3, 0.7 })
      {
        const PlaneMap survey = MakeSurvey(12.5, ratio, degrees, 0.0);
        Cloud cloud = MakeCloud(survey, 120, 70, missing, 0.01, random);
        cloud.Shuffle(random);
        CheckFound(cloud, survey, 0.002);
      }
    }
  }
}

void TestShear()
{
  Patches::Random random(2);
  for (const double shear : { -0.4, 0.1, 0.5 })
  {
    const PlaneMap survey = MakeSurvey(25.0, 1.5, 17.0, shear);
    const Cloud cloud = MakeCloud(survey, 80, 80, 0.2, 0.0, random);
    const PlaneMap found = FindLattice(cloud.X, cloud.Y);
    CHECK(LargestDistance(cloud, found) < 1e-6);
    CHECK(std::abs(found.Steps.determinant() / survey.Steps.determinant() - 1.0) < 1e-9);
  }
}

/// Northings in single precision are multiples of half a metre.
void TestSinglePrecision()
{
  Patches::Random random(3);
  const PlaneMap survey = MakeSurvey(20.0, 1.0, 140.000015, 0.0);
  CheckFound(MakeCloud(survey, 300, 200, 0.4, 0.5, random), survey, 0.03);
}

/// A small piece with gaps in a long survey: errors of the steps must not add up.
void TestLongSurvey()
{
  Patches::Random random(4);
  const PlaneMap survey = MakeSurvey(6.25, 2.0, 3.3, 0.0);
  CheckFound(MakeCloud(survey, 20000, 12, 0.5, 0.01, random), survey, 0.003);
}

/// Half of the survey is picked at every second line only, where most points are.
void TestLinesBetween()
{
  Patches::Random random(5);
  const PlaneMap survey = MakeSurvey(25.0, 1.0, 10.0, 0.0);
  Cloud cloud;
  for (int j = 0; j < 300; ++j)
  {
    for (int i = 0; i < 100; ++i)
    {
      if (j % 2 == 0 || i >= 60)
      {
        cloud.Add(survey.Origin + survey.Steps * Eigen::Vector2d(i, j));
      }
    }
  }
  CheckFound(cloud, survey, 1e-6);
}

/// Lines at unequal distances fit their mean to within a tenth, which would move them, and a common divisor exactly.
void TestUnequalDistances()
{
  Patches::Random random(7);
  for (const double degrees : { 0.0, 17.0 })
  {
    for (const double ratio : { 0.5, 1.0, 3.0 })
    {
      const PlaneMap survey = MakeSurvey(25.0, ratio, degrees, 0.0);
      Cloud cloud;
      for (const int j : { 0, 15, 29 })
      {
        for (int i = 0; i < 40; ++i)
        {
          cloud.Add(survey.Origin + survey.Steps * Eigen::Vector2d(i, j));
        }
      }
      cloud.Shuffle(random);
      CheckFound(cloud, survey, 1e-6);
    }
  }
}

/// A row that is off, and noise, do not make the lattice finer.
void TestNoDivisor()
{
  Patches::Random random(8);
  const PlaneMap survey = MakeSurvey(25.0, 4.0, 17.0, 0.0);
  Cloud cloud = MakeCloud(survey, 60, 60, 0.2, 1.0, random);
  CheckFound(cloud, survey, 0.05);
  cloud = MakeCloud(survey, 60, 60, 0.0, 0.0, random);
  cloud.Add(survey.Origin + survey.Steps * Eigen::Vector2d(7.0, 30.5));
  CHECK(LargestDistance(cloud, FindLattice(cloud.X, cloud.Y)) > 0.4);
}

/// Columns that are hit many times, and few of them.
void TestRepeated()
{
  const PlaneMap survey = MakeSurvey(25.0, 1.0, 10.0, 0.0);
  Cloud cloud;
  for (int n = 0; n < 40000; ++n)
  {
    cloud.Add(survey.Origin + survey.Steps * Eigen::Vector2d(n % 3, n / 3 % 4));
  }
  CheckFound(cloud, survey, 1e-6);
}

void TestSmallest()
{
  const PlaneMap found = FindLattice({ 100.0, 110.0, 100.0 }, { 50.0, 50.0, 70.0 });
  CHECK((found.Steps - Eigen::Matrix2d(Eigen::Vector2d(10.0, 20.0).asDiagonal())).norm() < 1e-9);
}

/// Many nulls at one place say nothing of the steps. They are a column, too.
void TestStacked()
{
  Patches::Random random(5);
  const PlaneMap map = MakeSurvey(25.0, 1.0, 30.0, 0.0);
  Cloud cloud = MakeCloud(map, 40, 50, 0.0, 0.01, random);
  for (int n = 0; n < 40000; ++n)
  {
    cloud.Add(Eigen::Vector2d(cloud.X[7], cloud.Y[7]));
  }
  CheckFound(cloud, map, 0.01);
}

/// A pick that is out of the world neither ends the search nor takes long.
void TestFarAway()
{
  Patches::Random random(6);
  const PlaneMap map = MakeSurvey(25.0, 1.0, 30.0, 0.0);
  Cloud cloud = MakeCloud(map, 40, 50, 0.0, 0.0, random);
  cloud.Add({ 1e300, -1e300 });
  std::vector<double> reached;
  const Monitor monitor(
    [&reached](double part)
    {
      reached.push_back(part);
      return true;
    });
  const PlaneMap found = FindLattice(cloud.X, cloud.Y, monitor);
  CHECK(reached.size() < 100); // once for each time that the points are gone through
  CHECK((found.Steps.cwiseAbs() - map.Steps.cwiseAbs()).norm() < 1e-3);
}

void TestRefusals()
{
  CHECK_THROWS_WITH(FindLattice({ 1.0, 2.0 }, { 1.0, 2.0 }), "2 points, expected at least three");
  CHECK_THROWS_WITH(
    FindLattice({ 1.0, 2.0, 3.0, 5.0 }, { 1.0, 2.0, 3.0, 5.0 }), "4 positions, all on one line, expected");
  CHECK_THROWS_WITH(FindLattice({ 1.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0 }), "1 positions, all on one line, expected");
  Patches::Random random(6);
  Cloud cloud;
  for (int n = 0; n < 5000; ++n)
  {
    cloud.Add({ random.Fraction() * 1000.0, random.Fraction() * 1000.0 });
  }
  CHECK_THROWS_WITH(FindLattice(cloud.X, cloud.Y), "5000 points without a lattice: with the best steps, (");
}
}

int TestLatticeSearch(int, char*[])
{
  TestSurveys();
  TestShear();
  TestSinglePrecision();
  TestLongSurvey();
  TestLinesBetween();
  TestUnequalDistances();
  TestNoDivisor();
  TestRepeated();
  TestSmallest();
  TestStacked();
  TestFarAway();
  TestRefusals();
  return Check::Result();
}
