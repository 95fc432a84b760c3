// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Columns, separators and numbers of files of any program.

#include "TextTables.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

using namespace TextTables;

namespace
{
const std::string XyzTable = "x y z\n1.5 2.5 3.5\n4.5 2.5 3.75\n";

void TestSeparators()
{
  CHECK_EQUAL(Table("1.5 2.5 3.5\n4.5   2.5\t3.75\n"), XyzTable);
  CHECK_EQUAL(Table("1.5\t2.5\t3.5\n4.5\t2.5\t3.75\n"), XyzTable);
  CHECK_EQUAL(Table("1.5,2.5,3.5\n4.5, 2.5 ,3.75\n"), XyzTable);
  CHECK_EQUAL(Table("1.5;2.5;3.5;\n4.5;2.5;3.75;\n"), XyzTable);
  CHECK_EQUAL(Table("\n  1.5 2.5 3.5  \r\n\r\n4.5 2.5 3.75\r\n\r\n"), XyzTable);
  CHECK_EQUAL(Table("\xEF\xBB\xBF"
                    "1.5 2.5 3.5\n4.5 2.5 3.75"),
    XyzTable);
  CHECK_EQUAL(Table("1.5 2.5 3.5\n# 1 2\n! 3\n4.5 2.5 3.75\n"), XyzTable);
}

void TestNumbers()
{
  CHECK_EQUAL(Table("\"1.5\",\"2.5\",'3.5'\n4.5,2.5,3.75\n"), XyzTable);
  CHECK_EQUAL(Table("0.15D+01 2.5d0 3.5\n+4.5 25e-1 .375D1\n"), XyzTable);
  CHECK_EQUAL(Table("1.5 2.5 0.30000000000000004\n1.5 3.5 12345678901234567890.0\n"),
    std::string("x y z\n1.5 2.5 0.30000000000000004\n1.5 3.5 12345678901234567168\n"));
}

void TestNulls()
{
  for (const std::string null : { "1e30", "1.0E+30", "1.0000000150474662e30", "3.4028235E+38", "-999.25", "-999.2500",
         "-99999", "9999900.0", "*", "*****", "nan", "NaN", "NULL", "none", "UNDEF", "n/a", "-" })
  {
    TextOptions options;
    options.NullValues = "-999.25 -99999 9999900";
    CHECK_EQUAL(Table("1.5 2.5 " + null + " 7.5\n4.5 2.5 3.75 " + null + "\n", options),
      std::string("x y z Attribute 1\n1.5 2.5 nan 7.5\n4.5 2.5 3.75 nan\n"));
  }
  CHECK_EQUAL(Table("1.5,2.5,,7.5\n4.5,2.5,3.75,\n"), Table("1.5,2.5,*,7.5\n4.5,2.5,3.75,*\n"));
  CHECK_EQUAL(Table("1.5\t2.5\t\t7.5\n4.5\t2.5\t3.75\t\n"), Table("1.5,2.5,*,7.5\n4.5,2.5,3.75,*\n"));
  TextOptions options;
  options.NullValues = "Void, -1";
  CHECK_EQUAL(Table("1.5 2.5 void\n4.5 -1 -1\n", options), std::string("x y z\n1.5 2.5 nan\n4.5 -1 nan\n"));
  CHECK_EQUAL(Table("1.5 2.5 -999.25\n4.5 2.5 -1\n"), std::string("x y z\n1.5 2.5 -999.25\n4.5 2.5 -1\n"));
}

/// Lines that are left out whatever is in them; what follows may be a header.
void TestHeaderLines()
{
  TextOptions options;
  options.HeaderLines = 2;
  CHECK_EQUAL(Table("7 8 9\nsurvey 12 of 2, rev 4\n1.5 2.5 3.5\n4.5 2.5 3.75\n", options), XyzTable);
  CHECK_EQUAL(Table("7 8 9\n\nZ,X,Y\n3.5,1.5,2.5\n3.75,4.5,2.5\n", options), XyzTable);
  CHECK_THROWS_WITH(Read("7 8 9\n\n1.5 2.5 3.5\n4.5 2.5\n", options), "line 4: 2 fields, expected one for each of");
  CHECK_EQUAL(Read("7 8 9\n\n1.5 2.5 3.5\n# more\n4.5 2.5 3.75\n", options).Lines.back().Line, std::int64_t(5));
  options.HeaderLines = 5;
  CHECK_THROWS_WITH(Read("1.5 2.5 3.5\n4.5 2.5 3.75\n", options), "no picks after 5 lines, expected lines of numbers");
}

void TestLatin1()
{
  CHECK(Read("Top 1.5 2.5 3.5\nTop 4.5 2.5 3.75\n").Warnings.empty());
  const PickTable picks = Read("H\xF6he 1.5 2.5 3.5\nS\xFC"
                               "d 4.5 2.5 3.75\n");
  CHECK_EQUAL(picks.Names.front(), std::string("H\xC3\xB6he"));
  CHECK_EQUAL(picks.Warnings.size(), std::size_t(1));
}

/// Points of RMS whose coordinates are all 999 end a line of points; others with such a number are points.
void TestEndsOfLines()
{
  CHECK_EQUAL(Table("1.5 2.5 3.5\n999.0 999.0 999.0\n4.5 2.5 3.75\n999 999 999\n"), XyzTable);
  for (const std::string mark : { "-999", "9999.0", "-9999", "1e30", "1.0E+30" })
  {
    CHECK_EQUAL(Table("1.5 2.5 3.5\n4.5 2.5 3.75\n" + mark + " " + mark + " " + mark + "\n"), XyzTable);
  }
  CHECK_EQUAL(
    Table("1.5 999 999\n999 2.5 999\n999 999 3\n"), std::string("x y z\n1.5 999 999\n999 2.5 999\n999 999 3\n"));
  const PickTable named = Read("x y z horizon\n1.5 2.5 3.5 Top\n999 999 999 Top\n4.5 2.5 3.75 Base\n");
  CHECK_EQUAL(named.Size(), 2u);
  CHECK(named.Horizon == std::vector<int>({ 0, 1 }));
}

/// Columns without names, by their values.
void TestGuesses()
{
  CHECK_EQUAL(Table("1 2 3.5\n1 3 4.5\n"), std::string("il xl z\n1 2 3.5\n1 3 4.5\n"));
  CHECK_EQUAL(Table("1.5 2 3.5\n1.5 3 4.5\n"), std::string("x y z\n1.5 2 3.5\n1.5 3 4.5\n"));
  CHECK_EQUAL(Table("-1 2 3.5\n1 3 4.5\n"), std::string("x y z\n-1 2 3.5\n1 3 4.5\n"));
  CHECK_EQUAL(Table("100001 2 3.5\n1 3 4.5\n"), std::string("x y z\n100001 2 3.5\n1 3 4.5\n"));
  CHECK_EQUAL(Table("500000.5 6000000.5 7 8 3.5\n500025.5 6000000.5 7 9 4.5\n"),
    std::string("il xl x y z\n7 8 500000.5 6000000.5 3.5\n7 9 500025.5 6000000.5 4.5\n"));
  CHECK_EQUAL(Table("7 8 500000.5 6000000.5 3.5\n7 9 500025.5 6000000.5 4.5\n"),
    std::string("il xl x y z\n7 8 500000.5 6000000.5 3.5\n7 9 500025.5 6000000.5 4.5\n"));
  CHECK_EQUAL(Table("Top 7 8 500000.5 6000000.5 3.5\n\"Base B\" 7 9 500025.5 6000000.5 4.5\n"),
    std::string("il xl x y z\nTop: 7 8 500000.5 6000000.5 3.5\nBase B: 7 9 500025.5 6000000.5 4.5\n"));
  CHECK_EQUAL(Table("7 8 3.5 0.5 0.25\n7 9 4.5 0.75 0.25\n8 8 1.5 0.5 0.5\n"),
    std::string("il xl z Attribute 1 Attribute 2\n7 8 3.5 0.5 0.25\n7 9 4.5 0.75 0.25\n8 8 1.5 0.5 0.5\n"));
  // The first column of text has the names.
  CHECK_EQUAL(Table("7 8 3.5 Top x\n7 9 4.5 Base y\n"), std::string("il xl z\nTop: 7 8 3.5\nBase: 7 9 4.5\n"));
}

/// Rows and columns of numbers alone, as a matrix has them: smooth, steep or of noise only.
std::string Matrix(int columns, double slope, double noise)
{
  std::string text;
  unsigned int random = 1;
  for (int j = 0; j < 30; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      random = 1664525U * random + 1013904223U;
      text += std::to_string(1500.0 + slope * i + 2.0 * j + noise * (random >> 16) / 65536.0) + " ";
    }
    text += "\n";
  }
  return text;
}

