// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The formats of the usual programs, each from a literal.

#include "TextTables.h"
#include "Tools/Check.h"

using namespace TextTables;

namespace
{
const std::string Picks = "500000.5\t6000000.25\t376\t914\t648.625\t5395.5\t1\n"
                          "500025.5\t6000000.25\t376\t916\t1e30\t1e30\t2\n";

void TestOpendTectColumns()
{
  const std::string table = "il xl x y z Amplitude Seed Index\n"
                            "376 914 500000.5 6000000.25 648.625 5395.5 1\n"
                            "376 916 500025.5 6000000.25 nan nan 2\n";
  const std::string lines =
    "# 1: X\n# 2: Y\n# 3: Inline\n# 4: Crossline\n# 5: Z\n# 6: Amplitude\n# 7: Seed Index\n# - - - - - - - - - -\n";
  CHECK_EQUAL(Table(lines + Picks), table);
  CHECK_EQUAL(Layout(lines + Picks).Kind == TextKind::OpendTect, true);
  const std::string names =
    "# \"X\"\t\"Y\"\t\"Inline\"\t\"Crossline\"\t\"Z\"\t\"Amplitude\"\t\"Seed Index\"\n# - - - - - - - - - -\n";
  CHECK_EQUAL(Table(names + Picks), table);
  CHECK_EQUAL(Describe(names + Picks),
    std::string("OpendTect, separated by tabs: X, Y, Inline, Crossline, Z, Amplitude, Seed Index"));
  CHECK_EQUAL(Table(Picks), std::string("il xl x y z Attribute 1 Attribute 2\n") + table.substr(table.find('\n') + 1));
}

void TestOpendTectParts()
{
  CHECK_EQUAL(Table("# \"X\"\t\"Y\"\t\"Z\"\n# - -\n1.5\t2.5\t3.5\n4.5\t2.5\t3.75\n"),
    std::string("x y z\n1.5 2.5 3.5\n4.5 2.5 3.75\n"));
  CHECK_EQUAL(Table("1.5\t2.5\t3.5\n4.5\t2.5\t3.75\n"), std::string("x y z\n1.5 2.5 3.5\n4.5 2.5 3.75\n"));
  CHECK_EQUAL(Table("# 1: Inline\n# 2: Crossline\n# 3: Z\n# - -\n1\t2\t3.5\n1\t4\t3.75\n"),
    std::string("il xl z\n1 2 3.5\n1 4 3.75\n"));
  CHECK_EQUAL(Table("1\t2\t3.5\t7\n1\t4\t3.75\t8\n"), std::string("il xl z Attribute 1\n1 2 3.5 7\n1 4 3.75 8\n"));
}

/// The header does not list the column of names. Names have blanks.
void TestOpendTectHorizons()
{
  const std::string picks = "\"green event\"\t990\t1015\t1290.5\n\"blue event\"\t990\t1016\t1293.25\n"
                            "\"green event\"\t990\t1017\t1291.5\n";
  const std::string table = "il xl z\ngreen event: 990 1015 1290.5\nblue event: 990 1016 1293.25\n"
                            "green event: 990 1017 1291.5\n";
  CHECK_EQUAL(Table("# \"Inline\"\t\"Crossline\"\t\"Z\"\n# - - -\n" + picks), table);
  CHECK_EQUAL(Table("# 1: Inline\n# 2: Crossline\n# 3: Z\n# - - -\n" + picks), table);
  CHECK_EQUAL(Table(picks), table);
  CHECK_EQUAL(Read(picks).Names.size(), std::size_t(2));
}

/// Units in brackets behind the names of columns; brackets with anything else are part of the name.
void TestUnitsOfNames()
{
  const SurveyDescription survey = Read("X (m)\tY (m)\tTWT [msec]\n1 2 3\n").Survey;
  CHECK_EQUAL(survey.HorizontalUnit, std::string("m"));
  CHECK_EQUAL(survey.VerticalUnit, std::string("ms"));
  CHECK_EQUAL(survey.VerticalDomain, std::string("time"));
  CHECK_EQUAL(Read("X\tY\tZ (picked)\n1 2 3\n").Survey.VerticalUnit, std::string());
  CHECK_EQUAL(Read("X\tY\tZ ()\n1 2 3\n").Survey.VerticalUnit, std::string());
}

/// Other columns that could be z have units of their own.
void TestUnitOfOwnColumn()
{
  const auto unit = [](const std::string& text)
  {
    const SurveyDescription survey = Read(text).Survey;
    return survey.VerticalUnit + ' ' + survey.VerticalDomain;
  };
  CHECK_EQUAL(unit("X,Y,Z,TWT (ms)\n1,2,3,4\n"), std::string(" "));
  CHECK_EQUAL(unit("X,Y,Z (ft),TWT (ms)\n1,2,3,4\n"), std::string("ft depth"));
  CHECK_EQUAL(unit("X,Y,Z,TWT\nm,m,ft,ms\n1,2,3,4\n"), std::string("ft depth"));
  CHECK_EQUAL(unit("# \"X\"\t\"Y\"\t\"Time (ms)\"\n# - -\n\"Top\"\t1\t2\t3\n"), std::string("ms time"));
  CHECK_EQUAL(unit("# Field: 1 x\n# Field: 2 y\n# Field: 3 z\n# Field: 4 twt ms\n1 2 3 4\n"), std::string(" "));
}

void TestIesx()
{
  CHECK_EQUAL(Table(OldIesx),
    std::string("il xl x y z Amplitude\nTop Chalk: 376 914 620986.88 6080882.36 648.62 5395.604\n"
                "Top Chalk: 378 916 621035.464 6080933.74 648.18 nan\n"));
  const SurveyDescription survey = Read(OldIesx).Survey;
  CHECK_EQUAL(survey.HorizontalUnit, std::string("m"));
  CHECK_EQUAL(survey.VerticalUnit, std::string("ms"));
  CHECK_EQUAL(survey.VerticalDomain, std::string("time"));
  CHECK_EQUAL(Table(NewIesx),
    std::string("il xl x y z Amplitude\nTop: 376 914 620986.88 6080882.36 648.6175060272217 5395.6040039\n"
                "Top: 378 916 621035.464 6080933.74 648.1771469116211 5703.51416\n"));
  CHECK_EQUAL(Read(NewIesx).Survey.VerticalDomain, std::string("depth"));
  CHECK_EQUAL(Table("# of a survey\n\n" + OldIesx), Table(OldIesx));
}

/// Profiles may come more than once. Where nothing has an amplitude there is no such attribute.
void TestIesxProfiles()
{
  std::string none = OldIesx;
  none.replace(none.find("5.3956040E+03"), 13, "3.4028235E+38");
  CHECK(Read(none).Attributes.empty());
  const PickTable picks = Read(NewIesx + "\n" + OldIesx + NewIesx);
  CHECK_EQUAL(picks.Names.size(), std::size_t(2));
  CHECK_EQUAL(picks.Size(), std::size_t(6));
  CHECK_EQUAL(picks.Horizon[3], 1);
  CHECK_EQUAL(picks.Horizon[4], 0);
}

void TestCharisma()
{
  CHECK_EQUAL(Table("INLINE :    476 XLINE :    320    626540.5  6073670.25   1236.5\n"
                    "INLINE :476 XLINE :321 626552.5 6073671.25 -999.25\n"),
    std::string("il xl x y z\n476 320 626540.5 6073670.25 1236.5\n476 321 626552.5 6073671.25 -999.25\n"));
  CHECK_EQUAL(Describe("INLINE :476 XLINE :321 626552.5 6073671.25 1237\n"),
    std::string("Charisma, separated by blanks and colons: -, Inline, -, Crossline, X, Y, Z"));
}

/// Properties of all objects are attributes, and z is as that of the first one.
void TestVSet()
{
  const std::string first =
    "GOCAD VSet 1\nHEADER {\nname:Top\n}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME a\n"
    "AXIS_UNIT \"m\" \"m\" \"ft\"\nZPOSITIVE Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\n"
    "PROPERTIES dip\nNO_DATA_VALUES -9\nSUBVSET\nPVRTX 1 1.5 2.5 3.5 7\nPVRTX 2 4.5 2.5 3.75 -9\nEND\n";
  const PickTable picks = Read(first);
  CHECK_EQUAL(ToText(picks), std::string("x y z dip\nTop: 1.5 2.5 3.5 7\nTop: 4.5 2.5 3.75 nan\n"));
  CHECK(!picks.Survey.IsUpright && picks.Survey.VerticalUnit == "ft" && picks.Survey.HorizontalUnit == "m");
  const std::string second =
    "gocad vset 1\nHEADER {name:Base}\nPROPERTIES w\nESIZES 2\nVRTX 5 1 2 -5\nPVRTX 6 1 3 -999.25 8 9\nEND\n";
  TextOptions options;
  options.NullValues = "-999.25 999.25";
  CHECK_EQUAL(Table(first + second, options),
    std::string("x y z dip w 1 w 2\nTop: 1.5 2.5 3.5 7 nan nan\nTop: 4.5 2.5 3.75 nan nan nan\n"
                "Base: 1 2 5 nan nan nan\nBase: 1 3 nan nan 8 9\n"));
  CHECK(Read(second).Survey.IsUpright);
  CHECK_EQUAL(Describe(first), std::string("points of GOCAD: X, Y, Z"));
  CHECK_THROWS_WITH(Read("GOCAD VSet 1\nVRTX 1 2 a 4\nEND\n"), "line 2: ");
  CHECK_THROWS_WITH(Read("GOCAD VSet 1\nVRTX 1 2 3 4\n"), ": end of file, expected END of the GOCAD object of line 1");
  options.Columns = "X,Y,Z";
  CHECK_THROWS_WITH(Read(first, options), "open it by the reader of horizons as text, without Columns");
}

void TestOpenWorks()
{
  const std::string header = "@TEST of a file\n@File_Version: 4\n"
                             "@Project_Unit_is: meters , ST_ED50_UTM31N , PROJECTED_COORDINATE_SYSTEM\n"
                             "#Export_XY_Unit__________-> meters\n#Master_Project_______->\n"
                             "#Horizon_extremes_are____-> 1277.54260  2176.45874\n"
                             "#Horizon_name____________-> Top-Fm_A\n#Export_Z_Unit___________-> feet\n"
                             "#Horizon_data_domain_____-> DEPTH\n#End_of_Horizon_ASCII_Header_\n";
  const std::string picks = " 1331.0  2009   655615.25   6627263.5   1587.5\n"
                            " 1332  2008.5   655605.5   6627255.25   1588\nEOB";
  const PickTable table = Read(header + picks);
  CHECK_EQUAL(ToText(table),
    std::string("il xl x y z\nTop-Fm_A: 1331 2009 655615.25 6627263.5 1587.5\n"
                "Top-Fm_A: 1332 2008.5 655605.5 6627255.25 1588\n"));
  CHECK_EQUAL(table.Survey.CoordinateSystem, std::string("ST_ED50_UTM31N"));
  CHECK_EQUAL(table.Survey.HorizontalUnit, std::string("m"));
  CHECK_EQUAL(table.Survey.VerticalUnit, std::string("ft"));
  CHECK_EQUAL(table.Survey.VerticalDomain, std::string("depth"));
  CHECK_EQUAL(Describe(header + picks), std::string("OpenWorks, separated by blanks: Inline, Crossline, X, Y, Z"));
}

void TestEarthVision()
{
  const std::string text = "# Type: scattered data\n# Version: 6\n# Description: picks\n# Field: 1 x\n# Field: 2 y\n"
                           "# Field: 3 z ms\n# Field: 4 column integer\n# Field: 5 row\n# Field: 6 quality\n"
                           "# Projection: Local Rectangular\n# Units: feet\n# Null_value: -7777\n# End:\n"
                           "100.5 200.5 50.25 3 1 0.5\n125.5 200.5 -7777 4 1 -7777\n";
  const PickTable picks = Read(text);
  CHECK_EQUAL(ToText(picks), std::string("il xl x y z quality\n1 3 100.5 200.5 50.25 0.5\n1 4 125.5 200.5 nan nan\n"));
  CHECK_EQUAL(picks.Survey.HorizontalUnit, std::string("ft"));
  CHECK_EQUAL(picks.Survey.VerticalUnit, std::string("ms"));
  CHECK_EQUAL(picks.Survey.VerticalDomain, std::string("time"));
  CHECK_EQUAL(
    Read("# Field: 1 x\n# Field: 2 y\n# Field: 3 z\n# Z_units: ms\n1 2 3\n").Survey.VerticalUnit, std::string("ms"));
}

void TestPetrel()
{
  const std::string text = "# Petrel Points with attributes\n# Unit in X and Y direction: m\n# Unit in depth: ft\n"
                           "VERSION 1\nBEGIN HEADER\nX\nY\nZ\nFLOAT,\"Dip angle\"\nSTRING,Remark\nEND HEADER\n"
                           "100.5 200.5 -50.25 -999 \"a b\"\n125.5 200.5 -51.5 7 \"c\"\n";
  const PickTable picks = Read(text);
  CHECK_EQUAL(ToText(picks), std::string("x y z Dip angle\n100.5 200.5 -50.25 nan\n125.5 200.5 -51.5 7\n"));
  CHECK_EQUAL(picks.Survey.HorizontalUnit, std::string("m"));
  CHECK_EQUAL(picks.Survey.VerticalUnit, std::string("ft"));
}

void TestRms()
{
  CHECK_EQUAL(Table("Float Dip angle\nInt Code\nString Zone\nDiscrete Fault\n"
                    "100.5 200.5 50.25 UNDEF 3 upper 1\n125.5 200.5 51.5 7 4 lower UNDEF\n"),
    std::string("x y z Dip angle Code Fault\n100.5 200.5 50.25 nan 3 1\n125.5 200.5 51.5 7 4 nan\n"));
}

/// Lines "i j z" behind one of sizes.
void TestLatticeIndices()
{
  CHECK_EQUAL(
    Table("# i j z\n4 3 3\n0 0 1.5\n3 1 2.5\n2 2 3.5\n"), std::string("il xl z\n0 0 1.5\n1 3 2.5\n2 2 3.5\n"));
  CHECK_EQUAL(
    Describe("4 3 2\n0 0 1.5\n3 1 2.5\n"), std::string("lattice indices, separated by blanks: Crossline, Inline, Z"));
  // A column outside the sizes: line numbers, or places.
  CHECK_EQUAL(Table("4 3 2\n5 1 1.5\n3 1 2.5\n"), std::string("il xl z\n4 3 2\n5 1 1.5\n3 1 2.5\n"));
  CHECK_THROWS_WITH(Read("4 3 2\n4 0 1.5\n3 1 2.5\n"), "column 2 with whole numbers from 0, so that columns 1 and 2 may be line numbers or coordinates");
}
}

int TestTextFormats(int, char*[])
{
  TestOpendTectColumns();
  TestOpendTectParts();
  TestOpendTectHorizons();
  TestUnitsOfNames();
  TestUnitOfOwnColumn();
  TestIesx();
  TestIesxProfiles();
  TestCharisma();
  TestVSet();
  TestOpenWorks();
  TestEarthVision();
  TestPetrel();
  TestRms();
  TestLatticeIndices();
  return Check::Result();
}
