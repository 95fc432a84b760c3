// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What filled holes are: polynomials come out as they are, and everything around stays what it was.

#include "HoleFixtures.h"

#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/HoleFilling/HoleRegion.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

#include <limits>
#include <utility>

using namespace HoleFixtures;

namespace
{
/// The side of a square that leaves room for a ring around a disc with lobes.
int SizeAround(int width)
{
  return int(1.1 * width) + 14;
}

/// A disc with lobes of that width in the middle of a square.
Patches::Columns WithHole(int width)
{
  const int size = SizeAround(width);
  const double middle = 0.5 * (size - 1);
  return Square(size,
    [middle, width](int x, int y)
    {
      const double angle = std::atan2(y - middle, x - middle);
      return std::hypot(x - middle, y - middle) < 0.5 * width * (1.0 + 0.1 * std::sin(5.0 * angle));
    });
}

/// Heights of some hundreds on a square of any size.
Surface Cubic(int width)
{
  return [scale = 2.0 / width](double x, double y)
  {
    x *= scale;
    y *= scale;
    return 1000.0 + 30.0 * x * x * x - 40.0 * x * x * y + 25.0 * y * y * y - 50.0 * x * y + 20.0 * y * y + x;
  };
}

/// The real parts of powers of x + i y, whose differences in the four directions cancel out.
Surface Harmonic(int width)
{
  return [scale = 2.0 / width](double x, double y)
  {
    x *= scale;
    y *= scale;
    return -500.0 + 40.0 * (x * x * x - 3.0 * x * y * y) + 60.0 * (x * x - y * y) + 30.0 * x * y + 20.0 * y;
  };
}

void TestPolynomials()
{
  for (const int width : { 1, 2, 3, 5, 9, 20, 45, 100, 130, 355 }) // up to about 10^5 columns
  {
    const Patches::Columns columns = WithHole(width);
    const FilledColumns plate = Fill(OnSurface(columns, Cubic(width)), AllHoles(FillMethod::Plate));
    CHECK_EQUAL(plate.Column.size() + columns.size(), std::size_t(SizeAround(width) * SizeAround(width)));
    const double plateError = LargestError(plate, Cubic(width));
    const double membraneError =
      LargestError(Fill(OnSurface(columns, Harmonic(width)), AllHoles(FillMethod::Membrane)), Harmonic(width));
    if (!CHECK(plateError < 1e-6) || !CHECK(membraneError < 1e-6))
    {
      std::cerr << "width " << width << ": " << plateError << ", " << membraneError << '\n';
    }
  }
}

/// Springs take nothing from a plane, however strong they are, nor does a ring of any width.
void TestPlanes()
{
  const Surface plane = [](double x, double y) { return 1e6 + 3.0 * x - 2.0 * y; };
  for (const int width : { 1, 6, 40, 120 })
  {
    for (const double smoothing : { 0.0, 1e-3, 1.0, 16.0, 1e6 })
    {
      for (const int ring : { 1, 2, 3, 8 })
      {
        HoleFillingOptions options = AllHoles(FillMethod::Plate, smoothing);
        options.RimWidth = ring;
        const double error = LargestError(Fill(OnSurface(WithHole(width), plane), options), plane);
        if (!CHECK(error < 1e-5))
        {
          std::cerr << "width " << width << ", smoothing " << smoothing << ", ring " << ring << ": " << error << '\n';
        }
      }
    }
  }
}

/// More smoothing, less of the noise of the rim.
void TestNoise()
{
  Patches::Random random(5);
  Horizon horizon = OnSurface(WithHole(40), [](double x, double y) { return 0.2 * x + 0.1 * y; });
  for (double& height : horizon.Heights)
  {
    height += 2.0 * random.Fraction() - 1.0;
  }
  double before = std::numeric_limits<double>::infinity();
  for (const double smoothing : { 0.0, 1.0, 16.0 })
  {
    const double error = LargestError(
      Fill(horizon, AllHoles(FillMethod::Plate, smoothing)), [](double x, double y) { return 0.2 * x + 0.1 * y; });
    CHECK(error < before);
    before = error;
  }
  CHECK(before < 0.6);
}

/// Rims that hold no plate: it is a membrane then.
void TestPoorRims()
{
  // A frame one column wide around four columns has no stencil that bends in its direction but one each.
  const Patches::Columns frame = Patches::FromPicture({ "####", "#..#", "#..#", "####" });
  const Surface level = [](double, double) { return 7.0; };
  CHECK(LargestError(Fill(OnSurface(frame, level), AllHoles(FillMethod::Plate)), level) < 1e-9);
  // Four points around one.
  const Patches::Columns cross = Patches::FromPicture({ ".#.", "#.#", ".#." });
  const FilledColumns filled = Fill({ cross, { 1.0, 2.0, 4.0, 9.0 } }, AllHoles(FillMethod::Membrane));
  CHECK_EQUAL(filled.Height.size(), 1u);
  CHECK(std::abs(filled.Height.front() - 4.0) < 1e-12);
}

void TestSizes()
{
  // Holes of 1, 2 and 4 columns; a bay, which is none.
  const Patches::Columns columns = Patches::FromPicture({ "##########", "#.##..##..", "#####.####", "##..######",
    "#######.##", "##########", "##########", "###.######", "##########" });
  const Horizon horizon = OnSurface(columns, [](double x, double y) { return x + y; });
  for (const auto& [largest, gaps, points] :
    { std::tuple<int, int, int>(0, 0, 0), { 1, 3, 3 }, { 2, 4, 5 }, { 3, 5, 8 }, { 100, 5, 8 } })
  {
    HoleFillingOptions options;
    options.LargestHoleSize = largest;
    const FilledColumns filled = Fill(horizon, options);
    CHECK_EQUAL(filled.FilledHoles, gaps);
    CHECK_EQUAL(filled.OpenHoles, 5 - gaps);
    CHECK_EQUAL(filled.Column.size(), std::size_t(points));
  }
}

/// Values that cannot be interpolated, and those that can.
void TestAttributes()
{
  // Points are numbered from the lowest row: 0 to 4, then 5, 6, then 7 to 11.
  const Patches::Columns columns = Patches::FromPicture({ "#####", "#...#", "#####" });
  const Horizon horizon = OnSurface(columns, [](double, double) { return 0.0; });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto column = [&](PointId point) { return double(columns[std::size_t(point)].X); };
  const auto onlyBelow = [&](PointId point) { return point < 5 ? column(point) : nan; };
  const auto never = [&](PointId) { return nan; };
  const auto farAway = [&](PointId point) { return point == 0 || point == 7 ? 1.0 : nan; }; // corners
  const FilledColumns filled = FillHoles(columns, horizon.Heights, { column, onlyBelow, never, farAway }, {});
  CHECK_EQUAL(filled.Column.size(), 3u);
  for (std::size_t n = 0; n < 3; ++n)
  {
    CHECK(filled.Column[n] == (PlanePoint{ std::int32_t(n) + 1, 1 }));
    CHECK(std::abs(filled.Attribute[0][n] - double(n + 1)) < 1e-12);
    CHECK(std::isnan(filled.Attribute[2][n]) && std::isnan(filled.Attribute[3][n]));
  }
  // Held below only: a = (1 + b) / 2, b = (2 + a + c) / 3, c = (3 + b) / 2.
  CHECK(std::abs(filled.Attribute[1][1] - 2.0) < 1e-12 && std::abs(filled.Attribute[1][0] - 1.5) < 1e-12);
  CHECK((filled.Nearest == std::vector<PointId>{ 1, 2, 3 }));
}

/// After all holes are filled there is none, and the outlines are what they were.
void TestOutlines()
{
  Patches::Random random(11);
  for (int n = 0; n < 400; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    BoundaryOptions withHoles;
    withHoles.KeepHoles = true;
    const ExteriorBoundary before = FindExteriorBoundary(columns, withHoles);
    const FilledColumns filled =
      Fill(OnSurface(columns, [](double x, double y) { return x * y; }), AllHoles(FillMethod(n % 2), n % 3));
    Patches::Columns all = columns;
    all.insert(all.end(), filled.Column.begin(), filled.Column.end());
    const ExteriorBoundary after = FindExteriorBoundary(all, withHoles); // throws when a column comes twice
    CHECK_EQUAL(after.Boundary.Size(), after.NumberOfPatches);
    CHECK_EQUAL(std::size_t(filled.FilledHoles), before.Boundary.Size() - before.NumberOfPatches);
    const ExteriorBoundary closed = FindExteriorBoundary(columns);
    CHECK_EQUAL(after.NumberOfPatches, closed.NumberOfPatches);
    for (std::size_t loop = 0; loop < after.NumberOfPatches; ++loop)
    {
      CHECK(std::equal(
        after.Boundary.begin(loop), after.Boundary.end(loop), closed.Boundary.begin(loop), closed.Boundary.end(loop)));
    }
  }
}

/// Parts of a horizon far from each other, with nothing between: the same as side by side.
void TestFarApart()
{
  const Patches::Columns part = WithHole(4);
  Patches::Columns columns = part;
  for (const PlanePoint& column : part)
  {
    columns.push_back({ column.X + 200000000, column.Y - 100000000 });
  }
  const Surface wave = [](double x, double y) { return std::sin(0.3 * x) + std::cos(0.2 * y); };
  Horizon both = OnSurface(part, wave);
  const FilledColumns one = Fill(both, AllHoles(FillMethod::Plate, 1.0));
  both.Columns = columns;
  both.Heights.insert(both.Heights.end(), both.Heights.begin(), both.Heights.end());
  const FilledColumns two = Fill(both, AllHoles(FillMethod::Plate, 1.0));
  CHECK_EQUAL(two.Column.size(), 2 * one.Column.size());
  for (std::size_t n = 0; n < one.Column.size(); ++n)
  {
    // The one with the lower rows comes first.
    CHECK(two.Column[n] == (PlanePoint{ one.Column[n].X + 200000000, one.Column[n].Y - 100000000 }));
    CHECK(two.Column[one.Column.size() + n] == one.Column[n]);
    CHECK_EQUAL(two.Height[n], one.Height[n]);
    CHECK_EQUAL(two.Height[one.Column.size() + n], one.Height[n]);
  }
}

/// A narrow gap along the diagonal, whose bounding box has 600 times as many columns, is as it would be in a box of its
/// own columns, and takes little more memory.
void TestDiagonal()
{
  constexpr int length = 1200;
  const Patches::Columns columns =
    Square(length + 40, [](int x, int y) { return y >= 20 && y < 20 + length && x - y >= 0 && x - y < 2; });
  const Surface plane = [](double x, double y) { return 0.3 * x - 0.7 * y; };
  HoleFillingOptions options = AllHoles(FillMethod::Plate, 1.0);
  const FilledColumns filled = Fill(OnSurface(columns, plane), options);
  CHECK_EQUAL(filled.FilledHoles, 1);
  CHECK_EQUAL(filled.Column.size(), 2u * length);
  CHECK(LargestError(filled, plane) < 1e-8);

  const ColumnIndex index(columns, options.RimWidth + SiteBox::Margin);
  std::vector<std::int64_t> gap;
  for (const PlanePoint& column : filled.Column)
  {
    gap.push_back(index.Place(column));
  }
  const HoleRegion region(index, nullptr, gap, options.RimWidth);
  CHECK(region.Kind.size() < 15 * gap.size());
}

Horizon ManyHoles()
{
  Patches::Random random(3);
  const Patches::Columns columns = Square(420,
    [&random](int x, int y)
    {
      const bool isLarge = std::hypot(x - 150, y - 200) < 60.0; // more columns than are solved directly
      return isLarge || (x > 3 && y > 3 && x < 416 && y < 416 && random.Chance(y < 100 ? 0.45 : 0.1));
    });
  Horizon horizon = OnSurface(columns, [](double x, double y) { return 0.01 * x * y; });
  for (double& height : horizon.Heights)
  {
    height += random.Fraction();
  }
  return horizon;
}

void TestThreads()
{
  const Horizon horizon = ManyHoles();
  const auto fill = [&](int threads)
  {
    Detail::NumberOfThreads() = threads;
    const auto attribute = [&](PointId point) { return double(point % 17); };
    return FillHoles(horizon.Columns, horizon.Heights, { attribute }, AllHoles(FillMethod::Plate, 1.0));
  };
  const FilledColumns one = fill(1);
  CHECK(one.Column.size() > 20000u);
  for (const int threads : { 2, 5 })
  {
    const FilledColumns several = fill(threads);
    CHECK(several.Column == one.Column);
    CHECK(several.Height == one.Height);
    CHECK(several.Nearest == one.Nearest);
    CHECK(several.Attribute == one.Attribute);
  }
  Detail::NumberOfThreads() = 2;
}

void TestMonitor()
{
  const Horizon horizon = ManyHoles();
  CHECK_EQUAL(MonitorChecker::Check(20,
                [&](const Monitor& monitor) {
                  FillHoles(horizon.Columns, horizon.Heights, {}, AllHoles(FillMethod::Plate, 1.0), nullptr, monitor);
                }),
    std::string());
}

void TestNothingToFill()
{
  for (const Patches::Columns& columns :
    { Patches::Columns{}, Patches::Columns{ { 5, 7 } }, Patches::FromPicture({ "##", "##" }),
      Patches::FromPicture({ "#.#", "..." }), Patches::FromPicture({ "###", "#.#", "#.#" }) })
  {
    const FilledColumns filled = Fill(OnSurface(columns, [](double x, double) { return x; }), {});
    CHECK(filled.Column.empty() && filled.Height.empty());
    CHECK_EQUAL(filled.FilledHoles + filled.OpenHoles, 0);
  }
}

void TestErrors()
{
  const Horizon horizon = OnSurface(WithHole(2), [](double x, double) { return x; });
  const auto fill = [&](auto&& change)
  {
    HoleFillingOptions options;
    change(options);
    return Fill(horizon, options);
  };
  using Options = HoleFillingOptions;
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(
    fill([](Options& o) { o.LargestHoleSize = -1; }), "largest hole size -1, expected at least 0 columns");
  CHECK_THROWS_WITH(fill([](Options& o) { o.RimSmoothing = -0.5; }), "rim smoothing -0.5, expected 0 to 1e+06");
  CHECK_THROWS_WITH(fill([=](Options& o) { o.RimSmoothing = infinity; }), "rim smoothing inf, expected 0 to 1e+06");
  CHECK_THROWS_WITH(fill([](Options& o) { o.RimSmoothing = std::nan(""); }), "rim smoothing nan, expected 0 to 1e+06");
  CHECK_THROWS_WITH(fill([](Options& o) { o.RimWidth = 0; }), "rim width 0, expected 1 to 64 columns");
  CHECK_THROWS_WITH(
    Fill({ { { 1, 2 }, { 1, 2 } }, { 0.0, 0.0 } }, {}), "points 0 and 1 both in column (1, 2), expected at most one");
}
}

int TestHoleFilling(int, char*[])
{
  TestPolynomials();
  TestPlanes();
  TestNoise();
  TestPoorRims();
  TestSizes();
  TestAttributes();
  TestOutlines();
  TestFarApart();
  TestDiagonal();
  TestThreads();
  TestMonitor();
  TestNothingToFill();
  TestErrors();
  return Check::Result();
}
