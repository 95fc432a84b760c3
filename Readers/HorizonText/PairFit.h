// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tests whether two pairs of text fields are line numbers and their places, which an affine map relates.

#ifndef SeismicHorizonsPairFit_h
#define SeismicHorizonsPairFit_h

#include "TextHeader.h"

#include <cstddef>

namespace SeismicHorizons
{
constexpr double LargestPlace = 1e9; // Larger than any place on Earth in any unit of length.

struct PairFit
{
  bool AreTelling = false; // The lines suffice, and are not all of one inline.
  bool AreAffine = false; // An affine map leads from the first pair to the second.
  bool AreMostlyAffine = false; // The map holds roughly for most lines.
  bool AreLarger = false; // Steps of the second pair are longer.
  bool AreCoordinates = true; // The second pair is as large as coordinates.
};

/// All lines if they are few, else nine of ten.
std::size_t MostOf(std::size_t lines);

/// The pairs are `from` and `to` with the fields after them. Deviations are relative to the extent, since places may be
/// noisy. In a 3D survey only places have such a map.
PairFit FitPairs(const TextLines& sample, const TextLayout& layout, std::size_t from, std::size_t to);

/// The fields must change by equal steps along a single seismic line.
bool FollowOneLine(const TextLines& sample, const TextLayout& layout, std::size_t lines, std::size_t places);
}

#endif
