// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins the picks of one window of columns, and tells which links have to wait for a larger one.

#ifndef SeismicHorizonsWindowJoining_h
#define SeismicHorizonsWindowJoining_h

#include "ColumnSet.h"
#include "Common/Monitor.h"
#include "PartFit.h"
#include "RankedLink.h"
#include "SurfaceSets.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
struct JoiningWindow : ColumnWindow
{
  bool IsFirst = true; // no link was tried yet
  std::vector<RankedLink> Left; // links that begin in the window and were not tried
  std::vector<RankedLink> Refused;
  std::unordered_map<std::uint64_t, std::int64_t> Refusals; // the size both sets had, by their numbers
  std::unordered_map<PointId, ColumnSet> Columns; // of large sets
};

/// Tries the links that are left within a window, the best ones first. One that leads out of it, or between sets of
/// which one waits, makes its sets wait. Sets that are in the window altogether may be worked on by a thread for each
/// window.
void JoinWindow(const PartFit& fit, SurfaceSets& sets, JoiningWindow& window, const Monitor& monitor);

/// Tries those once more that were refused. The window has all columns.
void JoinRefused(const PartFit& fit, SurfaceSets& sets, JoiningWindow& window, const Monitor& monitor);
}

#endif
