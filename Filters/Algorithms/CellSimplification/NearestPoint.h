// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the nearest of some points in plan: by a tree of boxes, each halved across its longer side.

#ifndef SeismicHorizonsNearestPoint_h
#define SeismicHorizonsNearestPoint_h

#include "Common/PlaneGeometry.h"
#include "Common/Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class NearestPoint
{
public:
  /// Brings `points`, at least one, into the order of the tree. Takes about n log n steps. Keeps references; `plane`
  /// holds the place of each point by its number.
  NearestPoint(const std::vector<PlanePoint>& plane, std::vector<PointId>& points);

  /// The point nearest to a place; of several that of least number. Takes about log n steps, except where very many are
  /// about equally near.
  PointId Find(const PlanePoint& place) const;

private:
  /// Points that follow each other, and their box: node n is halved into 2 n + 1 and 2 n + 2.
  struct Range
  {
    std::size_t Node;
    std::size_t First;
    std::size_t Last; // one beyond

    bool IsLeaf() const { return this->Last - this->First <= Few; }
    std::size_t Middle() const { return this->First + (this->Last - this->First) / 2; }
    Range Low() const { return { 2 * this->Node + 1, this->First, this->Middle() }; }
    Range High() const { return { 2 * this->Node + 2, this->Middle(), this->Last }; }
  };

  struct Best
  {
    PointId Point;
    std::int64_t SquaredDistance;
  };

  void Divide(const Range& range);
  void Search(const Range& range, const PlanePoint& place, Best& best) const;
  std::int64_t SquaredDistanceToBox(const Range& range, const PlanePoint& place) const;

  static constexpr std::size_t Few = 8; // points that are not divided

  const std::vector<PlanePoint>& Plane;
  std::vector<PointId>& Points;
  std::vector<PlaneBox> Boxes; // by node; none when there are few points
};
}

#endif
