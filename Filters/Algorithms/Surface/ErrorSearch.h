// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The error for which a mesh has a number of triangles.
//
// The number falls with the error, about as its power of -1.5. So the search takes logarithms of both, in which that is
// a line: from a first error to one on the other side of the number, and then by secants between the two.

#ifndef SeismicHorizonsErrorSearch_h
#define SeismicHorizonsErrorSearch_h

#include "Common/Errors.h"

#include <cstddef>
#include <functional>

namespace SeismicHorizons
{
/// How many triangles a mesh within an error has.
using TriangleCounter = std::function<std::size_t(double)>;

/// The most runs of the counter.
constexpr int MostSearchRuns = 10;
/// What no horizon of voxels can be told apart by, in lattice units.
constexpr double SmallestSearchedError = 1.0 / 1024;

/// An error from SmallestSearchedError to `largest` for which `count` gives at most `most`: as a rule from 97 % of it,
/// unless the smallest one gives less. Throws InputError with the number for the largest error when that is more than
/// `most`. The number need not fall everywhere.
double FindErrorForTriangles(std::size_t most, double largest, const TriangleCounter& count);

/// What is thrown when even the outlines take more triangles than there may be.
InputError TooFewTriangles(std::size_t most, std::size_t least);
}

#endif
