// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of a stack where a horizon has no point.
//
//   - Holes and gaps of a horizon are closed from its own points alone: enclosed holes by HoleFilling.h, gaps of faults
//     and between sparse lines by linear interpolation, as a plate there would be one system over the whole survey.
//   - A horizon that is still absent between two others follows, in each connected area, the one to which it is nearer
//     along the border, so that the layer on the other side has all the rock.

#ifndef SeismicHorizonsMissingHeights_h
#define SeismicHorizonsMissingHeights_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"
#include "CommonColumns.h"
#include "Crossings.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
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
}

#endif
