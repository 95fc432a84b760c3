// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cuts meshes along the lines where they meet: where an edge pierces a triangle, and where three triangles meet, there is
// one vertex for all of them, and each triangle is divided along its part of the lines.
//
//         /\                 /\ .
//        /  \               /| \ .
//       /----\-----   ->   /-+--o-----
//      /      \           / .  . \ .
//     /________\         /________\ .
//
// Each decision is a sign. A sign that rounding could turn is not taken: Undecided is thrown, and the caller shakes the
// vertices. So decisions never contradict each other.

#ifndef SeismicHorizonsArrangement_h
#define SeismicHorizonsArrangement_h

#include "Common/Base/Monitor.h"
#include "Sheets.h"

#include <Eigen/Core>

#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
struct Undecided
{
  Eigen::Vector3d Place;
};

struct ArrangedTriangle
{
  SheetCorners Corners;
  std::int32_t Sheet;
};

using EdgeKey = std::uint64_t;

inline EdgeKey KeyOf(std::int32_t a, std::int32_t b)
{
  return std::uint64_t(std::uint32_t(std::min(a, b))) << 32U | std::uint32_t(std::max(a, b));
}

struct Arrangement
{
  std::vector<Eigen::Vector3d> Vertices; // of all sheets in turn, then those on lines
  std::vector<ArrangedTriangle> Triangles;
  std::unordered_set<EdgeKey> Lines; // edges where sheets meet
};

/// The sheets of a pair are cut along their lines. Throws Undecided.
Arrangement Arrange(
  const std::vector<Sheet>& sheets, const std::vector<std::pair<int, int>>& pairs, const Monitor& monitor = Monitor());
}

#endif
