// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gaps that are crossed by cuts, as faults are: each side goes on for itself.

#include "HoleFixtures.h"

#include "Tools/Check.h"

using namespace HoleFixtures;

namespace
{
constexpr int Size = 30;
constexpr int Fault = 14; // the last column west of it

bool IsGap(int x, int y)
{
  return x >= 8 && x < 22 && y >= 8 && y < 22;
}

LinkCuts NoCuts()
{
  return LinkCuts(PlaneBox({ { 0, 0 }, { Size - 1, Size - 1 } }));
}

/// From one side of the square to the other, or to a row inside the gap.
LinkCuts AlongFault(int lastRow = Size - 1)
{
  LinkCuts cuts = NoCuts();
  for (std::int32_t y = 0; y <= lastRow; ++y)
  {
    cuts.CutEast({ Fault, y });
  }
  return cuts;
}

/// Two planes, 40 apart and more.
double Faulted(double x, double y)
{
  return x <= Fault ? 0.5 * x - 0.1 * y : 60.0 + 0.2 * y - 0.4 * x;
}

/// The same with folds.
double Folded(double x, double y)
{
  return Faulted(x, y) + 3.0 * std::sin(0.25 * y) + std::cos(0.2 * x);
}

void TestEachSideAlone()
{
  const Patches::Columns columns = Square(Size, IsGap);
  const LinkCuts cuts = AlongFault();
  for (const double smoothing : { 0.0, 1.0 })
  {
    const HoleFillingOptions options = AllHoles(FillMethod::Plate, smoothing);
    const FilledColumns filled = Fill(OnSurface(columns, Faulted), options, &cuts);
    CHECK_EQUAL(filled.FilledHoles, 1);
    CHECK_EQUAL(filled.Column.size(), 14u * 14u);
    CHECK(LargestError(filled, Faulted) < 1e-9);
    // Along a cut the plate is free, so that what is not a plane comes out nearly.
    const Horizon folded = OnSurface(columns, Folded);
    CHECK(LargestError(Fill(folded, options, &cuts), Folded) < 0.2 * LargestError(Fill(folded, options), Folded));
  }
  // A membrane is level across a cut.
  const Surface steps = [](double x, double) { return x <= Fault ? 1.0 : 50.0; };
  CHECK(LargestError(Fill(OnSurface(columns, steps), AllHoles(FillMethod::Membrane), &cuts), steps) < 1e-9);
  // Without the cut the throw is smeared out.
  CHECK(LargestError(Fill(OnSurface(columns, steps), AllHoles(FillMethod::Membrane)), steps) > 10.0);
}

/// Turned over the diagonal, the same comes out turned: cuts to the north are as good as those to the east.
void TestTurned()
{
  LinkCuts cuts = NoCuts();
  for (std::int32_t x = 0; x < Size; ++x)
  {
    cuts.CutNorth({ x, Fault });
  }
  const Surface turned = [](double x, double y) { return Faulted(y, x); };
  const FilledColumns filled = Fill(OnSurface(Square(Size, IsGap), turned), AllHoles(FillMethod::Plate), &cuts);
  CHECK(LargestError(filled, turned) < 1e-9);
}

/// A cut that ends in the gap divides only what is beside it.
void TestTip()
{
  const Surface plane = [](double x, double y) { return 2.0 * x - y; };
  const LinkCuts cuts = AlongFault(14);
  const FilledColumns filled = Fill(OnSurface(Square(Size, IsGap), plane), AllHoles(FillMethod::Plate, 1.0), &cuts);
  CHECK_EQUAL(filled.Column.size(), 14u * 14u);
  CHECK(LargestError(filled, plane) < 1e-8);
}

/// A part that nothing known is linked to stays open; so does its gap in the count.
void TestCutOff()
{
  LinkCuts cuts = NoCuts();
  for (std::int32_t n = 12; n < 16; ++n)
  {
    cuts.CutEast({ 11, n });
    cuts.CutEast({ 15, n });
    cuts.CutNorth({ n, 11 });
    cuts.CutNorth({ n, 15 });
  }
  for (const FillMethod method : { FillMethod::Plate, FillMethod::Membrane })
  {
    const Horizon horizon = OnSurface(Square(Size, IsGap), [](double x, double) { return x; });
    const auto attribute = [&](PointId point) { return 2.0 * horizon.Columns[std::size_t(point)].X; };
    const FilledColumns filled = FillHoles(horizon.Columns, horizon.Heights, { attribute }, AllHoles(method), &cuts);
    CHECK_EQUAL(filled.FilledHoles, 0);
    CHECK_EQUAL(filled.OpenHoles, 1);
    CHECK_EQUAL(filled.Column.size(), 14u * 14u - 16u);
    CHECK_EQUAL(filled.Height.size(), filled.Column.size());
    CHECK_EQUAL(filled.Attribute.front().size(), filled.Column.size());
    for (const PlanePoint& column : filled.Column)
    {
      CHECK(column.X < 12 || column.X >= 16 || column.Y < 12 || column.Y >= 16);
    }
  }
}

/// A part whose rim is one straight row, and one with a rim of two columns, have nothing that holds a plate.
void TestRimOnALine()
{
  const Surface steps = [](double x, double) { return x <= Fault ? 3.0 : 8.0; };
  LinkCuts cuts = AlongFault();
  for (std::int32_t n = 0; n < Size; ++n)
  {
    if (n != 10 && n != 11)
    {
      cuts.CutEast({ 7, n }); // the western part is held by two columns to the west alone
    }
    cuts.CutNorth({ n, 7 });
    cuts.CutNorth({ n, 21 });
  }
  HoleFillingOptions options = AllHoles(FillMethod::Plate, 1.0);
  options.RimWidth = 1;
  const FilledColumns filled = Fill(OnSurface(Square(Size, IsGap), steps), options, &cuts);
  CHECK_EQUAL(filled.Column.size(), 14u * 14u);
  CHECK(LargestError(filled, steps) < 1e-9);
}

/// A column with one link left, to a column beyond which there is a cut again: no stencil of a plate leads there, so
/// that it has the height of that column.
void TestOneLinkLeft()
{
  const auto isHole = [](int x, int y) { return x == 10 && y == 10; };
  const Surface slope = [](double x, double y) { return 2.0 * x + 3.0 * y; };
  LinkCuts cuts = NoCuts();
  cuts.CutEast({ 9, 10 });
  cuts.CutEast({ 10, 10 });
  cuts.CutNorth({ 10, 9 });
  cuts.CutNorth({ 10, 11 });
  for (const double smoothing : { 0.0, 1.0 })
  {
    const FilledColumns filled =
      Fill(OnSurface(Square(Size, isHole), slope), AllHoles(FillMethod::Plate, smoothing), &cuts);
    CHECK_EQUAL(filled.Column.size(), 1u);
    CHECK(LargestError(filled, [](double, double) { return 2.0 * 10 + 3.0 * 11; }) < 1e-9);
  }
}

/// Cuts far from any gap, and outside the horizon, change nothing, to the bit.
void TestCutsElsewhere()
{
  LinkCuts cuts(PlaneBox({ { -5, -5 }, { 2 * Size, 2 * Size } }));
  cuts.CutEast({ 1, 1 });
  cuts.CutNorth({ -5, 40 });
  const Horizon horizon = OnSurface(Square(Size, IsGap), [](double x, double y) { return std::sin(x) + std::cos(y); });
  const FilledColumns with = Fill(horizon, AllHoles(FillMethod::Plate, 1.0), &cuts);
  const FilledColumns without = Fill(horizon, AllHoles(FillMethod::Plate, 1.0));
  CHECK(with.Column == without.Column);
  CHECK(with.Height == without.Height);
}
}

int TestHoleFillingCuts(int, char*[])
{
  TestEachSideAlone();
  TestTurned();
  TestTip();
  TestCutOff();
  TestRimOnALine();
  TestOneLinkLeft();
  TestCutsElsewhere();
  return Check::Result();
}
