// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsStrayPicks_h
#define SeismicHorizonsStrayPicks_h

#include "PickTable.h"

#include <Eigen/Core>

#include <cstddef>
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

/// Picks that are off their columns, or far from all others, by their numbers. Strays move the lattice, so that others
/// seem off as well: only those at least half as far off as the farthest count.
std::vector<std::size_t> FindStrays(const std::vector<PickPlace>& picks, double tolerance);

/// For people: "line 17", or "lines 17, 20, ..."; "pick" and numbers from 1 where picks are of no file of lines.
std::string SayPicks(const PickTable& picks, const std::vector<std::size_t>& numbers);

/// The picks without some, which are by their numbers. Lines stay those of all.
PickTable WithoutPicks(PickTable picks, const std::vector<std::size_t>& dropped);
}

#endif
