// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridParsers.h"
#include "SurferNull.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadSurferBinary(GridBytes& bytes)
{
  HorizonGrid grid;
  bytes.Skip(4, "DSBB");
  const int nx = bytes.ReadCount<std::int16_t>("nx");
  const int ny = bytes.ReadCount<std::int16_t>("ny");
  const double xFirst = bytes.ReadFinite<double>("xlo");
  const double xLast = bytes.ReadFinite<double>("xhi");
  const double yFirst = bytes.ReadFinite<double>("ylo");
  const double yLast = bytes.ReadFinite<double>("yhi");
  grid.Lattice = PrefixErrors(bytes.Place(),
    [&] {
      return AxisLattice({ nx, ny }, { xFirst, xLast }, { yFirst, yLast });
    });
  bytes.Read<double>("zlo");
  bytes.Read<double>("zhi");
  const std::int64_t count = CountNodes(grid.Lattice.Columns);
  grid.Z.reserve(bytes.Room(count, sizeof(float)));
  bytes.ReadValues<float>(count, NullFrom(static_cast<float>(SurferNull)), grid.Z);
  bytes.RequireEnd();
  return grid;
}
}
