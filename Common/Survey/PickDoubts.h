// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What can be read, but is hardly meant.

#ifndef SeismicHorizonsPickDoubts_h
#define SeismicHorizonsPickDoubts_h

#include "ColumnOrder.h"
#include "Common/DuplicatePolicy.h"
#include "SurveyHorizons.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A warning of a usual number for no value, such as -999, or one that several picks have, as z farther from all others
/// of some picks than these are from each other; one that is not usual is at least half as far from them as 0 is. `picks`
/// are numbers of picks that are not gridded yet.
std::string FindNull(const std::vector<double>& z, const std::vector<std::int32_t>& picks);

/// Counts the duplicates of a horizon that was ordered, and of columns in conflict those on a line with others nearby: at
/// a fault, programs give a node the z of both sides. Those of overlapping surveys fill areas, those of wrong picks are
/// scattered.
ConflictCount CountConflicts(const ColumnOrder& order);

/// A lattice can be laid through any few places, as wells. Throws InputError where picks, of which the columns are given,
/// fill less than a tenth of a lattice that was found from their places, or from line numbers that were guessed, and most
/// are next to no other, or where they are fewer than its six numbers and do not fill all of it.
void RequireEvidence(std::vector<PlanePoint> columns, const SurveyLattice& lattice, const PickTable& picks);

/// Warnings: those that the horizons have already, and of more than a thousandth of columns with several z, unless the
/// policy was chosen: along faults, of surveys that overlap, of several horizons without names.
std::vector<std::string> FindDoubts(const SurveyHorizons& horizons, DuplicatePolicy policy);
}

#endif
