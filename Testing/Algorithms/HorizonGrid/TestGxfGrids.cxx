// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// GXF grids: where the values begin and how they run, compression, headers, and the way of OpenWorks.

#include "GridSamples.h"

using namespace GridSamples;

namespace
{
std::string WithSense(const std::string& sense)
{
  return GxfHeader("#SENSE\n" + sense + "\n") + "#GRID\n1 2 3\n4 5 6\n";
}

void GxfIsRead()
{
  const HorizonGrid grid = Read(Gxf());
  CHECK(IsTheSample(grid));
  CHECK_EQUAL(grid.Name, "the top");
  CHECK(IsTheSample(Read(Gxf() + "\n#END\n! comment\n")));
  CHECK(
    IsTheSample(Read(Replace(Replace(Gxf(), "#POINTS\n3", "#points\n\"3\""), "#ROWS\n2", "#ROWS\n! comment\n 2 "))));
  CHECK(IsTheSample(Read(Replace(Gxf(), "#PTSEPARATION", "#PTSE"))));
}

void HeaderSaysUnitAndCoordinateSystem()
{
  const HorizonGrid grid =
    Read(GxfHeader("#UNIT_LENGTH\n\"ftUS\",0.3048006\n#MAP_PROJECTION\n\"UTM zone 31N\"\n\"WGS 84\",6378137\n"
                   "#MAP_DATUM_TRANSFORM\nnone\n") +
      "#GRID\n1 2 3 4 5 6");
  CHECK_EQUAL(grid.Survey.HorizontalUnit, "ftUS");
  CHECK_EQUAL(grid.Survey.CoordinateSystem, "UTM zone 31N");
  CHECK_EQUAL(Read(GxfHeader("#UNIT_LENGTH\nmetres,1\n") + "#GRID\n1 2 3 4 5 6").Survey.HorizontalUnit, "m");
  CHECK_EQUAL(Read(Replace(Gxf(), "\"the top\"", "the top")).Name, "the top");
}

/// The numbers 1 to 6 in two stored rows of three.
void SensesSayWhereValuesAre()
{
  CHECK(HasValues(Read(WithSense("1")), { 1, 2, 3, 4, 5, 6 }));
  CHECK(HasValues(Read(WithSense("-2")), { 4, 5, 6, 1, 2, 3 }));
  CHECK(HasValues(Read(WithSense("3")), { 6, 5, 4, 3, 2, 1 }));
  CHECK(HasValues(Read(WithSense("-4")), { 3, 2, 1, 6, 5, 4 }));
  // Stored rows are columns of the map: two of them, with three nodes each.
  CHECK(HasValues(Read(WithSense("-1")), { 1, 4, 2, 5, 3, 6 }));
  CHECK(HasValues(Read(WithSense("2")), { 3, 6, 2, 5, 1, 4 }));
  CHECK(HasValues(Read(WithSense("-3")), { 6, 3, 5, 2, 4, 1 }));
  CHECK(HasValues(Read(WithSense("4")), { 4, 1, 5, 2, 6, 3 }));
  for (const std::string sense : { "1", "-2", "3", "-4" })
  {
    CHECK(HasLattice(Read(WithSense(sense)), { 1000, 5000 }, { 50, 0 }, { 0, 25 }));
  }
  for (const std::string sense : { "-1", "2", "-3", "4" })
  {
    CHECK(HasLattice(Read(WithSense(sense)), { 1000, 5000 }, { 25, 0 }, { 0, 50 }));
    CHECK_EQUAL(Read(WithSense(sense)).Lattice.Columns[0], 2);
  }
  CHECK_THROWS_WITH(Read(WithSense("5")), "line 22: #SENSE 5, expected 1 to 4 or -4 to -1");
  CHECK_THROWS_WITH(Read(WithSense("0")), "line 22: #SENSE 0, expected 1 to 4 or -4 to -1");
}

void RotationIsCounterclockwise()
{
  CHECK(HasLattice(Read(GxfHeader("#ROTATION\n90\n") + "#GRID\n1 2 3 4 5 6"), { 1000, 5000 }, { 0, 50 }, { -25, 0 }));
}

void TransformIsApplied()
{
  const HorizonGrid plain = Read(Replace(Gxf(), "#GRID", "#TRANSFORM\n10,0.5\n#GRID"));
  CHECK(HasValues(plain, { 10.5, 20.5, 30.5, 40.5, None, 60.5 }));
  const HorizonGrid compressed = Read(Replace(CompressedGxf(), "#GRID", "#TRANSFORM\n10 \\\n 0.5\n#GRID"));
  CHECK(HasValues(compressed, { 10.5, 20.5, 30.5, 40.5, None, 60.5 }));
  CHECK_THROWS_WITH(Read(Replace(Gxf(), "#GRID", "#TRANSFORM\n10\n#GRID")),
    "line 20: end of the line, expected the offset of #TRANSFORM");
  CHECK_THROWS_WITH(
    Read(Replace(Gxf(), "#GRID", "#TRANSFORM\n1e308 0\n#GRID")), "expected a finite number after #TRANSFORM");
  CHECK_THROWS_WITH(
    Read(Replace(CompressedGxf(), "#GRID", "#TRANSFORM\n1e308 0\n#GRID")), "expected a finite number after #TRANSFORM");
}

void CompressedValuesAreRead()
{
  CHECK(IsTheSample(Read(CompressedGxf())));
  const std::string header = GxfHeader("#GTYPE\n2\n") + "#GRID\n";
  CHECK(HasValues(Read(header + "&%~~%%\n%%%%%%"), { 90, 89 * 90 + 89, 0, 0, 0, 0 }));
  CHECK(HasValues(Read(header + "\"\"%)%'\n\"?%'!?\n"), { 2, 2, 2, 2, None, None }));
  CHECK(HasValues(Read(header + "\"\"\n%+\n\n%(\n"), { 3, 3, 3, 3, 3, 3 }));
}

void CompressedValuesAreChecked()
{
  const std::string header = GxfHeader("#GTYPE\n2\n") + "#GRID\n";
  CHECK_THROWS_WITH(Read(header + "%&%"), "line 22: \"%\" at the end of the line, expected groups of 2 characters");
  CHECK_THROWS_WITH(Read(header + "%&% %&"), "line 22: value \"% \", expected digits to the base 90");
  CHECK_THROWS_WITH(Read(header + "%&%&\n%&%&\n"), "line 24: end of file after 4 values, expected 6");
  CHECK_THROWS_WITH(Read(header + "\"\"%,%&"), "line 22: a value 7 times, expected at most 6");
  CHECK_THROWS_WITH(
    Read(header + "%&%&%&%&%&%&%&"), "line 22: \"%&\" after the last value, expected the end of the line");
  CHECK_THROWS_WITH(Read(GxfHeader("#GTYPE\n10\n") + "#GRID\n"), "#GTYPE 10, expected 0 to 9");
  const std::string huge = Replace(header, "#POINTS\n3", "#POINTS\n2000000000");
  CHECK_THROWS_WITH(
    Read(Replace(huge, "#GTYPE\n2", "#GTYPE\n5") + "\"\"\"\"\"@%%%%%%%%&"), "line 22: 1771470000 nodes for 2 points");
}

/// The numbers of a file of OpenWorks: a grid turned by 66.58 degrees, whose bounding box its header states.
void OpenWorksMeansTheBoundingBox()
{
  const std::string header =
    "#POINTS\n\"330\"\n#ROWS\n\"208\"\n#PTSEPARATION\n\"30.4800600\"\n#RWSEPARATION\n\"30.4800600\"\n#XORIGIN\n"
    "\"319046.126575\"\n#YORIGIN\n\"6231028.322731\"\n#ROTATION\n\"66.57993141719481\"\n#DUMMY\n\"1.0E30\"\n";
  std::string values = "#GRID\n";
  for (int n = 0; n < 330 * 208; ++n)
  {
    values += n % 7 == 0 ? " 1.0E30" : " 5.5";
  }
  const HorizonGrid grid = Read(header + "##XMAX\n\"330755.7011\"\n##YMAX\n\"6240803.6988\"\n" + values);
  const double angle = (66.57993141719481 - 90.0) * std::acos(-1.0) / 180.0;
  const Eigen::Vector2d columnStep = 30.48006 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d rowStep(-columnStep.y(), columnStep.x());
  CHECK(HasLattice(grid, Eigen::Vector2d(319046.126575, 6231028.322731 - 329 * columnStep.y()), columnStep, rowStep));
  // Without the other corner, or with one that says otherwise, the standard holds.
  const HorizonGrid standard = Read(header + values);
  CHECK(HasLattice(standard, { 319046.126575, 6231028.322731 }, rowStep, -columnStep));
  const HorizonGrid other = Read(header + "##XMAX\n\"323031.92\"\n##YMAX\n\"6242737.90\"\n" + values);
  CHECK(HasLattice(other, standard.Lattice.Origin, rowStep, -columnStep));
}

/// Both ways have the same bounding box.
void SquaresAlongTheAxesAreThoseOfTheStandard()
{
  const HorizonGrid grid = Read("#POINTS\n2\n#ROWS\n2\n##XMAX\n1\n##YMAX\n1\n#GRID\n1 2 3 4");
  CHECK(HasLattice(grid, { 0, 0 }, { 1, 0 }, { 0, 1 }));
}

void GxfHeaderIsChecked()
{
  CHECK_THROWS_WITH(Read("#POINTS\n3\n"), "line 3: end of file, expected #GRID");
  CHECK_THROWS_WITH(Read("#POINTS\n3\n#GRID\n1 2 3"), "line 4: no #ROWS, expected it before the values");
  CHECK_THROWS_WITH(
    Read(Replace(Gxf(), "#ROWS\n2", "#ROWS\ntwo")), "line 8: #ROWS \"two\", expected a positive integer");
  CHECK_THROWS_WITH(Read(Replace(Gxf(), "1000.0", "")), "line 14: #XORIGIN \"\", expected a finite number");
  CHECK_THROWS_WITH(Read(Replace(Gxf(), "50.0", "0")), "steps of 0 and 25, expected steps other than 0");
  CHECK_THROWS_WITH(Read(Gxf() + "7"), "\"7\" after the last value, expected the end of the file");
}
}

int TestGxfGrids(int, char*[])
{
  GxfIsRead();
  HeaderSaysUnitAndCoordinateSystem();
  SensesSayWhereValuesAre();
  RotationIsCounterclockwise();
  TransformIsApplied();
  CompressedValuesAreRead();
  CompressedValuesAreChecked();
  OpenWorksMeansTheBoundingBox();
  SquaresAlongTheAxesAreThoseOfTheStandard();
  GxfHeaderIsChecked();
  return Check::Result();
}
