// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long edges of an even mesh may be, and where its vertices are first: on a lattice of equilateral triangles, which
// is finer where edges are shorter.

#ifndef SeismicHorizonsEdgeSizes_h
#define SeismicHorizonsEdgeSizes_h

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "Decimation.h"
#include "HeightMesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Below which points are inserted beside triangles.
double SmallestAngleOf(const MeshQuality& options);

/// 0 for any length.
double LongestAtLoops(const MeshQuality& options);

class EdgeSizes
{
public:
  /// Of a mesh of loops. Lengths are in columns. With a growth above 0, edges are at most three columns long beside loops,
  /// and longer by this part of the distance from them.
  EdgeSizes(const HeightMesh& mesh, double longest, double growth);

  /// The longest edge of a triangle there.
  double At(std::int32_t patch, const PlanePoint& place) const;

  /// Marks points of the lattices, by point.
  std::vector<unsigned char> MarkPoints() const;

private:
  /// By place, row by row: the distance from the nearest loop.
  struct Distances
  {
    PlaneBox Box;
    std::int64_t Width = 0;
    std::vector<float> Values;

    std::size_t Place(std::int64_t x, std::int64_t y) const
    {
      return std::size_t((y - this->Box.Least.Y) * this->Width + (x - this->Box.Least.X));
    }
    float& At(std::int64_t x, std::int64_t y) { return this->Values[this->Place(x, y)]; }
    float At(const PlanePoint& place) const { return this->Values[this->Place(place.X, place.Y)]; }
  };

  void MarkLoops();
  static void Spread(Distances& distances);
  void MarkLattice(std::size_t patch, double spacing, std::vector<unsigned char>& marks) const;

  const HeightMesh& Mesh;
  const double Longest;
  const double Growth;
  std::vector<Distances> Patches;
};
}

#endif