/// What has two readings is refused.
void TestTwoReadings()
{
  std::string fromZero;
  std::string byFives;
  std::string lines;
  for (int j = 0; j < 6; ++j)
  {
    for (int i = 0; i < 12; ++i)
    {
      fromZero += std::to_string(i) + " " + std::to_string(j) + " 100\n";
      byFives += std::to_string(100 + 25 * i) + " " + std::to_string(100 + 2 * j) + " 100\n";
      lines += std::to_string(100 + 4 * j) + " " + std::to_string(100 + 2 * i) + " 100\n";
    }
  }
  CHECK_THROWS_WITH(Read(fromZero), "column 1 with whole numbers from 0, so that columns 1 and 2 may be");
  CHECK_THROWS_WITH(Read(byFives), "column 1 with whole numbers in steps of 25, so that columns");
  CHECK_EQUAL(Describe(lines), std::string("plain text, separated by blanks: Inline, Crossline, Z"));
  TextOptions options;
  options.Columns = "X, Y, Z";
  CHECK_EQUAL(Read(fromZero, options).X[1], 1.0);
  options.Columns = "Inline, Crossline, Z";
  CHECK_EQUAL(Read(fromZero, options).Inline[1], 1.0);
  for (const auto& [slope, noise] : { std::pair{ 0.5, 1.0 }, { 40.0, 1.0 }, { 0.0, 9.0 }, { -3.0, 90.0 } })
  {
    const PickTable rows = Read(Matrix(32, slope, noise));
    CHECK(rows.AreRows && rows.Z.size() % 32 == 0 && rows.Inline.size() == rows.Z.size());
  }
  // Places, z and ten attributes.
  std::string picks;
  for (int n = 0; n < 100; ++n)
  {
    picks += std::to_string(5e5 + 25.5 * (n % 10)) + " " + std::to_string(6e6 + 25.5 * (n / 10)) + " " +
      std::to_string(1500.5 + n % 13);
    for (int attribute = 1; attribute < 20; ++attribute)
    {
      picks += " " + std::to_string(0.01 * attribute * (n % 7));
    }
    picks += "\n";
  }
  CHECK_EQUAL(Describe(picks).substr(0, 40), std::string("plain text, separated by blanks: X, Y, Z"));
}

