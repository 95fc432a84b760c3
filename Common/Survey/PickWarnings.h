// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Warns of input that can be read but is probably wrong.

#ifndef SeismicHorizonsPickWarnings_h
#define SeismicHorizonsPickWarnings_h

#include "ColumnOrder.h"
#include "DuplicatePolicy.h"
#include "SurveyHorizons.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Warns of z such as -999, or of a repeated number, that are farther from all other z than these are from each other;
/// an unusual number must also be half as far away as 0, and of at most half of the picks.
void WarnOfNulls(std::vector<double> z, std::vector<std::string>& warnings);

/// Warns if numbers that were dropped, as they usually mean no z, are among the z, or off by a tenth of their range.
void WarnOfNulls(const std::vector<double>& nulls, const std::vector<double>& z, std::vector<std::string>& warnings);

/// Conflicts on lines are faults, where programs give nodes the z of both sides. Overlapping surveys have conflicts
/// over areas, and wrong picks scattered conflicts.
ConflictCount CountConflicts(const ColumnOrder& order);

/// Any few places fit a lattice. Throws InputError if most picks have no neighbour and fill less than a tenth of a
/// lattice found from places, or guessed line numbers, or if picks are fewer than its six numbers and do not fill it.
void RequireEvidence(std::vector<PlanePoint> columns, const SurveyLattice& lattice, const PickTable& picks);

/// Adds a warning if picks are moved by more than a fiftieth of a step, and more than by coordinates rounded to a unit of
/// 1 or less. `columns` are those of the picks.
void WarnOfMoves(const PickTable& picks, const std::vector<PlanePoint>& columns, SurveyHorizons& placed);

/// Adds warnings if more than a thousandth of the columns have several z, and the policy was not chosen: faults,
/// overlapping surveys, several unnamed horizons.
std::vector<std::string> FindWarnings(const SurveyHorizons& horizons, DuplicatePolicy policy);
}

#endif
