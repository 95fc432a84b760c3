// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Improves a group of triangles, whose outer edges stay, within an error. One thread does this alone.
//
// Collapses remove vertices (Hoppe 1996, "Progressive meshes"), and the other end of the edge may move half-way and gets
// a new height. Moves take a vertex to a neighbouring column, and flips exchange diagonals (Dyn, Levin and Rippa 1990,
// "Data dependent triangulations for piecewise linear interpolation"). The cost is the sum of fourth powers of errors,
// so that errors grow evenly.

#ifndef SeismicHorizonsGroupMesh_h
#define SeismicHorizonsGroupMesh_h

#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "HeightRaster.h"
#include "PlaneMesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// What has changed around a vertex since it was tried last.
enum VertexMark : std::uint8_t
{
  TryCollapse = 1,
  TryMove = 2,
  TryAll = TryCollapse | TryMove
};

struct GroupVertex
{
  bool IsFixed = false;
  std::uint8_t Marks = TryAll;
  bool IsGone = false;
  /// Whether CollapseChosen may remove it, and what that costs.
  bool IsChosen = false;
  double Cost = 0.0;

  bool IsInner() const { return !this->IsFixed && !this->IsGone; }
};

inline std::size_t CountInner(const std::vector<GroupVertex>& vertices)
{
  return std::size_t(
    std::count_if(vertices.begin(), vertices.end(), [](const GroupVertex& vertex) { return vertex.IsInner(); }));
}

/// Changes the heights, by horizon, that a vertex in a column would get.
using ColumnRule = std::function<void(const PlanePoint&, std::vector<double>&)>;

struct Group
{
  struct Horizon
  {
    std::vector<double> Heights; // by vertex
    const HeightRaster* Raster; // of the group's patch
  };

  /// Places count from the least corner of the box. Ends of kept edges must be fixed.
  PlaneMesh Mesh;
  std::vector<GroupVertex> Vertices;
  std::vector<Horizon> Horizons;
  PlaneBox Box;
  const LinkCuts* Cuts = nullptr;
  ColumnRule Rule;
};

enum class GroupStep
{
  Collapse,
  CollapseChosen,
  FindCosts,
  Move,
  Flip,
  FitSquares
};

struct GroupOptions
{
  double Error = 0.0;
  /// Of inner edges where they cross links; may be infinite.
  double CrossingError = 0.0;
  /// In degrees: no change makes a smaller angle, unless one was smaller before.
  double SmallestAngle = 0.0;
  /// No change gives a vertex more.
  int MostTriangles = 16;
  bool FitHeights = true;
  /// The cost is the sum of this power of errors, 2 or 4.
  int Power = 4;
  /// Chosen vertices that would cost more stay.
  double MostCost = 0.0;
};

/// Repeats the steps, if there are collapses until few vertices go.
void ImproveGroup(Group& group, const GroupOptions& options, const std::vector<GroupStep>& steps, int mostRounds);
}

#endif
