// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Improves a mesh in groups of triangles (GroupMesh.h), one group per thread at a time.
//
// Edges between groups stay, so the next pass has other groups, and the result depends on the triangles alone.
//
//     first pass    | 1 | 2 | 3 |        second pass   |1|  2|  3|4|

#ifndef SeismicHorizonsMeshGroups_h
#define SeismicHorizonsMeshGroups_h

#include "Common/Base/Monitor.h"
#include "Decimation.h"
#include "GroupMesh.h"
#include "HeightMesh.h"

#include <cstddef>
#include <functional>

namespace SeismicHorizons
{
/// The mesh must keep the error, at columns and inner edges of all horizons, and still does so. Kept edges and fixed
/// vertices stay; others may move to other columns.
void ImproveInGroups(
  HeightMesh& mesh, const DecimationOptions& options, const ColumnRule& rule, const Monitor& monitor);

/// Flips edges and moves vertices, with the errors of the priority growing nowhere much. Errors of all triangles must be
/// current.
void SmoothInGroups(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor);

/// Removes vertices where that adds least to the sum of squares, within an error that grows if none can go. Stops early if
/// none can go at all.
void ReduceToNumber(
  HeightMesh& mesh, std::size_t vertices, double error, const DecimationOptions& options, const Monitor& monitor);

// The least error that is searched.
constexpr double LeastOfSearch = 1e-3;

/// Inserts points within an error. Returns the most vertices that may be left.
using InsertWithin = std::function<std::size_t(double error, const Monitor& monitor)>;

/// Searches, from the maximum error on, the error within which so many vertices are left, or a few less.
void ReduceLargestError(
  HeightMesh& mesh, const DecimationOptions& options, const InsertWithin& insert, const Monitor& monitor);
}

#endif
