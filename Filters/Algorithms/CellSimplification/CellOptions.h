// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The options that all simplifications of the inside share.

#ifndef SeismicHorizonsCellOptions_h
#define SeismicHorizonsCellOptions_h

namespace SeismicHorizons
{
/// The mean, or the input point nearest to it, represents the points of a cell.
enum class RepresentativeKind
{
  Barycentre = 0,
  NearestPoint = 1
};

struct CellOptions
{
  CellOptions(int cellSize, RepresentativeKind representative = RepresentativeKind::Barycentre, bool listCells = false)
    : CellSize(cellSize)
    , Representative(representative)
    , ListCells(listCells)
  {
  }

  int CellSize; // This is in columns, at least 1.
  RepresentativeKind Representative;
  bool ListCells;
};
}

#endif
