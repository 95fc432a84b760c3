// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridParsers.h"
#include "IrapHeader.h"

namespace SeismicHorizons
{
namespace
{
constexpr double FirstNull = 9999900.0;
constexpr int UnusedNumbers = 7;

IrapHeader ReadHeader(GridText& text)
{
  IrapHeader header;
  text.Word("-996");
  header.Columns[1] = text.Count("ny");
  header.Steps[0] = text.Number("dx");
  header.Steps[1] = text.Number("dy");
  header.Origin.x() = text.Number("xmin");
  text.Number("xmax");
  header.Origin.y() = text.Number("ymin");
  text.Number("ymax");
  header.Columns[0] = text.Count("nx");
  header.Degrees = text.Number("rotation");
  header.Centre.x() = text.Number("x of the rotation");
  header.Centre.y() = text.Number("y of the rotation");
  for (int n = 0; n < UnusedNumbers; ++n)
  {
    text.Number("a line of seven zeros");
  }
  return header;
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadIrapText(GridText& text)
{
  HorizonGrid grid;
  const IrapHeader header = ReadHeader(text);
  grid.Lattice = PrefixErrors(text.Place(), [&] { return IrapLattice(header); });
  grid.Z = text.Values(CountNodes(header.Columns), NullFrom(FirstNull));
  text.RequireEnd();
  return grid;
}
}
