// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The options that all simplifications of the inside have.

#ifndef SeismicHorizonsCellOptions_h
#define SeismicHorizonsCellOptions_h

namespace SeismicHorizons
{
/// What represents the points of a cell: their mean, or the input point nearest to that.
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

  int CellSize; // columns, at least 1
  RepresentativeKind Representative;
  bool ListCells; // whether the result says which cells there were
};
}

#endif
