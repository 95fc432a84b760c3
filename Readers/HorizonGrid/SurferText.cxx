// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridParsers.h"
#include "SurferNull.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadSurferText(GridText& text)
{
  HorizonGrid grid;
  text.Word("DSAA");
  const int nx = text.Count("nx");
  const int ny = text.Count("ny");
  const double xFirst = text.Number("xlo");
  const double xLast = text.Number("xhi");
  const double yFirst = text.Number("ylo");
  const double yLast = text.Number("yhi");
  grid.Lattice = PrefixErrors(text.Place(),
    [&] {
      return AxisLattice({ nx, ny }, { xFirst, xLast }, { yFirst, yLast });
    });
  text.Number("zlo");
  text.Number("zhi");
  grid.Z = text.Values(CountNodes(grid.Lattice.Columns), NullFrom(SurferNull));
  text.RequireEnd();
  return grid;
}
}
