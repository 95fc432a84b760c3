// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsContinuousJoining_h
#define SeismicHorizonsContinuousJoining_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "ReflectionLinks.h"

namespace SeismicHorizons
{
/// Lets surfaces grow one after the other, each from the strongest pick that is left, over the best link of its rim,
/// onto picks in columns that it does not have yet (Prim's order). So strong events come out whole, through steep and
/// noisy places; and sometimes across faults. Gives the surface of each pick: the number of the
/// pick it began with.
RawVector<PointId> JoinContinuously(
  const ReflectionPicks& picks, const ReflectionLinks& links, const Monitor& monitor = Monitor());
}

#endif
