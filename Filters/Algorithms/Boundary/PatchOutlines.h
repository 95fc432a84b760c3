// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The boundaries by clockwise growth for k > 1: the faces of the graph of admissible hops (PlanarHops.h) that are
// outside of all else, and on request those that are holes.

#ifndef SeismicHorizonsPatchOutlines_h
#define SeismicHorizonsPatchOutlines_h

#include "ColumnRaster.h"
#include "ExteriorBoundary.h"
#include "FaceWalk.h"
#include "PatchComponents.h"
#include "PlanarHops.h"

#include <vector>

namespace SeismicHorizons
{
class PatchOutlines
{
public:
  PatchOutlines(const std::vector<PlanePoint>& columns, const BoundaryOptions& options, const Monitor& monitor);

  ExteriorBoundary Run(const Monitor& monitor);

private:
  /// Where a loop crosses a row.
  struct Crossing
  {
    double X;
    std::size_t Loop;
  };

  void WalkOutlines(const Monitor& monitor);
  void WalkHoles(const Monitor& monitor);
  void WalkFacesAt(std::int64_t place);
  void WalkFace(std::int64_t place, HopId hop);
  void Walk(std::int64_t start, HopId first);
  void Remember();
  std::size_t NumberOf(const FaceStep& step) const { return this->Graph.NumberOf(step.Point, step.Hop); }
  bool IsOnBorder(std::int64_t place) const;

  template <typename Condition>
  bool HasNeighbour(std::int64_t place, Condition&& condition) const
  {
    const std::int64_t up = this->Raster.Width();
    for (const std::int64_t offset : { std::int64_t(1), up + 1, up, up - 1, std::int64_t(-1), -up - 1, -up, 1 - up })
    {
      if (condition(place + offset))
      {
        return true;
      }
    }
    return false;
  }

  std::vector<std::vector<Crossing>> CrossingsOfFirstRows() const;
  void AddCrossings(std::int64_t low, std::int64_t high, std::size_t loop, const std::vector<std::int32_t>& rowNumber,
    std::vector<std::vector<Crossing>>& crossings) const;
  void AbsorbIslands();
  std::int32_t SurroundingPatch(const std::vector<std::size_t>& around) const;
  std::int64_t RowOf(std::int64_t place) const { return place / this->Raster.Width(); }
  bool IsHole(std::size_t loop) const { return loop >= this->Parts.First.size(); }

  ExteriorBoundary Collect();

  const std::vector<PlanePoint>& Columns;
  const BoundaryOptions& Options;
  const ColumnRaster Raster;
  const HopVectors Hops;
  const PlanarHops Graph;
  PatchComponents Parts;
  Loops Faces; // the outline of each component, then holes
  std::vector<std::int32_t> PatchOf; // the component that stands for each component: itself, or the one it lies in
  std::vector<bool> Walked; // hops that border a face with something inside, by their numbers in the graph
  std::vector<FaceStep> Steps; // of the walk that was last
};
}

#endif
