// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fault lines in each of the formats, and what is wrong with files.

#include "Common/Base/Errors.h"
#include "Readers/FaultLines/FaultLineFile.h"
#include "Tools/Check.h"

#include <algorithm>
#include <iostream>
#include <sstream>

using namespace SeismicHorizons;

namespace
{
/// "name/stick: x,y,z x,y,z; name: ..."
std::string ToText(const FaultLineFile& file)
{
  std::ostringstream text;
  std::size_t start = 0;
  for (std::size_t line = 0; line < file.Ends.size(); ++line)
  {
    text << (line > 0 ? "; " : "") << file.Names[line] << (file.Sticks[line].empty() ? "" : "/") << file.Sticks[line]
         << ":";
    for (; start < file.Ends[line]; ++start)
    {
      text << ' ' << file.Places[start].X << ',' << file.Places[start].Y << ',' << file.Places[start].Z;
    }
  }
  return text.str();
}

FaultLineFile ReadFile(const std::string& text, std::size_t bufferSize = 1024)
{
  std::istringstream stream(text);
  return ReadFaultLines(stream, {}, Monitor(), bufferSize);
}

/// What is read does not depend on how much is read at a time.
std::string Read(const std::string& text)
{
  const std::string whole = ToText(ReadFile(text));
  for (const std::size_t size : { 2, 3, 20, 64 })
  {
    CHECK_EQUAL(ToText(ReadFile(text, size)), whole);
  }
  return whole;
}

void PlainLines()
{
  CHECK_EQUAL(Read("1 2 3\n4 5 6\n\n7 8 9\n10 11 12\n"), ": 1,2,3 4,5,6; : 7,8,9 10,11,12");
  CHECK_EQUAL(Read("# x y z\r\n1 2 3\r\n4 5 6\r\n999.0 999.0 999.0\r\n7 8 9\r\n1 1 1"),
    ": 1,2,3 4,5,6; : 7,8,9 1,1,1"); // IRAP; a true z of 999 stays
  CHECK_EQUAL(Read("1 2 999.0\n4 5 6\n"), ": 1,2,999 4,5,6");
  CHECK_EQUAL(Read("x,y,z,fault\n1,2,3,A\n4,5,6,A\n7,8,9,B\n1,1,1,B\n"), "A: 1,2,3 4,5,6; B: 7,8,9 1,1,1");
  for (const std::string columns : { "-,X,Y,Z,Fault", "_ X Y Z Fault" })
  {
    std::istringstream skipped("1 2 3 4 A\n2 4 5 6 A\n");
    FaultTextOptions options;
    options.Columns = columns;
    CHECK_EQUAL(ToText(ReadFaultLines(skipped, options)), "A: 2,3,4 4,5,6");
  }
  CHECK_EQUAL(Read("1 2 3 F1 1\n4 5 6 F1 1\n7 8 9 F1 2\n1 1 1 F1 2\n"), "F1/1: 1,2,3 4,5,6; F1/2: 7,8,9 1,1,1");
  // A line of one point is left out.
  CHECK_EQUAL(Read("1 2 3\n\n4 5 6\n7 8 9\n"), ": 4,5,6 7,8,9");
}

void NamedLines()
{
  CHECK_EQUAL(Read("FFASCI 0 C\nFFATTR 1 2\n->North fault\n1 2 3\n4 5 6\n->South\n7 8 9\n1 1 1\n"),
    "North fault: 1,2,3 4,5,6; South: 7,8,9 1,1,1");
  CHECK_EQUAL(Read("INLINE- 10 20 1 2 3 Big fault 1\nINLINE- 10 20 4 5 6 Big fault 1\n"
                   "CROSSLINE- 10 20 7 8 9 Big fault 2\nCROSSLINE- 10 20 1 1 1 Big fault 2\n"),
    "Big fault/1: 1,2,3 4,5,6; Big fault/2: 7,8,9 1,1,1");
}

const std::string ZmapHeader = "!\n! made up\n@FREE POINT        , DATA, 80, 1\n"
                               "X (EASTING)        , 1, 1,  1,      1, 10,,    1.0E+30,,,   4, 0\n"
                               "Y (NORTHING)       , 2, 2,  1,     11, 20,,    1.0E+30,,,   4, 0\n"
                               "Z VALUE            , 3, 3,  1,     21, 30,,    1.0E+30,,,   4, 0\n"
                               "SEG I.D.           , 4, 35, 1,     31, 36,,    1.0E+30,,,   0, 0\n@\n";

void ZmapLines()
{
  // Fields touch: they are told apart by their characters.
  CHECK_EQUAL(Read(ZmapHeader +
                "123456.2501234567.25    -10.50     0\n"
                "   457359.  6782676.      17.5     0\n"
                "        1.        2.        3.     1\n"
                "        4.        5.        6.     1\n"),
    "/0: 123456,1.23457e+06,-10.5 457359,6.78268e+06,17.5; /1: 1,2,3 4,5,6");
}

void PLines()
{
  CHECK_EQUAL(Read("GOCAD PLine 1\nHEADER {\n*line*color:1 0 0\nname: F 1\n}\nPROPERTIES p\nILINE\n"
                   "PVRTX 5 1 2 3 0.5\nPVRTX 7 4 5 6 0.5\nVRTX 8 7 8 9\nSEG 5 7\nSEG 7 8\nSEG 8 5\n"
                   "ILINE\nVRTX 9 1 1 1\nVRTX 10 2 2 2\nSEG 9 10\nEND\n"),
    "F 1: 1,2,3 4,5,6 7,8,9 1,2,3; F 1: 1,1,1 2,2,2");
  CHECK_EQUAL(Read("gocad pline 1\nheader {\nName: F 1\n}\nzpositive depth\niline\nvrtx 1 1 2 3\npvrtx 2 4 5 6 0.5\n"
                   "seg 1 2\nend\n"),
    "F 1: 1,2,3 4,5,6");
  // Ids begin again in each object; z of all increases as that of the first; other objects are passed over.
  CHECK_EQUAL(Read("GOCAD VSet 1\nHEADER {name:points}\nVRTX 1 9 9 9\nEND\nGOCAD PLine 1.0\nHEADER {name:a}\n"
                   "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nZPOSITIVE Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\n"
                   "ILINE\nVRTX 1 1 2 3\nVRTX 2 4 5 6\nSEG 1 2\nEND\n"
                   "GOCAD PLine 1\nILINE\nVRTX 1 1 2 3\nVRTX 2 4 5 6\nSEG 1 2\nEND \r\n"),
    "a: 1,2,3 4,5,6; : 1,2,-3 4,5,-6");
  // Units are those of polylines alone, which must agree.
  const auto inUnits = [](const std::string& points, const std::string& first, const std::string& second)
  {
    const auto object = [](const std::string& type, const std::string& unit)
    { return "GOCAD " + type + " 1\nAXIS_UNIT m m " + unit + "\nILINE\nVRTX 1 1 2 3\nVRTX 2 4 5 6\nSEG 1 2\nEND\n"; };
    return object("VSet", points) + object("PLine", first) + object("PLine", second);
  };
  CHECK_EQUAL(ReadFile(inUnits("ft", "m", "\"m\"")).Survey.VerticalUnit, "m");
  CHECK_THROWS_WITH(ReadFile(inUnits("m", "m", "ft")), "line 16: z in ft, expected m as in the polylines before");
}

/// Whether a file that was cut off gives an error, or the first places and lines of the whole one, but for what its
/// last line of text has lost.
bool IsBeginning(const std::string& cut, const FaultLineFile& whole)
{
  try
  {
    const FaultLineFile part = ReadFile(cut);
    bool isSame = part.Places.size() <= whole.Places.size() && part.Ends.size() <= whole.Ends.size() &&
      std::equal(part.Ends.begin(), part.Ends.end() - 1, whole.Ends.begin()) &&
      std::equal(part.Names.begin(), part.Names.end() - 1, whole.Names.begin());
    for (std::size_t n = 0; isSame && n + 1 < part.Places.size(); ++n)
    {
      const SpacePoint& a = part.Places[n];
      const SpacePoint& b = whole.Places[n];
      isSame = a.X == b.X && a.Y == b.Y && a.Z == b.Z;
    }
    return isSame;
  }
  catch (const InputError& error)
  {
    return std::string(error.what()).compare(0, 5, "line ") == 0;
  }
}

void CutFiles()
{
  const std::string plain = "# x y z\n10.5 20.25 30.75 F1 1\n40.5 50 60 F1 1\n70 80 90 F2 1\n11 12 13 F2 1\n";
  const std::string irap = "10.5 20 30\r\n40 50 60.5\r\n999.0 999.0 999.0\r\n70 80 90\r\n11 12 13\r\n";
  const std::string cps = "FFASCI 0 C\nFFATTR 1 2\n->North fault\n10 20 30\n40 50 60\n->South\n70 80 90\n11 12 13\n";
  const std::string sticks = "INLINE- 10 20 1.5 2.5 3.5 Big fault 1\nINLINE- 10 20 4 5 6 Big fault 1\n"
                             "CROSSLINE- 10 20 7 8 9 Big fault 2\nCROSSLINE- 10 20 1 1 1 Big fault 2\n";
  const std::string zmap = ZmapHeader +
    "   457359.  6782676.      17.5     0\n        1.        2.        3.     0\n"
    "        4.        5.        6.     1\n        7.        8.        9.     1\n";
  const std::string pline =
    "GOCAD PLine 1\nHEADER {\nname: F 1\n}\nILINE\nVRTX 5 1.5 2 3\nVRTX 12 4 5 6\nSEG 5 12\nEND\n"
    "GOCAD PLine 1\nHEADER {name:G}\nVRTX 1 7 8 9\nVRTX 2 1 1 1\nSEG 1 2\nEND\n";
  for (const std::string& text : { plain, irap, cps, sticks, zmap, pline })
  {
    const FaultLineFile whole = ReadFile(text);
    for (std::size_t size = 0; size < text.size(); ++size)
    {
      if (!CHECK(IsBeginning(text.substr(0, size), whole)))
      {
        std::cerr << "cut after " << size << " bytes: " << text.substr(0, size) << '\n';
      }
    }
  }
  // One object is whole, and the other has no END.
  CHECK_THROWS_WITH(
    Read(pline.substr(0, pline.rfind("END"))), "line 14: end of file, expected END of the GOCAD object");
}

void WrongFiles()
{
  CHECK_THROWS_WITH(Read(""), "line 1: end of file, expected fault lines");
  CHECK_THROWS_WITH(Read("# nothing\n\n"), "line 2: end of file, expected fault lines");
  CHECK_THROWS_WITH(Read("1 2 3\n\n4 5 6\n"), "line 3: end of file, expected a fault line of two points at least");
  CHECK_THROWS_WITH(Read("some text\nof a letter\n"), "line 1: 2 fields, expected the columns X, Y, Z");
  CHECK_THROWS_WITH(Read("1 2 3\n4 five 6\n"), "line 2: \"five\", expected a finite number, y");
  CHECK_THROWS_WITH(Read("1 2 3\n4 nan 6\n"), "line 2: \"nan\", expected a finite number, y");
  CHECK_THROWS_WITH(Read("1 2\n"), "line 1: 2 fields, expected the columns X, Y, Z");
  CHECK_THROWS_WITH(Read("INLINE- 10 20 1 2 3\n"), "line 1: 6 fields of a fault stick, expected 8");
  CHECK_THROWS_WITH(Read("@FREE POINT\nX, 1, 1\n@\n"), "line 2: \"X, 1, 1\", expected a field of ZMAP+");
  CHECK_THROWS_WITH(Read("@FREE POINT\nX , 1, 1, 1, 1, 20,,\n@\n1 2\n"),
    "line 3: end of the ZMAP+ header, expected fields of the types 1 and 2, x and y");
  CHECK_THROWS_WITH(Read(ZmapHeader + "1 2 3\n"), "line 9: \"1 2 3\", expected a finite number, x");
  CHECK_THROWS_WITH(
    Read("GOCAD PLine 1\nILINE\nVRTX 1 1 2 3\n"), "line 3: end of file, expected END of the GOCAD object");
  CHECK_THROWS_WITH(Read("GOCAD PLine 1\nILINE\nVRTX 1 1 2 3\nVRTX 2 4 5 6\nSEG 1 2\nEN\nGOCAD VSet 1\nEND\n"),
    "line 7: \"GOCAD\", expected END of the GOCAD object");
  CHECK_THROWS_WITH(Read("GOCAD PLine 1\nVRTX 1 1 2\n"), "line 2: 4 words, expected a vertex: id, x, y and z");
  CHECK_THROWS_WITH(Read("GOCAD PLine 1\nVRTX a 1 2 3\n"), "line 2: \"a\", expected the id of a vertex");
  CHECK_THROWS_WITH(Read("GOCAD PLine 1\nVRTX 1 1 2 3\nVRTX 1 1 2 3\n"), "line 3: vertex id 1 repeated");
  CHECK_THROWS_WITH(
    Read("GOCAD PLine 1\nVRTX 1 1 2 3\nSEG 1 2\n"), "line 3: vertex 2, expected the id of a vertex above");
  CHECK_THROWS_WITH(Read("GOCAD PLine 1\nSEG 1\n"), "line 2: 2 words, expected SEG and two ids of vertices");
  CHECK_THROWS_WITH(Read("GOCAD TSurf 1\nEND\n"), "line 2: end of file, expected a fault line of two points at least");
}
}

int TestFaultLineFile(int, char*[])
{
  PlainLines();
  NamedLines();
  ZmapLines();
  PLines();
  CutFiles();
  WrongFiles();
  return Check::Result();
}
