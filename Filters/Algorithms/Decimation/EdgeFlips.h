// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flips sides of a mesh for which it comes nearer to the horizon: data-dependent triangulation (Dyn, Levin and Rippa
// 1990, "Data dependent triangulations for piecewise linear interpolation").

#ifndef SeismicHorizonsEdgeFlips_h
#define SeismicHorizonsEdgeFlips_h

#include "Common/Monitor.h"
#include "HeightMesh.h"
#include "MeshCost.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class EdgeFlips
{
public:
  /// Keeps references.
  EdgeFlips(HeightMesh& mesh, const MeshCost& cost)
    : Mesh(mesh)
    , Cost(cost)
  {
  }

  /// Flips all sides that gain, the largest gains first, until none does.
  void Run(const Monitor& monitor);
  /// The same beginning with the sides of some triangles, which are measured; adds all that were changed.
  void RunAround(std::vector<TriangleId>& triangles, const Monitor& monitor);

private:
  using SideId = std::int64_t; // three per triangle

  struct Candidate
  {
    SideId Side = 0;
    double Gain = 0.0;
    std::array<HeightError, 2> Errors; // of the two new triangles
  };

  void Settle(std::vector<SideId> sides, std::vector<TriangleId>& changed, const Monitor& monitor);
  void AddSides(TriangleId triangle, std::vector<SideId>& sides) const;
  std::vector<Candidate> FindCandidates(const std::vector<SideId>& sides, const Monitor& monitor) const;
  Candidate Try(SideId side) const;

  HeightMesh& Mesh;
  const MeshCost& Cost;
  std::vector<unsigned char> IsChanged; // by triangle, in one round
};
}

#endif
