// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The heights of horizons that lie above each other, column by column.

#ifndef SeismicHorizonsOrderedStack_h
#define SeismicHorizonsOrderedStack_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"
#include "CommonColumns.h"
#include "Crossings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
// ---- Missing heights ------------------------------------------------------------------------------------------------
// Heights of a stack where a horizon has no point.
//
//   - Holes and gaps of a horizon are closed from its own points alone: enclosed holes by HoleFilling.h, gaps of faults
//     and between sparse lines by linear interpolation, as a plate there would be one system over the whole survey.
//   - A horizon that is still absent between two others follows, in each connected area, the one to which it is nearer
//     along the border, so that the layer on the other side has all the rock.

enum class MissingPolicy
{
  Void,
  Interpolate, // holes and gaps are closed
  Follow // in addition, horizons follow others
};

struct MissingOptions
{
  MissingPolicy Policy = MissingPolicy::Void;
  std::int64_t LargestHole = 2500; // columns
  int LargestGap = 10; // width along rows and columns; columns
};

enum class HeightOrigin : unsigned char
{
  None,
  Known,
  FilledBefore, // by an earlier stage, and read like known heights
  ExtrapolatedBefore,
  Filled, // into holes and gaps
  FollowsAbove, // the next horizon above that has a height
  FollowsBelow,
  Bridged // outlines of the domain Common pass over missing columns
};

using OriginStack = std::vector<std::vector<HeightOrigin>>; // by horizon and column

inline bool IsRead(HeightOrigin origin)
{
  return origin == HeightOrigin::Known || origin == HeightOrigin::FilledBefore ||
    origin == HeightOrigin::ExtrapolatedBefore;
}

inline bool Follows(HeightOrigin origin)
{
  return origin == HeightOrigin::FollowsAbove || origin == HeightOrigin::FollowsBelow;
}

inline bool Allows(MissingPolicy policy, HeightOrigin origin)
{
  return IsRead(origin) || (origin == HeightOrigin::Filled && policy != MissingPolicy::Void) ||
    (Follows(origin) && policy == MissingPolicy::Follow);
}

HeightOrigin ReadOrigin(const HorizonView& horizon, PointId point);

/// Horizons with the points of closed holes and gaps behind their own.
struct FilledHorizons
{
  std::vector<std::vector<PlanePoint>> Columns; // empty for horizons without such points
  std::vector<std::vector<double>> Heights;
  std::vector<HorizonView> Views;
};

/// `horizons` have to outlive the result. Holes and lines are divided by `cuts`, which may be null.
FilledHorizons FillHorizons(const std::vector<HorizonView>& horizons, const MissingOptions& options,
  const LinkCuts* cuts, const Monitor& monitor = Monitor());

/// Replaces nan by interpolation along rows, columns and diagonals, so that planes continue, or by the height of one end.
/// nan stays where no height is within 256 columns.
void FillGaps(const HorizonView& horizon, const LinkCuts* cuts, PlanePoints columns, std::vector<double>& heights);

/// `ofOthers` is the origin where a horizon has no point. No horizon follows another one.
OriginStack OriginsOf(const std::vector<HorizonView>& horizons, const CommonColumns& columns, HeightOrigin ofOthers);

/// Finds which horizons follow others, too.
OriginStack FindOrigins(
  const std::vector<HorizonView>& horizons, const CommonColumns& columns, const HeightStack& heights);

/// Puts the heights that were not read between those that were, which are in `heights`; filled ones are in `given`.
void PutMissing(
  const OriginStack& origins, const HeightStack& given, const CrossingOptions& options, HeightStack& heights);

// ---- The stack ------------------------------------------------------------------------------------------------------
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
