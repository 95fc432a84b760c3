// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of a stack where a horizon has no point.
//
//   - Holes and gaps are closed for each horizon from its own points alone, so that it does not matter which other
//     horizons are in the stack: enclosed holes as by HoleFilling.h, and gaps along rows and columns, as those of a
//     fault's heave and between sparse lines, by linear interpolation (GapHeights.h).
//   - A horizon that is still absent between two others follows one of them: in each area, connected side by side, the
//     one that it is nearer to along the area's border. So the layer on that side is absent there, and the other one has
//     all of the rock.

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
/// What is done there. Each does what those before do, too.
enum class MissingPolicy
{
  Void, // layers are left out
  Interpolate, // holes and gaps are closed
  Follow // and horizons follow others
};

struct MissingOptions
{
  MissingPolicy Policy = MissingPolicy::Void;
  std::int64_t LargestHole = 2500; // larger ones are not closed; columns
  int LargestGap = 10; // wider ones are not closed, along rows and columns; columns
};

/// Where a height of a stack comes from.
enum class HeightOrigin : unsigned char
{
  None,
  Known,
  FilledBefore, // by an earlier stage, and read like those that are known
  ExtrapolatedBefore,
  Filled, // into holes and gaps
  FollowsAbove, // the next horizon above that is there
  FollowsBelow,
  Bridged // where outlines of the domain Common pass over missing columns
};

using OriginStack = std::vector<std::vector<HeightOrigin>>; // by horizon and column

bool IsRead(HeightOrigin origin);
bool Follows(HeightOrigin origin);
/// Of a point that was read.
HeightOrigin ReadOrigin(const HorizonView& horizon, PointId point);
bool AreAllRead(const OriginStack& origins);

/// Whether a policy puts such a height in.
bool Allows(MissingPolicy policy, HeightOrigin origin);

/// Horizons with the points of closed holes and gaps behind their own.
struct FilledHorizons
{
  std::vector<std::vector<PlanePoint>> Columns; // of those with such points
  std::vector<std::vector<double>> Heights;
  std::vector<HorizonView> Views;
};

/// `horizons` have to outlive it. `cuts`, which may be null, divide holes.
FilledHorizons FillHorizons(const std::vector<HorizonView>& horizons, const MissingOptions& options,
  const LinkCuts* cuts, const Monitor& monitor = Monitor());

/// Whether points were read; of others `ofOthers`, or Filled where horizons have them. Nothing follows others.
OriginStack OriginsOf(const std::vector<HorizonView>& horizons, const CommonColumns& columns, HeightOrigin ofOthers);

/// The origins of heights in the columns of any filled horizons, given these, with nan where one has none.
OriginStack FindOrigins(
  const std::vector<HorizonView>& horizons, const CommonColumns& columns, const HeightStack& heights);

/// Puts heights in that are not known, in order, so that nothing that is known moves. `heights` has known ones, in
/// order, and `given` those that were filled.
void PutMissing(
  const OriginStack& origins, const HeightStack& given, const CrossingOptions& options, HeightStack& heights);
}

#endif
