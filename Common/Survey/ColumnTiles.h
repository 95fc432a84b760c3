// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnTiles_h
#define SeismicHorizonsColumnTiles_h

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <map>

namespace SeismicHorizons
{
/// Maps columns to indices of values by tiles of 32 by 32 columns, so that memory does not depend on the size of the
/// lattice.
class ColumnTiles
{
public:
  std::size_t Size() const { return this->Tiles.size() * PlacesOfTile; }

  /// i and j must not be negative. Neighbouring columns are fastest.
  std::size_t Place(int i, int j)
  {
    assert(i >= 0 && j >= 0);
    const std::array<int, 2> tile = { j / Edge, i / Edge };
    if (tile != this->LastTile)
    {
      this->FirstPlace = this->Tiles.try_emplace(tile, this->Size()).first->second;
      this->LastTile = tile;
    }
    return this->FirstPlace + std::size_t(j % Edge * Edge + i % Edge);
  }

  /// Calls visit(i, j, place) row by row, including positions outside the lattice.
  template <typename Visitor>
  void ForEachPlace(Visitor&& visit) const
  {
    for (auto row = this->Tiles.begin(); row != this->Tiles.end();)
    {
      const int tileJ = row->first[0];
      const auto end =
        std::find_if(row, this->Tiles.end(), [tileJ](const auto& tile) { return tile.first[0] != tileJ; });
      for (int n = 0; n < Edge; ++n)
      {
        for (auto tile = row; tile != end; ++tile)
        {
          const int firstI = tile->first[1] * Edge;
          const std::size_t first = tile->second + std::size_t(n * Edge);
          for (int m = 0; m < Edge; ++m)
          {
            visit(firstI + m, tileJ * Edge + n, first + std::size_t(m));
          }
        }
      }
      row = end;
    }
  }

private:
  static constexpr int Edge = 32;
  static constexpr std::size_t PlacesOfTile = std::size_t(Edge) * Edge;

  std::map<std::array<int, 2>, std::size_t> Tiles; // The first index of each tile, by j and i.
  std::array<int, 2> LastTile = { -1, -1 };
  std::size_t FirstPlace = 0;
};
}

#endif
