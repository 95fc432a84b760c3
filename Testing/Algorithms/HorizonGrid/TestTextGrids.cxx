// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text grids but ZMAP+ and GXF: what is read, and what is refused in which words.

#include "GridSamples.h"

using namespace GridSamples;

namespace
{
// ---- IRAP --------------------------------------------------------------------------------------------------------
void IrapTextIsRead()
{
  CHECK(IsTheSample(Read(IrapText())));
  CHECK(IsTheSample(Read(Replace(IrapText(), " 1 2 3 4", "\t1.0D+00\r\n2 3, .4e1"))));
  std::string oneLine = IrapText();
  std::replace(oneLine.begin(), oneLine.end(), '\n', ' ');
  CHECK(IsTheSample(Read(oneLine)));
  CHECK(IsTheSample(Read("\xEF\xBB\xBF\n" + IrapText())));
}

void IrapTextTurnsAndMirrors()
{
  const double cosine = std::cos(std::acos(-1.0) / 6.0);
  const std::string turned = Replace(IrapText(), "3 0.0", "3 30.0");
  CHECK(HasLattice(Read(turned), { 1000, 5000 }, { 50 * cosine, 25 }, { -12.5, 25 * cosine }));
  CHECK(HasLattice(Read(Replace(IrapText(), "3 0.0", "3 -90")), { 1000, 5000 }, { 0, -50 }, { 25, 0 }));
  CHECK(HasLattice(Read(Replace(IrapText(), "50.0 25.0", "50.0 -25.0")), { 1000, 5000 }, { 50, 0 }, { 0, -25 }));
  CHECK(HasLattice(Read(Replace(IrapText(), "1000.0 5000.0\n", "0.0 0.0\n")), { 1000, 5000 }, { 50, 0 }, { 0, 25 }));
  CHECK_THROWS_WITH(Read(Replace(turned, "1000.0 5000.0\n", "0.0 0.0\n")),
    "line 4: a rotation around (0, 0), expected the origin, (1000, 5000)");
}

void IrapTextHeaderIsChecked()
{
  CHECK_THROWS_WITH(Read("-996 0 50"), "line 1: ny \"0\", expected a positive integer");
  CHECK_THROWS_WITH(Read("-996 2 x"), "line 1: dx \"x\", expected a finite number");
  CHECK_THROWS_WITH(Read("-996 2 inf"), "line 1: dx \"inf\", expected a finite number");
  CHECK_THROWS_WITH(Read("-996 2\n"), "line 2: end of file, expected dx");
  CHECK_THROWS_WITH(Read(Replace(IrapText(), "50.0 25.0", "50.0 0.0")),
    "line 4: steps of 50 and 0, expected steps other than 0, and finite coordinates");
}

void ValuesAreChecked()
{
  CHECK_THROWS_WITH(Read(Replace(IrapText(), " 1 2", " 1 z2")), "line 5: value \"z2\", expected a number");
  CHECK_THROWS_WITH(Read(Replace(IrapText(), " 1 2", " 1,2 2")), "line 5: value \"1,2\", expected a number");
  CHECK_THROWS_WITH(Read(Replace(IrapText(), " 1 2", " 1 -inf")), "line 5: value \"-inf\", expected a finite number");
  CHECK_THROWS_WITH(Read(Replace(IrapText(), " 6\n", "\n")), "line 7: end of file after 5 values, expected 6");
  CHECK_THROWS_WITH(Read(IrapText() + "7\n"), "line 7: \"7\" after the last value, expected the end of the file");
  CHECK(HasValues(Read(Replace(IrapText(), " 1 2", " nan 2")), { None, 2, 3, 4, None, 6 }));
}

/// Words for no value, also as the first one, and those that the user adds.
void WordsMeanNoValue()
{
  for (const std::string word : { "nan", "NULL", "n/a", "*****", "-1g" })
  {
    for (const std::string& file : { IrapText(), SurferText(), EsriGrid(), Gxf(), Cps3(), Zmap() })
    {
      std::string changed = file;
      const std::size_t first = file == Zmap() ? changed.find("4", changed.find("@\n"))
        : file == EsriGrid()                   ? changed.find("4 -9999")
        : file == Cps3()                       ? changed.find("4 1 0.1E")
        : file == Gxf()                        ? changed.find("1 2 3", changed.find("#GRID"))
                                               : changed.find("1 2 3");
      changed.replace(first, 1, word);
      std::istringstream stream(changed);
      const HorizonGrid grid = SeismicHorizons::ReadHorizonGrid(
        stream, SeismicHorizons::Monitor(), SeismicHorizons::GridBufferSize, SeismicHorizons::NullValues("-1g"));
      CHECK_EQUAL(std::count_if(grid.Z.begin(), grid.Z.end(), [](double z) { return std::isnan(z); }), 2);
    }
  }
  CHECK_THROWS_WITH(
    Read(Replace(IrapText(), " 1 2", " -1g 2")), "line 5: value \"-1g\", expected a number; NullValues lists");
  CHECK(HasValues(
    Read(Replace(EsriGrid(), "NODATA_value -9999\n4 -9999", "NODATA_value null\nnull 4")), { 1, 2, 3, None, 4, 6 }));
}

/// Where commas do not separate numbers.
void DecimalCommasAreRead()
{
  for (const std::string& file : { IrapText(), SurferText(), EsriGrid() })
  {
    std::string commas = Replace(file, "2 3", "2,25 3,5");
    std::replace(commas.begin(), commas.end(), '.', ',');
    for (const std::size_t buffer : { std::size_t(4), SeismicHorizons::GridBufferSize })
    {
      CHECK(HasValues(Read(commas, buffer), Read(Replace(file, "2 3", "2.25 3.5")).Z));
    }
  }
  CHECK_THROWS_WITH(Read("ncols 2\nnrows 1\nxllcenter 0\nyllcenter 0\ncellsize 5\n1,522 1,523\n"),
    "line 6: numbers such as 1,522 with decimal commas or thousands separators");
  CHECK(IsTheSample(Read(Replace(Zmap(), "1000.0, 1100.0, 5000.0, 5025.0", "1000,1100,5000,5025"))));
}

/// Memory is taken for what the file can hold.
void HugeCountsCostNothing()
{
  const std::string huge = Replace(Replace(IrapText(), "-996 2", "-996 1000000000"), "\n3 ", "\n1000000000 ");
  CHECK_THROWS_WITH(Read(huge), "line 7: end of file after 6 values, expected 1000000000000000000");
}

// ---- CPS-3 -------------------------------------------------------------------------------------------------------
void Cps3IsRead()
{
  const HorizonGrid grid = Read(Cps3());
  CHECK(IsTheSample(grid));
  CHECK_EQUAL(grid.Name, "top");
  CHECK(IsTheSample(Read("! comment\n" + Replace(Cps3(), "FSXINC 50.0 25.0", "FSXINC 25.0 50.0"))));
  CHECK(IsTheSample(Read(Replace(Cps3(), "FSLIMI 1000.0 1100.0", "FSLIMI \"1000.0\" \"1100.0\""))));
  CHECK(IsTheSample(Read(Replace(Cps3(), "->top\n", ""))));
  // The null value is the sixth word, whatever comes behind it, and 1e30 is none in any file.
  CHECK(IsTheSample(Read(Replace(Cps3(), "FSASCI 0 1 COMPUTED 0 1.0E+30", "FSASCI 0 1 \"Computed\" 0 1E30 3"))));
  CHECK(IsTheSample(Read(Replace(Cps3(), "COMPUTED 0 1.0E+30", "COMPUTED 0 -999.25"))));
}

void Cps3HeaderIsChecked()
{
  CHECK_THROWS_WITH(
    Read(Replace(Cps3(), "FSLIMI", "FSLOST")), "line 7: no line FSLIMI, expected one before the values");
  CHECK_THROWS_WITH(Read(Replace(Cps3(), "FSNROW 2 3", "FSNROW 2")), "line 4: end of the line, expected nx");
  CHECK_THROWS_WITH(
    Read(Replace(Cps3(), "0 1.0E+30", "")), "line 1: null value \"COMPUTED\", expected a finite number");
  CHECK_THROWS_WITH(Read(Replace(Cps3(), "FSLIMI 1000.0 1100.0", "FSLIMI 1000.0 1000.0")),
    "line 3: x from 1000 to 1000 for 3 nodes, expected increasing values");
}

// ---- EarthVision -------------------------------------------------------------------------------------------------
void EarthVisionIsRead()
{
  const HorizonGrid grid = Read(EarthVision());
  CHECK(IsTheSample(grid));
  CHECK_EQUAL(grid.Survey.VerticalUnit, "m");
  CHECK_EQUAL(grid.Survey.VerticalDomain, "depth");
  CHECK_EQUAL(grid.Survey.HorizontalUnit, "m");
  CHECK_EQUAL(grid.Survey.CoordinateSystem, "Local Rectangular");
  CHECK(IsTheSample(Read(Replace(EarthVision(), "# Grid_size: 3 x 2\n", ""))));
  CHECK(IsTheSample(Read(EarthVision() + "1050 5025 1e30 2 2\n")));
  CHECK(IsTheSample(Read(Replace(EarthVision(), "# End:", "# Null_value: -5") + "1050 5025 -5.0 2 2\n")));
  CHECK_EQUAL(Read(Replace(EarthVision(), "3 x 2", "4x5")).Z.size(), 20u);
  CHECK_EQUAL(Read(Replace(EarthVision(), "# End:", "# Z_units: ms")).Survey.VerticalUnit, "ms");
}

/// Places of a file of RMS, turned by 30 degrees, which its header states as -30.
void EarthVisionLatticeIsFitted()
{
  const std::string header = EarthVision().substr(0, EarthVision().find("# Grid_size"));
  const HorizonGrid grid = Read(header +
    "464112.4826484 5932425.0472075 -1599.9902344 2 1\n464099.9826481 5932446.6978425 -1598.1525879 2 2\n"
    "464121.6332830 5932459.1978428 -1598.6997070 3 2\n464143.2839180 5932471.6978431 -1599.9620361 4 2\n"
    "464065.8320129 5932455.8484770 -1598.2084961 1 3\n");
  CHECK_EQUAL(grid.Lattice.Columns[0], 4);
  CHECK((grid.Lattice.ColumnStep - Eigen::Vector2d(21.65063, 12.5)).norm() < 1e-3);
  CHECK((grid.Lattice.RowStep - Eigen::Vector2d(-12.5, 21.65063)).norm() < 1e-3);
}

void EarthVisionIsChecked()
{
  CHECK_THROWS_WITH(
    Read(Replace(EarthVision(), "# Field: 1 x", "#")), "line 12: no field x, expected it before the values");
  CHECK_THROWS_WITH(Read(Replace(EarthVision(), "3 x 2", "3")), "line 11: end of the line, expected number of rows");
  CHECK_THROWS_WITH(Read(EarthVision() + "1050 5025 5 2\n"), "line 17: 4 values, expected a number 5, row");
  CHECK_THROWS_WITH(Read(EarthVision() + "1050 5025 5 0 2\n"), "line 17: column \"0\", expected a positive integer");
  CHECK_THROWS_WITH(Read(EarthVision() + "1050 5025 5 4 2\n"), "line 17: column \"4\", expected at most 3");
  CHECK_THROWS_WITH(Read(EarthVision() + "1050 x 5 2 2\n"), "line 17: y \"x\", expected a finite number");
  CHECK_THROWS_WITH(Read(EarthVision() + "1100 5025 5 3 2\n"),
    "line 17: second point at column 3 and row 2, expected one for each node");
  CHECK_THROWS_WITH(Read(EarthVision() + "1060 5025 5 2 2\n"), " from its node, expected a regular lattice");
  const std::string header = EarthVision().substr(0, EarthVision().find("1000 5000"));
  CHECK_THROWS_WITH(Read(header), "0 points along one line of nodes, expected some off this line");
  CHECK_THROWS_WITH(Read(header + "0 0 1 1 1\n1 0 1 2 1\n2 0 1 3 1\n"), "3 points along one line of nodes");
  CHECK_THROWS_WITH(Read(header + "0 0 1 1 1\n1 1 1 2 1\n1 1 1 1 2\n"),
    "columns and rows of nodes along the same line of x and y, expected a lattice in the plane");
  CHECK_THROWS_WITH(Read(Replace(EarthVision(), "3 x 2", "1000000000 x 2")),
    "2000000000 nodes for 5 points, expected at most 1000 nodes for each");
}

// ---- Surfer ------------------------------------------------------------------------------------------------------
void SurferTextIsRead()
{
  CHECK(IsTheSample(Read(SurferText())));
  CHECK_EQUAL(Read(Replace(SurferText(), "4 1.70141e+38", "4 1.70140e+38")).Z[4], 1.7014e38);
  CHECK_THROWS_WITH(Read("DSAA 3 2 1 2 5"), "line 1: end of file, expected yhi");
  CHECK_THROWS_WITH(Read(Replace(SurferText(), "5025.0", "4000.0")),
    "line 4: y from 5000 to 4000 for 2 nodes, expected increasing values");
}

void OneNodeAloneHasAStep()
{
  const HorizonGrid grid = Read("DSAA 1 2 7 7 1 3 0 9 5 6");
  CHECK(HasLattice(grid, { 7, 1 }, { 1, 0 }, { 0, 2 }));
  CHECK(HasValues(grid, { 5, 6 }));
}

// ---- Esri --------------------------------------------------------------------------------------------------------
void EsriGridIsRead()
{
  CHECK(IsTheSample(Read(EsriGrid())));
  CHECK(Read(EsriGrid()).Survey.IsUpright);
  const std::string corner =
    Replace(Replace(EsriGrid(), "xllcenter 1000.0", "XLLCORNER 975.0"), "yllcenter 5000.0", "yllcorner 4987.5");
  CHECK(IsTheSample(Read(corner)));
  CHECK(IsTheSample(Read(Replace(EsriGrid(), "NODATA_value -9999\n", ""))));
  CHECK(IsTheSample(Read(Replace(Replace(EsriGrid(), "_value -9999", "_value nan"), "4 -9999", "4 nan"))));
  const HorizonGrid square = Read(Replace(EsriGrid(), "dx 50.0\ndy 25.0", "cellsize 40"));
  CHECK(HasLattice(square, { 1000, 5000 }, { 40, 0 }, { 0, 40 }));
}

void EsriGridIsChecked()
{
  CHECK_THROWS_WITH(
    Read(Replace(EsriGrid(), "nrows 2\n", "")), "line 7: no line nrows, expected one before the values");
  CHECK_THROWS_WITH(Read(Replace(EsriGrid(), "dx 50.0\n", "")), "no line cellsize, expected one before the values");
  CHECK_THROWS_WITH(Read(Replace(EsriGrid(), "ncols 3", "ncols")), "line 1: end of the line, expected ncols");
  CHECK_THROWS_WITH(Read(Replace(EsriGrid(), "dx 50.0", "dx wide")), "line 5: dx \"wide\", expected a finite number");
}

// ---- All ---------------------------------------------------------------------------------------------------------
void UnknownFilesAreRefused()
{
  CHECK_THROWS_WITH(Read(""), "empty file, expected a grid");
  const std::string expected = ", expected a grid of IRAP, STORM, ZMAP+, CPS-3, EarthVision, Surfer, GXF or Esri";
  CHECK_THROWS_WITH(Read("1 2 3\n"), "a file that begins with \"1 2 3\"" + expected);
  CHECK_THROWS_WITH(Read(std::string(5000, '\xFF')), "????...\"" + expected);
  CHECK_THROWS_WITH(Read("@FREE POINT, DATA, 80, 1\n"), expected);
  CHECK_THROWS_WITH(Read("# Type: scattered data\n# Field: 1 x\n# Field: 2 y\n# Field: 3 z\n1 2 3\n"), expected);
}
}

int TestTextGrids(int, char*[])
{
  IrapTextIsRead();
  IrapTextTurnsAndMirrors();
  IrapTextHeaderIsChecked();
  ValuesAreChecked();
  WordsMeanNoValue();
  DecimalCommasAreRead();
  HugeCountsCostNothing();
  Cps3IsRead();
  Cps3HeaderIsChecked();
  EarthVisionIsRead();
  EarthVisionLatticeIsFitted();
  EarthVisionIsChecked();
  SurferTextIsRead();
  OneNodeAloneHasAStep();
  EsriGridIsRead();
  EsriGridIsChecked();
  UnknownFilesAreRefused();
  return Check::Result();
}
