// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of a stack where a horizon has no point.
//
//   - Holes and gaps of a horizon are closed from its own points alone, so that other horizons of the stack do not
//     matter: enclosed holes by HoleFilling.h, gaps along rows and columns, as of the heave of faults and between sparse
//     lines, by linear interpolation. A plate over such gaps would be one system over the whole survey.
//   - A horizon that is still absent between two others follows one of them, in each connected area the one to which it
//     is nearer along the border of the area. The layer on that side is absent there, the other one has all the rock.

#ifndef SeismicHorizonsMissingHeights_h
#define SeismicHorizonsMissingHeights_h

#include "Common/LinkCuts.h"
#include "Common/Monitor.h"
#include "Common/Types.h"
#include "CommonColumns.h"
#include "Crossings.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
enum class MissingPolicy
{
  Void, // layers are left out
  Interpolate, // holes and gaps are closed
  Follow // in addition, horizons follow others
};

struct MissingOptions
{
  MissingPolicy Policy = MissingPolicy::Void;
  std::int64_t LargestHole = 2500; // columns
  int LargestGap = 10; // width along rows and columns; columns
};

/// Where a height of a stack comes from.
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

/// Whether a policy puts such a height in.
inline bool Allows(MissingPolicy policy, HeightOrigin origin)
{
  return IsRead(origin) || (origin == HeightOrigin::Filled && policy != MissingPolicy::Void) ||
    (Follows(origin) && policy == MissingPolicy::Follow);
}

/// The origin of a point that was read.
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

/// Replaces nan by heights interpolated along rows, columns and diagonals, so that planes continue. Where one end of
/// these lines has a height, that is taken. nan stays where no height is within 256 columns.
void FillGaps(const HorizonView& horizon, const LinkCuts* cuts, PlanePoints columns, std::vector<double>& heights);

/// The origins of the points of columns; `ofOthers` where a horizon has no point. No horizon follows another one.
OriginStack OriginsOf(const std::vector<HorizonView>& horizons, const CommonColumns& columns, HeightOrigin ofOthers);

/// The origins in the columns of any filled horizon, which have these heights, or nan.
OriginStack FindOrigins(
  const std::vector<HorizonView>& horizons, const CommonColumns& columns, const HeightStack& heights);

/// Puts in the heights that were not read, in order, so that heights that were read do not move. `heights` has those, in
/// order; `given` has the filled ones.
void PutMissing(
  const OriginStack& origins, const HeightStack& given, const CrossingOptions& options, HeightStack& heights);
}

#endif
