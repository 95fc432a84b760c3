// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the parser of GOCAD files refuses, and in which words.

#include "TSurfText.h"

using namespace SeismicHorizons;
using namespace TSurfText;

namespace
{
const std::string Start = "GOCAD TSurf 1\n";

/// Checks the message for one line, which is line 4 of a file, behind two vertices of the ids 1 and 2.
void CheckLineRefused(const std::string& line, const std::string& message)
{
  CheckRefused(Start + "VRTX 1 0 0 0\nVRTX 2 1 0 0\n" + line + "\nEND\n", "line 4: " + message);
}

/// The same behind a line with two properties, without vertices.
void CheckPropertyRefused(const std::string& lines, const std::string& message)
{
  CheckRefused(Start + "PROPERTIES p q\n" + lines + "\nEND\n", message);
}

void OtherFilesAreRefused()
{
  CheckRefused("", "line 1: empty file, expected \"GOCAD TSurf 1\"");
  CheckRefused(" \n\n", "line 3: empty file, expected \"GOCAD TSurf 1\"");
  CheckRefused("\n-996 10 20\n", "line 2: \"-996 10 20\", expected \"GOCAD TSurf 1\"");
  CheckRefused(std::string(100000, '\x47'), "line 1: \"" + std::string(32, 'G') + "...\", expected \"GOCAD TSurf 1\"");
  CheckRefused(std::string(100, '\0'), "line 1: \"" + std::string(32, '?') + "...\", expected \"GOCAD TSurf 1\"");
  CheckRefused("GOCAD VSet 1\nEND\nGOCAD PLine 1\nEND\n",
    "points of GOCAD (VSet), expected a surface of GOCAD (TSurf): open it by the reader of horizons");
  CHECK_THROWS_WITH(List("GOCAD Well 1\nEND\n"), "an object of GOCAD, expected a surface of GOCAD (TSurf): export");
  CHECK_THROWS_WITH(List("# GOCAD\nGOCAD VSet 1\nEND\n"), "1 GOCAD objects of other types");
}

void ObjectsEnd()
{
  CheckRefused(Start, "line 2: end of file, expected END of the GOCAD object of line 1");
  CheckRefused(Start + "END\n\nGOCAD VSet 1\nENDE", "line 5: end of file, expected END of the GOCAD object of line 4");
  CheckRefused(Start + "GOCAD TSurf 1\nEND\n", "line 2: \"GOCAD TSurf\", expected END of the GOCAD object of line 1");
  CheckRefused(Start + "END\nEND\n", "line 3: \"END\", expected \"GOCAD TSurf 1\"");
  CheckRefused(Start + "HEADER {\nname:x\nEND\n", "line 5: end of file, expected \"}\" of the block of line 2");
  CheckRefused("GOCAD Group 1\nBEGIN_MEMBERS\n" + Start + "END\nEND_MEMBERS\n",
    "line 6: end of file, expected END of the GOCAD object of line 1");
  CheckRefused("GOCAD Group 1\nBEGIN_MEMBERS\n" + Start + "END\n",
    "line 5: end of file, expected END of the GOCAD object of line 1");
  CheckRefused("GOCAD Group 1\nBEGIN_MEMBERS\nEND\n", "line 3: \"END\", expected \"GOCAD TSurf 1\"");
  CheckRefused(Start + "HEADER {name:x\nEND\n", "line 4: end of file, expected \"}\" of the block of line 2");
  CheckRefused(Start + "BEGIN_X y\nEND\n", "line 4: end of file, expected \"END_X\" of the block of line 2");
}

void VerticesAreChecked()
{
  const std::string id = ", expected an integer from 0 on";
  CheckLineRefused("VRTX", "VRTX id \"\"" + id);
  CheckLineRefused("VRTX x 0 0 0", "VRTX id \"x\"" + id);
  CheckLineRefused("PVRTX 3.5 0 0 0", "PVRTX id \"3.5\"" + id);
  CheckLineRefused("VRTX -3 0 0 0", "VRTX id \"-3\"" + id);
  CheckLineRefused("VRTX 9223372036854775808 0 0 0", "VRTX id \"9223372036854775808\"" + id);
  CheckLineRefused("VRTX 2 0 0 0", "VRTX with the id 2 of a vertex above, expected unique ids");
  CheckLineRefused("ATOM 1 2", "ATOM with the id 1 of a vertex above, expected unique ids");
  CheckLineRefused("VRTX 3 0 0", "VRTX value \"\" of \"z\", expected a number");
  CheckLineRefused("VRTX 3 0 abc 0", "VRTX value \"abc\" of \"y\", expected a number");
  CheckLineRefused("VRTX 3 nan 0 0", "VRTX value \"nan\" of \"x\", expected a finite number");
  CheckLineRefused("VRTX 3 1e999 0 0", "VRTX value \"1e999\" of \"x\", expected a finite number");
  CheckLineRefused("VRTX 3 0 0 0 7", "\"7\" after VRTX, expected the end of the line");
  CheckLineRefused("VRTX 3 0 0 0 CNXYZ 7", "\"7\" after VRTX, expected the end of the line");
}

void AtomsAreChecked()
{
  CheckLineRefused("ATOM 3", "ATOM id \"\", expected an integer from 0 on");
  CheckLineRefused("ATOM 3 1 5", "\"5\" after ATOM, expected the end of the line");
  CheckLineRefused("ATOM 3 9", "ATOM at vertex 9, expected the id of a vertex of the object");
  const std::string circle = "an ATOM that refers to itself, expected the id of a vertex with coordinates";
  CheckLineRefused("ATOM 3 3", circle);
  CheckLineRefused("ATOM 3 4\nATOM 4 5\nATOM 5 4", circle);
}

void TrianglesAndBordersAreChecked()
{
  CheckLineRefused("TRGL 1 2", "TRGL id \"\", expected an integer from 0 on");
  CheckLineRefused("TRGL 1 2 3", "TRGL of vertex 3, expected the id of a vertex above");
  CheckLineRefused("TRGL 1 2 1 1", "\"1\" after TRGL, expected the end of the line");
  CheckLineRefused("BSTONE 3", "BSTONE of vertex 3, expected the id of a vertex above");
  CheckLineRefused("BSTONE 1 1", "\"1\" after BSTONE, expected the end of the line");
  CheckLineRefused("BORDER 3 1", "BORDER id \"\", expected an integer from 0 on");
  CheckLineRefused("BORDER 3 1 4", "BORDER of vertex 4, expected the id of a vertex above");
  CheckLineRefused("BORDER 3 1 2 1", "\"1\" after BORDER, expected the end of the line");
}

void DescriptionsAreChecked()
{
  CheckRefused(Start + "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nZPOSITIVE Up\n",
    "line 3: ZPOSITIVE \"Up\", expected Elevation or Depth");
  CheckPropertyRefused("PROPERTIES r", "line 3: PROPERTIES repeated, expected one such line for all of");
  CheckPropertyRefused("ESIZES 1", "line 3: 1 ESIZES, expected one for each of the 2 PROPERTIES");
  CheckPropertyRefused("ESIZES 1 0", "line 3: ESIZES \"0\", expected an integer from 1 to 1024");
  CheckPropertyRefused("ESIZES 1 1025", "line 3: ESIZES \"1025\", expected an integer from 1 to 1024");
  CheckPropertyRefused("NO_DATA_VALUES 1 2 3", "line 3: 3 NO_DATA_VALUES, expected one for each of the 2 PROPERTIES");
  CheckPropertyRefused("NO_DATA_VALUES 1 x", "line 3: NO_DATA_VALUES \"x\", expected a number or **none**");
  CheckPropertyRefused("VRTX 1 0 0 0\nESIZES 1 1", "line 4: ESIZES after vertices, expected before the first");
  CheckPropertyRefused("PVRTX 1 0 0 0 5", "line 3: PVRTX value \"\" of \"q\", expected a number");
  CheckPropertyRefused("PVRTX 1 0 0 0 5 inf", "line 3: PVRTX value \"inf\" of \"q\", expected a finite number");
  CheckPropertyRefused("VRTX 1 0 0 0 5", "line 3: VRTX value \"\" of \"q\", expected a number");
  CheckPropertyRefused("PVRTX 1 0 0 0 5 6 7", "line 3: \"7\" after PVRTX, expected the end of the line");
}

/// A file that is cut off anywhere is refused, unless only the last newline is gone.
void CutFilesAreRefused()
{
  const std::string whole = Start +
    "HEADER {\nname:cut\n}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME a\nZPOSITIVE Depth\n"
    "END_ORIGINAL_COORDINATE_SYSTEM\nPROPERTIES p\nESIZES 1\nTFACE\nPVRTX 1 0 0 0 10\nPVRTX 2 1 0 0 20\n"
    "PVRTX 3 0 1 0 30\nATOM 4 1\nTRGL 1 2 3\nBSTONE 1\nBORDER 5 1 3\nBEGIN_A\nARI 1\nEND_A\nPROPERTY_CN p\nCNP "
    "1\nEND_PROPERTY_CN\nEND\n";
  CHECK_EQUAL(LoadOne(whole).Name, "cut");
  for (std::size_t length = 0; length + 1 < whole.size(); ++length)
  {
    CHECK_THROWS_WITH(Load(whole.substr(0, length)), "line ");
  }
  CHECK_EQUAL(LoadOne(whole.substr(0, whole.size() - 1)).Triangles.size(), 1u);
}

/// The list looks at headers alone, and so finds what is wrong with objects and blocks, but not with vertices.
void ListsNeedNoVertices()
{
  CHECK_EQUAL(List(Start + "VRTX x\nEND\n").Names.size(), 1u);
  CHECK_THROWS_WITH(List(Start + "VRTX x\n"), "line 3: end of file, expected END");
}
}

int TestTSurfErrors(int, char*[])
{
  OtherFilesAreRefused();
  ObjectsEnd();
  VerticesAreChecked();
  AtomsAreChecked();
  TrianglesAndBordersAreChecked();
  DescriptionsAreChecked();
  CutFilesAreRefused();
  ListsNeedNoVertices();
  return Check::Result();
}
