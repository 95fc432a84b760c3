// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The random fields that a synthetic horizon is made of, and the frame in which their features have the same
// proportions at any size of the lattice.

#ifndef SeismicHorizonsRandomFields_h
#define SeismicHorizonsRandomFields_h

#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"
#include "SmoothNoise.h"

#include <algorithm>
#include <cstdint>

namespace SeismicHorizons
{
/// What a random field is for. No two fields of a horizon are alike.
enum class Field : std::uint64_t
{
  FoldDirection,
  FoldPhase,
  FoldDetail,
  Distance,
  Roughness,
  Outline,
  Raggedness,
  Bay,
  Hole,
  Island,
  FeatureShape,
  Dropout,
  Thickness,
  Amplitude,
  Speckle,
  Polarity,
  NoisePatch,
  NoiseHeight,
  NoiseGap
};

inline std::uint64_t SeedOf(std::uint64_t seed, Field field)
{
  return Mix(seed + Mix(static_cast<std::uint64_t>(field)));
}

/// A column in a frame that does not depend on the size of the lattice: -1 to 1 from edge to edge.
struct FramePlace
{
  double X = 0.0;
  double Y = 0.0;
};

inline FramePlace ToFrame(const SparseMatrixSize& size, double i, double j)
{
  return { 2.0 * i / std::max(1, size[0] - 1) - 1.0, 2.0 * j / std::max(1, size[1] - 1) - 1.0 };
}
}

#endif
