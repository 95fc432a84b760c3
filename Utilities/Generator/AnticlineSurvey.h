// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a survey like those of the trade: two horizons in two-way time over an anticline, for demonstrations and
// documentation.
//
// Horizon 1 is an anticline with a second, smaller culmination. Two normal faults face each other across the crest;
// their throws die out towards their ends, and picks are missing in the heave. A meandering channel is cut into it,
// which the faults offset. The picks end at the edges of the survey, or raggedly where the reflection fades; there are
// holes, and single missing picks. Amplitudes are bright above a flat contact. Horizon 2 lies below it, dips more
// steeply, and is cut off by it around the crest, where a tracker follows horizon 1 for some columns: the two have the
// same times there, in cells below each other.
//
// As for HorizonGenerator, each number is computed from its place by operations that are the same on every machine.

#ifndef SeismicHorizonsAnticlineSurvey_h
#define SeismicHorizonsAnticlineSurvey_h

#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <cstdint>
#include <map>
#include <ostream>

namespace SeismicHorizons
{
/// Crosslines, inlines and samples of 4 ms.
constexpr SparseMatrixSize AnticlineSurveySize = { 200, 150, 501 };

/// Writes the file, and returns the voxels of each horizon. Throws std::runtime_error when the stream does not take it.
std::map<int, std::int64_t> WriteAnticlineSurvey(std::ostream& stream);
}

#endif
