// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random numbers and fields of the reflectors of a synthetic cube.

#ifndef SeismicHorizonsCubeRandom_h
#define SeismicHorizonsCubeRandom_h

#include "SmoothNoise.h"

#include <cstdint>

namespace SeismicHorizons
{
/// What random numbers are for.
enum Purpose : std::uint64_t
{
  Folds = 1,
  LayerShape,
  LayerSpacing,
  LayerStrength,
  Fades,
  ChannelCourse,
  DeadTraces,
  MissingTraces,
  Erosion,
  FaultShape,
  ReefShape,
  TurningLine,
  ForesetShape,
  ShiftOfLine,
  ShiftOfTrace,
  ShiftOfPatch
};

inline double RandomOf(std::uint64_t seed, Purpose purpose, std::int64_t i, std::int64_t j)
{
  return Random(Mix(seed + Mix(purpose)), i, j);
}

inline double SmoothOf(std::uint64_t seed, Purpose purpose, double x, double y, int octaves)
{
  return FractalNoise(Mix(seed + Mix(purpose)), x, y, octaves);
}
}

#endif