/// Small coordinates behind line numbers are told from z and attributes by the map between them, which needs more than
/// one inline: the lines that are looked at are spread over the file.
void TestGuessedPlaces()
{
  std::string local;
  std::string attributes;
  for (int line = 10; line < 20; ++line)
  {
    for (int trace = 100; trace < 300; ++trace)
    {
      const std::string numbers = std::to_string(line) + " " + std::to_string(trace) + " ";
      local += numbers + std::to_string(12.5 * trace) + " " + std::to_string(25 * line) + " 1000\n";
      attributes += numbers + std::to_string(3 * line + 2 * trace) + " 0.5 7\n"; // a plane
    }
  }
  CHECK_EQUAL(Describe(local), std::string("plain text, separated by blanks: Inline, Crossline, X, Y, Z"));
  // A tenth of the lines may be wrong: reading them says so.
  std::string wrong = local;
  wrong.replace(wrong.find("15 "), 2, "1e30");
  CHECK_EQUAL(Describe(wrong), Describe(local));
  CHECK_EQUAL(Describe(attributes),
    std::string("plain text, separated by blanks: Inline, Crossline, Z, Attribute 1, Attribute 2"));
}

/// Names over columns, in a comment or not.
void TestNames()
{
  const std::string table = "il xl z Dip\n1 2 3.5 0.5\n1 3 4.5 0.75\n";
  CHECK_EQUAL(Table("Z XL Dip IL\n3.5 2 0.5 1\n4.5 3 0.75 1\n"), table);
  CHECK_EQUAL(Table("#Z XL Dip IL\n3.5 2 0.5 1\n4.5 3 0.75 1\n"), table);
  CHECK_EQUAL(Table("# by hand\n# TWT [ms], Cross-line, Dip, In_Line\n\n3.5,2,0.5,1\n4.5,3,0.75,1\n"), table);
  CHECK_EQUAL(Table("\"TWT (ms)\";\"Xline\";\"Dip\";\"Inline no.\"\n3.5;2;0.5;1\n4.5;3;0.75;1\n"), table);
  CHECK_EQUAL(Table("Depth\tTrace\tDip\tLine\n\n3.5\t2\t0.5\t1\n4.5\t3\t0.75\t1\n"), table);
  CHECK_EQUAL(Table("easting northing elevation\n1.5 2.5 3.5\n4.5 2.5 3.75\n"), XyzTable);
  CHECK_EQUAL(Table("Horizon,X,Y,Z\nTop,1.5,2.5,3.5\nTop,4.5,2.5,3.75\n"),
    std::string("x y z\nTop: 1.5 2.5 3.5\nTop: 4.5 2.5 3.75\n"));
  // Without a z the first attribute is it.
  CHECK_EQUAL(Table("IL XL Chalk Dip\n1 2 3.5 0.5\n1 3 4.5 0.75\n"), table);
  // Half of a place is an attribute.
  CHECK_EQUAL(Table("IL XL X Z\n1 2 0.5 3.5\n1 3 0.75 4.5\n"), std::string("il xl z X\n1 2 3.5 0.5\n1 3 4.5 0.75\n"));
  CHECK_EQUAL(
    Table("X Crossline Y Z\n1 2 0.5 3.5\n1 3 0.75 4.5\n"), std::string("x y z Crossline\n1 0.5 3.5 2\n1 0.75 4.5 3\n"));
  // What comes twice is an attribute, and doubles are told apart.
  CHECK_EQUAL(Table("X,Y,Z,Depth,Dip,Dip,,Remark\n1.5,2.5,3.5,4,5,6,7,a\n"),
    std::string("x y z Depth Dip Dip 2\n1.5 2.5 3.5 4 5 6\n"));
  // Words that are no names of these columns: their number differs, or they stand over text.
  CHECK_EQUAL(Table("# some picks\n1.5 2.5 3.5\n4.5 2.5 3.75\n"), XyzTable);
  CHECK_EQUAL(
    Table("# X Y Z\nTop 1.5 2.5 3.5\nTop 4.5 2.5 3.75\n"), std::string("x y z\nTop: 1.5 2.5 3.5\nTop: 4.5 2.5 3.75\n"));
}

