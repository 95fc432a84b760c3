// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsStrayPicks_h
#define SeismicHorizonsStrayPicks_h

#include "Common/Monitor.h"
#include "PickTable.h"
#include "SurveyLattice.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// The column of a pick, and how far the pick is from it, in columns.
struct PickPlace
{
  Eigen::Vector2d Column;
  double Distance = 0.0;
};

/// Picks that are far from all others, or where there are none, off their columns, by their numbers. Strays move the
/// lattice, so that others seem off as well: only those at least half as far off as the farthest count.
std::vector<std::size_t> FindStrays(const std::vector<PickPlace>& picks, double tolerance);

/// Of places that stand on no lattice those far from all others, by their numbers: farther from the box of all but the
/// outer fiftieths than it is long, or from that of all but the outer tenths than ten times this. At most a tenth of at
/// least 8 places, else they are no strays.
std::vector<std::size_t> FindFarPlaces(const std::vector<Eigen::Vector2d>& places);

/// Picks with numbers of lines that are between those of nearly all others, which go by larger steps: one wrong digit
/// makes the lattice finer, and its columns fall apart. Of crosslines, or where there are none, of inlines; by their
/// numbers.
std::vector<std::size_t> FindBetweenLines(
  const PickTable& picks, const std::optional<LineNumbering>& lines, const Monitor& monitor = Monitor());

/// For people: "line 17", or "lines 17, 20, ..."; "pick" and numbers from 1 where picks are of no file of lines.
std::string SayPicks(const PickTable& picks, const std::vector<std::size_t>& numbers);

/// The picks without some, which are by their numbers. Lines stay those of all.
PickTable WithoutPicks(PickTable picks, const std::vector<std::size_t>& dropped);
}

#endif
