// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsStrayPicks_h
#define SeismicHorizonsStrayPicks_h

#include "Common/Base/Monitor.h"
#include "PickTable.h"
#include "SurveyLattice.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Picks of a horizon fill more of their lattice, unless it is small.
constexpr double MostColumnsPerPick = 1000.0;

/// Returns places off any lattice that are farther from the box without 2 % at each end than its length, or from the
/// box without 10 % than ten times its length. At least 8 places are needed, and at most a tenth are strays.
std::vector<std::size_t> FindFarPlaces(const std::vector<Eigen::Vector2d>& places);

/// One wrong digit refines the lattice, so that its columns are no longer neighbours. Returns picks between the
/// crosslines, or else inlines, of nearly all others.
std::vector<std::size_t> FindBetweenLines(
  const PickPlaces& picks, const std::optional<LineNumbering>& lines, const Monitor& monitor = Monitor());

/// The numbers that picks had before others were dropped. Both lists are in order.
std::vector<std::size_t> OriginalNumbers(std::vector<std::size_t> numbers, const std::vector<std::size_t>& dropped);

/// Without lines the text is "pick" and numbers from 1. Numbers count as in the file even if picks were dropped.
std::string PicksText(const PickTable& picks, std::vector<std::size_t> numbers);

PickPlaces WithoutPicks(PickPlaces picks, const std::vector<std::size_t>& dropped);
PickTable WithoutPicks(PickTable picks, const std::vector<std::size_t>& dropped);
}

#endif