/// Northings may come first. Names that are not known say nothing, which is a warning.
void TestForeignNames()
{
  const std::string picks = "\n2000.5;100.5;7\n2010.5;110.5;8\n";
  for (const char* names : { "Noord;Oost;Diepte", "Norte;Este;Profundidad", "Nord;Ost;Tiefe", "Nord;Est;Profondeur",
         "Norte;Leste;Profundidade", "Lat;Lon;Depth", "Latitude;Longitude;Elevation" })
  {
    CHECK_EQUAL(Table(names + picks), std::string("x y z\n100.5 2000.5 7\n110.5 2010.5 8\n"));
    CHECK(Read(names + picks).Warnings.empty());
  }
  CHECK_EQUAL(Table("Lat;Lon;X;Y;Z\n1;2;3.5;4.5;5\n"), std::string("x y z Lat Lon\n3.5 4.5 5 1 2\n"));
  const PickTable guessed = Read("Foo;Bar;Depth" + picks);
  CHECK_EQUAL(guessed.X.front(), 2000.5);
  CHECK(guessed.Warnings.front().find("columns Foo, Bar, Z are read in order as X, Y, Z") == 0);
  CHECK(Read("Top of Frigg\n2000.5 100.5 7\n2010.5 110.5 8\n").Warnings.empty());
}

