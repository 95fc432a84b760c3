// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsOrderedStack_h
#define SeismicHorizonsOrderedStack_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"
#include "CommonColumns.h"
#include "Crossings.h"
#include "MissingHeights.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
enum class LayerDomain
{
  Common, // where all horizons have points
  EachLayer // where both horizons of the layer have points
};

/// Columns that the stack would have with MissingPolicy::Follow.
struct LeftOutColumns
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Thickness; // of the layer there, in lattice units
};

struct OrderedStack
{
  std::vector<PlanePoint> Columns;
  HeightStack Heights;
  OriginStack Origins;
  CrossingRepair Repair; // of heights that were read
  std::size_t Completed = 0; // columns that CompleteColumns added
  std::vector<LeftOutColumns> LeftOut; // by layer
  FilledHorizons Filled; // without filled points if the policy is Void
};

struct StackOptions
{
  LayerDomain Domain = LayerDomain::Common;
  MissingOptions Missing;
  CrossingOptions Crossings;
  /// Faulted links of all horizons, or null: layers and filled holes end there.
  const LinkCuts* Cuts = nullptr;
};

/// Throws InputError on fewer than two horizons, heights that are not finite, and no column in common, and as
/// RepairCrossings does.
OrderedStack MakeStack(const std::vector<HorizonView>& horizons, const StackOptions& options, const Monitor& monitor);

/// Columns that some horizons have, with heights of all horizons in order. Heights that were read do not move.
struct CompletedColumns
{
  std::vector<PlanePoint> Columns;
  HeightStack Heights;
  OriginStack Origins;
  CrossingRepair Repair;
  std::vector<PointId> OnLoops; // by column a point of the loop around it

  void AppendTo(std::vector<PlanePoint>& columns, HeightStack& heights) const;
  /// Adds all but columns and heights.
  void CountIn(OrderedStack& stack) const;
};

/// Finds columns inside loops, or also on them, that some horizons have, but not the stack, whose columns are given.
CompletedColumns CompleteColumns(const std::vector<HorizonView>& horizons, PlanePoints columns, const Loops& loops,
  bool withLoops, const LinkCuts* cuts, const CrossingOptions& options);

/// The same loops with the points from `first` on that their edges pass over.
Loops PassThrough(const Loops& loops, PlanePoints columns, std::size_t first);

struct RepairedHorizons
{
  HeightStack Heights; // by horizon and point
  CrossingRepair Repair;
};

/// Throws InputError as MakeStack does, except on columns in common.
RepairedHorizons RepairHorizons(
  const std::vector<HorizonView>& horizons, const CrossingOptions& options, const Monitor& monitor = Monitor());

/// The numbers of the horizons from the uppermost down, by mean heights over the columns that all have. Throws InputError
/// if there is none, and if a horizon is below the next one in over a quarter of the columns in which the two differ.
std::vector<std::size_t> OrderByHeight(const std::vector<HorizonView>& horizons, const CrossingOptions& options);
}

#endif
