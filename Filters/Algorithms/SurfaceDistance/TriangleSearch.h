// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A surface that is searched for its nearest triangle, in the structure that is quickest for it: a raster where it is
// about a height field, else a tree. Both give the same distances.

#ifndef SeismicHorizonsTriangleSearch_h
#define SeismicHorizonsTriangleSearch_h

#include "Common/FixedChunks.h"
#include "TriangleRaster.h"
#include "TriangleTree.h"

#include <cstdint>
#include <memory>

namespace SeismicHorizons
{
class TriangleSearch
{
public:
  /// `surface` is one that CheckSurface takes, and must outlive the search.
  explicit TriangleSearch(const TriangleSurface& surface, const Monitor& monitor = Monitor())
    : Raster(std::make_unique<TriangleRaster>(surface, monitor.Step(0.0, 0.5)))
  {
    if (!this->Raster->IsWorthwhile())
    {
      this->Raster.reset();
      this->Tree = std::make_unique<TriangleTree>(surface, monitor.Step(0.5, 1.0));
      this->Triangles = std::int64_t(surface.Triangles.size());
    }
  }

  /// The raster, or nothing: then there is a tree.
  const TriangleRaster* GetRaster() const { return this->Raster.get(); }
  const TriangleTree& GetTree() const { return *this->Tree; }

  /// Triangles that follow each other are near each other, in chunks of fixed size of so many pieces: cells or
  /// triangles.
  static constexpr std::int64_t PiecesPerChunk = 512;
  std::int64_t Pieces() const { return this->Raster ? this->Raster->Cells() : this->Triangles; }

  /// Calls visit(triangle) for those of a range of pieces. All pieces together have each triangle once.
  template <typename Visitor>
  void ForEachTriangle(std::int64_t first, std::int64_t last, Visitor&& visit) const
  {
    if (this->Raster)
    {
      this->Raster->ForEachTriangle(first, last, visit);
      return;
    }
    for (std::int64_t n = first; n < last; ++n)
    {
      visit(this->Tree->NumberOf(std::size_t(n)));
    }
  }

private:
  std::unique_ptr<TriangleRaster> Raster;
  std::unique_ptr<TriangleTree> Tree;
  std::int64_t Triangles = 0;
};
}

#endif
