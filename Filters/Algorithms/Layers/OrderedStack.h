// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The horizons of a stack by column, and in order.

#ifndef SeismicHorizonsOrderedStack_h
#define SeismicHorizonsOrderedStack_h

#include "Common/LinkCuts.h"
#include "Common/Monitor.h"
#include "Common/Types.h"
#include "CommonColumns.h"
#include "Crossings.h"
#include "MissingHeights.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// Where layers are.
enum class LayerDomain
{
  Common, // where all horizons have points
  EachLayer // each where both its horizons have
};

/// Columns that a layer has where all holes and gaps are closed and absent horizons follow others, but not in the stack.
struct LeftOutColumns
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Thickness; // it would have there, in lattice units
};

/// The horizons in the columns of layers, in order; nan where one has no height.
struct OrderedStack
{
  std::vector<PlanePoint> Columns;
  HeightStack Heights;
  OriginStack Origins;
  CrossingRepair Repair; // of heights that were read
  std::size_t Completed = 0; // columns in which heights were put in
  std::vector<LeftOutColumns> LeftOut; // by layer
  FilledHorizons Filled; // the horizons, with what was put into holes and gaps as far as the policy allows
};

struct StackOptions
{
  LayerDomain Domain = LayerDomain::Common;
  MissingOptions Missing;
  CrossingOptions Crossings;
  const LinkCuts* Cuts = nullptr; // holes are not closed across these; may be null
};

/// Throws InputError on fewer than two horizons, heights that are not finite, and horizons without a column in common,
/// and as RepairCrossings does.
OrderedStack MakeStack(const std::vector<HorizonView>& horizons, const StackOptions& options, const Monitor& monitor);

/// Columns that some horizons have, with heights of all: those of the others are between the heights around them, and
/// in order, so that nothing that is known moves.
struct CompletedColumns
{
  std::vector<PlanePoint> Columns;
  HeightStack Heights;
  OriginStack Origins;
  CrossingRepair Repair;
  std::vector<PointId> OnLoops; // for each a point of the loop that it is on or inside of

  void AppendTo(std::vector<PlanePoint>& columns, HeightStack& heights) const;
  /// Adds all but columns and heights.
  void CountIn(OrderedStack& stack) const;
};

/// The columns inside loops, or on them if asked for, that some horizons have, but not the stack: gaps that outlines
/// pass over, and holes that they close. Loops are over the points of the stack; heights go around cuts, where there
/// are some.
CompletedColumns CompleteColumns(const std::vector<HorizonView>& horizons, PlanePoints columns, const Loops& loops,
  bool withLoops, const LinkCuts* cuts, const CrossingOptions& options);

/// Loops that pass through the points, from one on, that their edges lead over.
Loops PassThrough(const Loops& loops, PlanePoints columns, std::size_t first);

/// Horizons with all their points, in order.
struct RepairedHorizons
{
  HeightStack Heights; // by horizon and point
  CrossingRepair Repair;
};

/// Throws InputError as MakeStack does, but for columns in common.
RepairedHorizons RepairHorizons(
  const std::vector<HorizonView>& horizons, const CrossingOptions& options, const Monitor& monitor = Monitor());

/// The numbers of the horizons, the uppermost first by their mean heights over the columns that all have. Throws
/// InputError where there is no such column, and where a horizon is below the next one in more than a quarter of the
/// columns in which the two differ.
std::vector<std::size_t> OrderByHeight(const std::vector<HorizonView>& horizons, const CrossingOptions& options);
}

#endif
