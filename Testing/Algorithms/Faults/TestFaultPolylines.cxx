// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cuts along given lines: which links, on which side of a line columns come to lie, and lines that lie anywhere.

#include "FaultPictures.h"
#include "Generator/SmoothNoise.h"
#include "Tools/Check.h"

#include <limits>

using namespace SeismicHorizons;

namespace
{
ColumnHeights Flat(int width = 6, int length = 5)
{
  return MakeHeights(width, length, [](int i, int) { return double(i); });
}

void CutsBetweenColumns()
{
  const FaultLines line = CutAlong(Flat(), { { { 2.5, -1.0 }, { 2.5, 2.5 } } });
  CHECK_EQUAL(ToText(line), "E(2,0) E(2,1) E(2,2)");
  CHECK_EQUAL(line.Size(), 1U);
  CHECK_EQUAL(line[0].Throw, 1.0);
  CHECK_EQUAL(line[0].Middle, 2.5);
  // A slanted one steps from block to block.
  CHECK_EQUAL(ToText(CutAlong(Flat(), { { { 0.5, 0.5 }, { 2.5, 1.5 } } })), "N(1,0) E(1,1) N(2,1)");
  // Within one block, through one place, or no place at all: nothing.
  CHECK_EQUAL(CutAlong(Flat(), { { { 1.2, 1.2 }, { 1.8, 1.7 } }, { { 2.5, 2.5 } }, {} }).Size(), 0U);
}

void TurnsLeftUp()
{
  // The higher side is to the east: the line goes south, so that it is on its left.
  const FaultLines line = CutAlong(Flat(), { { { 2.5, 0.5 }, { 2.5, 2.5 } } });
  CHECK(!line[0].IsForward);
  CHECK_EQUAL(line[0].Place.Column.Y, 2);
  CHECK_EQUAL(line[0].LeftThrow(), 1.0);
}

void RunsThroughColumns()
{
  // Exactly through columns, and back: the same side each time.
  CHECK_EQUAL(ToText(CutAlong(Flat(), { { { 2.0, 0.5 }, { 2.0, 2.5 } } })), "E(2,1) E(2,2)");
  CHECK_EQUAL(ToText(CutAlong(Flat(), { { { 2.0, 2.5 }, { 2.0, 0.5 } } })), "E(2,1) E(2,2)");
  CHECK(AreChains(CutAlong(Flat(), { { { 0.0, 0.0 }, { 4.0, 4.0 }, { 1.0, 1.0 } } })));
}

void LiesOutside()
{
  CHECK_EQUAL(CutAlong(Flat(), { { { -5.0, 9.0 }, { 20.0, 9.0 } } }).Size(), 0U);
  CHECK_EQUAL(CutAlong(Flat(), { { { -1e300, 1e300 }, { -1e300, -1e300 } } }).Size(), 0U);
  // Which ends far away too, by a part of the way that is rounded to all of it.
  CHECK_EQUAL(CutAlong(Flat(), { { { 1.0, 1e94 }, { 4.0, 5e25 } } }).Size(), 0U);
  // In, out and in again: two lines.
  const FaultLines twice = CutAlong(Flat(), { { { 2.5, 1.5 }, { 2.5, -9.0 }, { 3.5, -9.0 }, { 3.5, 1.5 } } });
  CHECK_EQUAL(twice.Size(), 2U);
  CHECK_EQUAL(ToText(twice), "E(2,0) E(3,0) E(2,1) E(3,1)");
  // From far away, exactly the same links.
  CHECK_EQUAL(ToText(CutAlong(Flat(), { { { 2.5, -1e9 }, { 2.5, 1e9 } } })), "E(2,0) E(2,1) E(2,2) E(2,3) E(2,4)");
  CHECK_EQUAL(
    ToText(CutAlong(Flat(), { { { 2.5, -1.7e308 }, { 2.5, 1.7e308 } } })), "E(2,0) E(2,1) E(2,2) E(2,3) E(2,4)");
}

/// Places of such lines are rounded to far more than the horizon: some line of links, at once.
void ComesFromVeryFarAway()
{
  for (const double far : { 1e16, 1e25, 1e300, 1.7e308 })
  {
    for (const FaultPolyline& line :
      { FaultPolyline{ { -far, -far }, { far, far } }, { { -far, 0.3 * far }, { far, -0.3 * far } },
        { { 2.5, 2.5 }, { far, -far } }, { { far, 1.0 }, { 1.0, far } } })
    {
      CHECK(AreChains(CutAlong(Flat(), { line })));
    }
  }
}

void CrossesItself()
{
  // A link that a line meets twice is cut once.
  const FaultPolyline eight = { { 0.5, 0.5 }, { 3.5, 3.5 }, { 0.5, 3.5 }, { 3.5, 0.5 }, { 0.5, 0.5 }, { 1.5, 1.5 } };
  const FaultLines lines = CutAlong(Flat(), { eight });
  CHECK(AreChains(lines));
  CHECK(SortLinks(lines).size() < lines.NumberOfLinks());
  // Of two lines in one place the first has the links.
  const FaultLines both = CutAlong(Flat(), { { { 2.5, 0.5 }, { 2.5, 2.5 } }, { { 2.4, 0.5 }, { 2.4, 3.5 } } });
  const std::vector<LinkOfLine> links = SortLinks(both);
  CHECK_EQUAL(links.size(), 3U);
  CHECK_EQUAL(links[0].Line, 0U);
  CHECK_EQUAL(links[2].Line, 1U);
}

void MissingColumnsHaveNoThrow()
{
  const ColumnHeights gap =
    MakeHeights(6, 5, [](int i, int) { return i == 3 ? std::numeric_limits<double>::quiet_NaN() : 7.0; });
  const FaultLines line = CutAlong(gap, { { { 2.5, 0.5 }, { 2.5, 1.5 } } });
  CHECK_EQUAL(ToText(line), "E(2,1)");
  CHECK(std::isnan(line[0].Throw));
  CHECK_EQUAL(line[0].Middle, 7.0);
}

/// A random closed polygon parts the columns inside from those outside: of two columns beside each other on different
/// sides, the link is cut.
void PolygonsPartColumns()
{
  const ColumnHeights heights = Flat(30, 30);
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    FaultPolyline polygon;
    for (int n = 0; n < 12; ++n)
    {
      const double angle = 0.5235987755982988 * n;
      const double radius = 3.0 + 10.0 * Random(seed, n, 0);
      polygon.push_back({ 14.3 + radius * std::cos(angle), 14.7 + radius * std::sin(angle) });
    }
    polygon.push_back(polygon.front());
    const auto isInside = [&polygon](int i, int j)
    {
      bool inside = false;
      for (std::size_t n = 1; n < polygon.size(); ++n)
      {
        const MapPlace& a = polygon[n - 1];
        const MapPlace& b = polygon[n];
        if ((a.Y > j) != (b.Y > j) && i < a.X + (j - a.Y) / (b.Y - a.Y) * (b.X - a.X))
        {
          inside = !inside;
        }
      }
      return inside;
    };
    const FaultLines lines = CutAlong(heights, { polygon });
    CHECK(AreChains(lines));
    std::set<std::string> cut;
    for (std::size_t n = 0; n < lines.NumberOfLinks(); ++n)
    {
      cut.insert(ToText(lines[n].Place));
    }
    int open = 0;
    for (int j = 0; j < 29; ++j)
    {
      for (int i = 0; i < 29; ++i)
      {
        open += isInside(i, j) != isInside(i + 1, j) && cut.count(ToText(LatticeLink{ { i, j }, LinkSide::East })) == 0;
        open +=
          isInside(i, j) != isInside(i, j + 1) && cut.count(ToText(LatticeLink{ { i, j }, LinkSide::North })) == 0;
      }
    }
    CHECK_EQUAL(open, 0);
  }
}

void RefusesWhatIsNotFinite()
{
  CHECK_THROWS_WITH(CutAlong(Flat(), { {}, { { 1.0, 1.0 }, { std::nan(""), 2.0 } } }),
    "fault polyline 1 with a point at (nan, 2) in columns, expected finite numbers");
}
}

int TestFaultPolylines(int, char*[])
{
  CutsBetweenColumns();
  TurnsLeftUp();
  RunsThroughColumns();
  LiesOutside();
  ComesFromVeryFarAway();
  CrossesItself();
  MissingColumnsHaveNoThrow();
  PolygonsPartColumns();
  RefusesWhatIsNotFinite();
  return Check::Result();
}