/// A number that usually means no z may be a depth. Formats with a number of their own have no other.
void TestUsualNulls()
{
  TextOptions usual;
  usual.NullValues = DefaultNulls;
  const std::string picks = "1\t1\t-999\n1\t2\t-999.25\n1\t3\t-999.5\n";
  const PickTable doubtful = Read(picks, usual);
  CHECK(std::isnan(doubtful.Z[1]));
  CHECK(doubtful.Warnings.front().find(
          "-999.25 at 1 of 3 points is read as missing z, as is usual, but others have z from -999.5 to -999") == 0);
  const PickTable own = Read("# \"Inline\"\t\"Crossline\"\t\"Z\"\n# - -\n" + picks, usual);
  CHECK_EQUAL(own.Z[1], -999.25);
  CHECK(own.Warnings.empty());
  CHECK(Read("1 1 500\n1 2 -999.25\n1 3 510\n", usual).Warnings.empty());
  usual.NullValues += " -999.5";
  CHECK(Read(picks, usual).Warnings.empty());
}

void TestGivenColumns()
{
  const auto given = [](const char* columns)
  {
    TextOptions options;
    options.Columns = columns;
    return options;
  };
  const std::string text = "1 2 3 4 5\n6 7 8 9 10\n";
  CHECK_EQUAL(Table(text, given("Y, X, -, Z, Dip")), std::string("x y z Dip\n2 1 4 5\n7 6 9 10\n"));
  CHECK_EQUAL(Table(text, given("_ X _ Y Z")), Table(text, given("-, X, -, Y, Z")));
  CHECK_EQUAL(Table(text, given("Name Crossline Inline - Z")), std::string("il xl z\n1: 3 2 5\n6: 8 7 10\n"));
  CHECK_EQUAL(Table("A B C D E\n" + text, given("X,Y,Z,My own,-")), std::string("x y z My own\n1 2 3 4\n6 7 8 9\n"));
}

/// Rows of numbers, each at the place of its column and row, in pieces of any size.
void TestMatrix()
{
  const std::string row = " 1 2 3 4 5 6 7 8 9 10 11 12";
  for (const std::string& blank : { std::string("\n"), std::string(" \r\n\n") })
  {
    for (const std::size_t block : { std::size_t(16), std::size_t(1000) })
    {
      const PickTable rows = Read("1" + row + blank + "2" + row + blank + "null" + row + "\n", {}, { 64, block });
      CHECK(rows.Size() == 39 && rows.AreRows);
      for (std::size_t n = 0; n < rows.Size(); ++n)
      {
        const double i = rows.Crossline[n];
        const double j = rows.Inline[n];
        CHECK(rows.Z[n] == (i == 0.0 ? j + 1.0 : i) || (i == 0.0 && j == 2.0 && std::isnan(rows.Z[n])));
      }
    }
  }
  CHECK_THROWS_WITH(
    Read("1" + row + "\n2" + row + "\n3 4\n"), "line 3: 2 fields, expected one for each of the columns Z");
  CHECK_EQUAL(Read(Matrix(2000, 0.5, 1.0)).Z.size() % 2000, std::size_t(0));
}

