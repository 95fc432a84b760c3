// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins the meshes of parts, whose vertices and edges fit, and measures the whole.

#ifndef SeismicHorizonsPartAssembly_h
#define SeismicHorizonsPartAssembly_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/DroppedPoints.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Decimation/HeightRaster.h"
#include "Filters/Algorithms/Decimation/PlaneMesh.h"
#include "PointRows.h"
#include "Surface.h"
#include "SurfacePart.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Takes the vertices of successive points, NoPoint for those without.
using TakeTargets = std::function<void(PointId first, const std::vector<PointId>& targets)>;

/// The points of a window that have a patch, but for some; `dropped` ones count on links. Points are numbered in the window.
HeightRaster RasterOfWindow(const PointWindow& window, const std::vector<PointId>& leftOut, const LinkCuts* cuts,
  const std::vector<PointId>& dropped = {});

class PartAssembly
{
public:
  /// `surface` has the boundary, whose points are numbered as the rows. All must outlive this.
  PartAssembly(const PointRows& rows, const SurfaceOptions& options, Surface& surface);

  /// Takes the heights of points of the boundary from `first` to before `end`. Threads may add others at once.
  void AddHeights(const PointWindow& window, PointId first, PointId end);
  /// Parts must be added from the lowest rows on.
  void Add(const SurfacePart& mesh);

  /// Fills the mesh and the figures of the surface, but for targets.
  void Finish(const TakeTargets& take, const Monitor& monitor);

private:
  /// Triangles of a part, up to the end, and their rows.
  struct Piece
  {
    std::int32_t FirstRow = std::numeric_limits<std::int32_t>::max();
    std::int32_t LastRow = std::numeric_limits<std::int32_t>::min();
    std::size_t End = 0;
  };
  using Vertex = std::pair<PointId, double>; // with its height

  /// Collects targets until all triangles over a point are measured.
  class TargetRows
  {
  public:
    TargetRows(const PartAssembly& whole, const TakeTargets& take)
      : Whole(whole)
      , Take(take)
    {
    }

    void Add(const PointWindow& window);
    void Set(PointId point, PointId vertex) { this->Targets[std::size_t(point - this->First)] = vertex; }
    /// Points before this one are complete.
    void Complete(PointId end);

  private:
    const PartAssembly& Whole;
    const TakeTargets& Take;
    PointId First = 0;
    std::vector<PointId> Targets;
  };

  void SimplifyLoops();
  void Measure(
    const PlaneMesh& plane, const std::vector<RaisedPoint>& raised, const TakeTargets& take, const Monitor& monitor);
  HeightRaster MakeRaster(const PointWindow& window) const;
  std::int32_t FirstRowAfter(std::size_t piece) const;
  PointId VertexOf(PointId point) const;
  DroppedPoints::const_iterator DroppedFrom(PointId point) const;

  const PointRows& Rows;
  const SurfaceOptions& Options;
  Surface& Result;
  std::vector<PointId> LoopPoints; // ascending
  std::vector<double> LoopHeights;
  std::vector<Piece> Pieces;
  std::vector<PartCorners> Triangles;
  std::vector<Vertex> Vertices; // in the end ascending, each once
  std::vector<PointId> OnOutlines;
  Loops Outlines;
  DroppedPoints Dropped;
};
}

#endif
