// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which columns of a cell are on one side of the cuts in it. Sides are parts of the cell that links connect which are
// not cut. A crack that ends in the cell would leave one part around its tip: it is carried on there, straight to the
// border of the cell or to another crack, so that points of its two lips are never on one side.
//
//        a a a a a a
//        a a a a a a
//        ====== - - -      a, b    sides of a cell
//        b b b b b b       =       a crack, carried on by -

#ifndef SeismicHorizonsCellSides_h
#define SeismicHorizonsCellSides_h

#include "Common/LinkCuts.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class CellSides
{
public:
  /// For cells of so many columns along x and along y.
  CellSides(const LinkCuts& cuts, std::int32_t width, std::int32_t height);

  /// Whether a link between two columns of a cell, given by its least column, is cut.
  bool HasCut(const PlanePoint& cell) const;

  /// Finds the sides of a cell.
  void Find(const PlanePoint& cell);

  /// The side of a column of the cell that they were found for, from 0.
  std::int32_t operator[](const PlanePoint& column) const
  {
    return this->Side[this->Place(column.X - this->Cell.X, column.Y - this->Cell.Y)];
  }

private:
  std::size_t Place(std::int32_t x, std::int32_t y) const
  {
    return std::size_t(y) * std::size_t(this->Width) + std::size_t(x);
  }

  void ReadCuts();
  void CarryOn(std::int32_t x, std::int32_t y);
  void NumberSide(std::size_t first, std::int32_t number);

  const LinkCuts& Cuts;
  const std::int32_t Width;
  const std::int32_t Height;
  PlanePoint Cell{};
  // By the place of a column in the cell: whether the link to the next column, or to the next row, is cut.
  std::vector<unsigned char> East;
  std::vector<unsigned char> North;
  std::vector<std::int32_t> Side;
  std::vector<std::size_t> Open; // columns whose neighbours are to be looked at
};
}

#endif