/// Fields behind those that are used.
void TestMissingFields()
{
  for (const std::string separator : { " ", ",", ";", "\t" })
  {
    std::string text = "1.5 2.5 3.5\n4.5 2.5 3.75 snapped\n";
    std::replace(text.begin(), text.end(), ' ', separator.front());
    CHECK_EQUAL(Table(text), XyzTable);
    CHECK_EQUAL(Table("x" + separator + "y" + separator + "z" + separator + "remark\n" + text), XyzTable);
  }
  TextOptions options;
  options.Columns = "X,Y,Z,-,_";
  CHECK_EQUAL(Table("1.5 2.5 3.5 7 8\n4.5 2.5 3.75\n", options), XyzTable);
  CHECK_EQUAL(Table("1.5,2.5,3.5\n4.5,2.5,3.75,7\n", options), XyzTable);
  CHECK_THROWS_WITH(Read("1.5 2.5\n4.5 2.5 3.75\n", options), "line 1: 2 fields, expected one for each");
  for (const std::string text : { "1.5 2.5 3.5 7\n4.5 2.5 3.75\n", "1.5 2.5 3.5\n4.5 2.5 3.75 7\n" })
  {
    CHECK_THROWS_WITH(Read(text), ": if lines lack some at the end, Columns skips these by -");
  }
  const std::string charisma = "INLINE : 476 XLINE : 320 1.5 2.5 3.5";
  CHECK_EQUAL(Table(charisma + "\nINLINE : 477 XLINE : 320 4.5 2.5 3.75 1 a\n"),
    std::string("il xl x y z\n476 320 1.5 2.5 3.5\n477 320 4.5 2.5 3.75\n"));
  CHECK_EQUAL(Table(charisma + " F1\nINLINE : 477 XLINE : 320 4.5 2.5 3.75\n"),
    std::string("il xl x y z\n476 320 1.5 2.5 3.5\n477 320 4.5 2.5 3.75\n"));
}

/// Lines of other kinds may have anything in their other fields.
void TestWhere()
{
  const auto where = [](const std::string& chosen, const std::string& columns = {})
  {
    TextOptions options;
    options.Where = chosen;
    options.Columns = columns;
    return options;
  };
  const std::string text = "X,Y,Z,feature_name,nx\n1.5,2.5,3.5,Top,\na,b,,fault,0.5\n4.5,2.5,3.75,Top,\n,,7,,\n";
  const PickTable picks = Read(text, where("feature_name=Top"));
  CHECK_EQUAL(picks.OtherLines, std::int64_t(2));
  CHECK_EQUAL(ToText(picks), std::string("x y z nx\nTop: 1.5 2.5 3.5 nan\nTop: 4.5 2.5 3.75 nan\n"));
  CHECK_EQUAL(Table(text, where(" Feature_Name = Top ")), ToText(picks));
  for (const std::string kind : { "7", "a" })
  {
    CHECK_EQUAL(
      Table(kind + " 1.5 2.5 3.5\n8 0 0 bad\n" + kind + " 4.5 2.5 3.75\n", where("kind=" + kind, "kind,X,Y,Z")),
      XyzTable);
  }
  CHECK_EQUAL(Layout(text, where("feature_name=Top")).Describe(2),
    std::string("plain text, separated by commas: X, Y, Z, Name, nx; 2 lines of other kinds left out"));
  for (const std::string wrong : { "feature_name", "kind=Top", "=", "Top=feature_name" })
  {
    CHECK_THROWS_WITH(
      Read(text, where(wrong)), "Where \"" + wrong + "\", expected COLUMN=VALUE with one of the columns X");
  }
  CHECK_THROWS_WITH(Read(text, where("feature_name=Base")), "no picks after 1 lines with feature_name=Base, expected");
}
}

int TestTextColumns(int, char*[])
{
  TestSeparators();
  TestNumbers();
  TestNulls();
  TestHeaderLines();
  TestLatin1();
  TestEndsOfLines();
  TestGuesses();
  TestTwoReadings();
  TestGuessedPlaces();
  TestNames();
  TestForeignNames();
  TestUsualNulls();
  TestGivenColumns();
  TestMatrix();
  TestMissingFields();
  TestWhere();
  return Check::Result();
}
