// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// ZMAP+ grids: values parted by blanks or by their width, with and without points, and headers as programs write them.

#include "GridSamples.h"

using namespace GridSamples;

namespace
{
/// The sample with other values, and what the header says of them.
std::string WithValues(const std::string& layout, const std::string& values)
{
  const std::string header = Replace(Zmap(), "10, -99999.0, , 0, 1", layout);
  return header.substr(0, header.find("@\n") + 2) + values;
}

void ZmapIsRead()
{
  const HorizonGrid grid = Read(Zmap());
  CHECK(IsTheSample(grid));
  CHECK_EQUAL(grid.Name, "top");
  CHECK(IsTheSample(Read(WithValues("10, -99999.0, , 0, 1", "4 1 -99999.00 2 6\n3"))));
}

void HeadersComeInManyForms()
{
  CHECK(IsTheSample(Read(Replace(Zmap(), "\n@\n", "\n@\n+ Grid data starts after this line\n"))));
  CHECK(IsTheSample(Read(Replace(Zmap(), "5025.0\n", "5025.0,\n"))));
  CHECK(IsTheSample(Read(Replace(Zmap(), ", 0, 1\n", ",,\n"))));
  CHECK_EQUAL(Read(Replace(Zmap(), "@top HEADER ,", "@/my maps/top b.dat HEADER,")).Name, "/my maps/top b.dat");
  CHECK_EQUAL(Read(Replace(Zmap(), "@top HEADER , GRID, 5", "@ ,grid,5,")).Name, "");
}

void NullsAreNumbersOrText()
{
  CHECK(IsTheSample(Read(WithValues("10, 1.0E+30, , 0, 1", "4 1 0.1E+31 2 6 3"))));
  CHECK(IsTheSample(Read(WithValues("10, 1.0E+30, , 0, 1", "4 1 1.0000000150474662E+30 2 6 3")))); // as a float
  CHECK(IsTheSample(Read(WithValues("10, , VOID, 0, 1", "4 1 VOID 2 6 3"))));
  CHECK_THROWS_WITH(Read(WithValues("10, , , 0, 1", "4 1 VOID 2 6 3")), "line 7: value \"VOID\", expected a number");
}

void WidthPartsValuesThatTouch()
{
  CHECK(IsTheSample(Read(WithValues("8, -99999.0, , 1, 1", "4.000000     1.0-99999.0\n     2.0     6.03.000000\n"))));
  CHECK(IsTheSample(Read(WithValues("8, -99999.0, , 1, 1", "4.000000     1.0\n-99999.02.000000\n     6.03.000000\n"))));
  CHECK(IsTheSample(Read(WithValues("3, -99, , 0, 1", "004001\n-99002\n006003  \r\n"))));
  CHECK(IsTheSample(Read(WithValues("3, -99, , 0, 3", "  004001\n  -99002\n  006003\n"))));
}

/// Such a number is one, however wide the header says that values are.
void LongNumbersStayWhole()
{
  const HorizonGrid grid = Read(WithValues("4, -99999.0, , 1, 1", "4.0000001 1.5 2.5 2.5 3.5 3.12345678"));
  CHECK_EQUAL(grid.Z[3], 4.0000001);
  CHECK_EQUAL(grid.Z[2], 3.12345678);
}

void PointsMayBeLeftOutOfAllValues()
{
  const HorizonGrid grid = Read(WithValues("10, -99999, , 2, 1", "400 100 -99999 0 600 300"));
  CHECK(HasValues(grid, { 1, 0, 3, 4, None, 6 }));
  CHECK_THROWS_WITH(Read(WithValues("10, -99999, , 2, 1", "4.5 100 -99999 0 600 300")),
    "line 7: value \"100\" without a point, expected one in all values or in none as the header says 2 decimals");
  CHECK_THROWS_WITH(Read(WithValues("10, -99999, , 2, 1", "400 1.5")), "value \"1.5\" with a point");
}

void ZmapIsChecked()
{
  CHECK_THROWS_WITH(Read("@top, GRID, 5\n"), "line 2: end of file, expected width of values");
  CHECK_THROWS_WITH(
    Read(Replace(Zmap(), "10, -9", "0, -9")), "line 3: width of values \"0\", expected a positive integer");
  CHECK_THROWS_WITH(
    Read(Replace(Zmap(), "2, 3, 1000.0, 1100.0,", "2, 3, 1000.0,")), "line 4: end of the line, expected ymax");
  CHECK_THROWS_WITH(
    Read(Replace(Zmap(), "1100.0", "1e3")), "line 4: x from 1000 to 1000 for 3 nodes, expected increasing values");
  CHECK_THROWS_WITH(Read(Replace(Zmap(), "\n@\n", "\n\n")), "expected @ behind the header");
  CHECK_THROWS_WITH(Read(Zmap() + "7\n"), "line 10: \"7\" after the last value, expected the end of the file");
  CHECK_THROWS_WITH(Read(Replace(Zmap(), "         3\n", "\n")), "line 10: end of file after 5 values, expected 6");
  CHECK_THROWS_WITH(Read(WithValues("10, 1e30, , 0, 1", "4 1 2 3 4 5 6 7")), "line 7: \"6\" after the last value");
}
}

int TestZmapGrids(int, char*[])
{
  ZmapIsRead();
  HeadersComeInManyForms();
  NullsAreNumbersOrText();
  WidthPartsValuesThatTouch();
  LongNumbersStayWhole();
  PointsMayBeLeftOutOfAllValues();
  ZmapIsChecked();
  return Check::Result();
}
