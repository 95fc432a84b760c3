// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsConnectedPicks_h
#define SeismicHorizonsConnectedPicks_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "ReflectionLinks.h"

namespace SeismicHorizons
{
/// Joins all picks of neighbouring columns that are at most a step apart (thesis, 2.2.1). Gives the component of each
/// pick: the number of its first pick. A component may have several picks in a column.
RawVector<PointId> FindConnectedPicks(
  const ReflectionPicks& picks, ColumnConnectivity connectivity, Depth largestStep, const Monitor& monitor = Monitor());
}

#endif
