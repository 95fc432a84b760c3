// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How columns of text belong to each other: line numbers, and the places that an affine map leads to from them.

#ifndef SeismicHorizonsPairFit_h
#define SeismicHorizonsPairFit_h

#include "TextHeader.h"

#include <cstddef>

namespace SeismicHorizons
{
constexpr double LargestPlace = 1e9; // on Earth, in any unit of length; beyond are no places, but whatever z may be

/// How two columns belong to two others.
struct PairFit
{
  bool AreTelling = false; // enough lines, not all on one inline
  bool AreAffine = false; // an affine map leads from the first pair to the second
  bool AreMostlyAffine = false; // of most, roughly: what is wrong with others nobody can tell
  bool AreLarger = false; // steps of the second pair are longer than those of the first
  bool AreCoordinates = true; // all numbers of the second pair are as large as coordinates mostly are
};

/// How many of some lines tell what they all are: of a few all, of more nine of ten.
std::size_t MostOf(std::size_t lines);

/// How the columns `from` and the next one lead to `to` and the next one. Places are rounded, or off the lines by some
/// noise, but they lie far apart: what is off counts beside their extent. Where lines are of three dimensions anything
/// but a place has no such map.
PairFit FitPairs(const TextLines& sample, const TextLayout& layout, std::size_t from, std::size_t to);

/// Whether all lines of the sample are of one seismic line, and two columns go by equal steps along it, as places do.
bool FollowOneLine(const TextLines& sample, const TextLayout& layout, std::size_t lines, std::size_t places);
}

#endif
