// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random numbers and smooth random functions that are the same on every machine. They have no state: each number
// belongs to a seed and a place.

#ifndef SeismicHorizonsSmoothNoise_h
#define SeismicHorizonsSmoothNoise_h

#include <cmath>
#include <cstdint>

namespace SeismicHorizons
{
/// The output function of the splitmix64 generator: a good hash of 64 bits.
inline std::uint64_t Mix(std::uint64_t bits)
{
  bits += 0x9E3779B97F4A7C15u;
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
  return bits ^ (bits >> 31);
}

/// A number from 0 to below 1 that belongs to the point (i, j).
inline double Random(std::uint64_t seed, std::int64_t i, std::int64_t j)
{
  const std::uint64_t hash = Mix(Mix(seed ^ static_cast<std::uint64_t>(i)) + static_cast<std::uint64_t>(j));
  return static_cast<double>(hash >> 11) / 9007199254740992.0; // 2^53
}

inline double SmoothStep(double t)
{
  return t * t * (3.0 - 2.0 * t);
}

/// Smooth noise from -1 to 1 that changes within a distance of about 1.
inline double Noise(std::uint64_t seed, double x, double y)
{
  const double x0 = std::floor(x);
  const double y0 = std::floor(y);
  const auto i = static_cast<std::int64_t>(x0);
  const auto j = static_cast<std::int64_t>(y0);
  const double s = SmoothStep(x - x0);
  const double t = SmoothStep(y - y0);
  const double low = (1.0 - s) * Random(seed, i, j) + s * Random(seed, i + 1, j);
  const double high = (1.0 - s) * Random(seed, i, j + 1) + s * Random(seed, i + 1, j + 1);
  return 2.0 * ((1.0 - t) * low + t * high) - 1.0;
}

/// Noise with detail, still from -1 to 1: each octave is half as wide and half as high as the one before.
inline double FractalNoise(std::uint64_t seed, double x, double y, int octaves)
{
  double sum = 0.0;
  double total = 0.0;
  double height = 1.0;
  for (int octave = 0; octave < octaves; ++octave)
  {
    sum += height * Noise(Mix(seed + static_cast<std::uint64_t>(octave)), x / height, y / height);
    total += height;
    height *= 0.5;
  }
  return sum / total;
}

/// A wave from -1 to 1 of period 1, made of parabolas.
inline double Wave(double phase)
{
  const double t = phase - std::floor(phase);
  return t < 0.5 ? 8.0 * t * (1.0 - 2.0 * t) : -8.0 * (t - 0.5) * (2.0 - 2.0 * t);
}
}

#endif
