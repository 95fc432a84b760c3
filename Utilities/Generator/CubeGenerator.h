// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes synthetic seismic cubes whose horizons are known: each trace is the sum of a wavelet at each reflector it meets
// (CubeReflectors.h), and noise.
//
// The result depends on the options alone: it is computed with IEEE additions, multiplications, divisions and square
// roots, and random numbers of each place, in a fixed order. The only function beyond these, the exponential in the
// wavelet, is computed by them.

#ifndef SeismicHorizonsCubeGenerator_h
#define SeismicHorizonsCubeGenerator_h

#include "CubeGeneratorOptions.h"
#include "CubeReflectors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class CubeGenerator
{
public:
  /// Throws InputError when an option is out of range.
  explicit CubeGenerator(const CubeGeneratorOptions& options);

  const CubeGeneratorOptions& Options() const { return this->Given; }
  const CubeReflectors& Truth() const { return this->Reflectors; }

  /// All traces, one after the other: that of column (i, j) is number i + nX j. Dead ones are 0, missing ones nan.
  std::vector<float> MakeTraces() const;

private:
  void AddSignal(int i, int j, float* trace) const;
  /// Of so many times the frequency that the cube has there.
  void AddWavelet(double place, double strength, float* trace, double times = 1.0) const;
  void AddNoise(int i, int j, double height, float* trace) const;
  /// When a multiple comes after its reflector, in samples.
  double MultipleDelay(int i, int j) const;
  void Clip(std::vector<float>& traces) const;
  void MakePlaneWaves();
  void MakeSmiles();
  void AddSmiles(int i, int j, float* trace) const;
  /// Random numbers of variance 1, and so many samples more, as the wavelet moves them.
  std::vector<double> InBand(const std::vector<double>& random) const;
  std::vector<double> LateralRandom(std::uint64_t seed, int i, int j, std::size_t size) const;
  double CoherentNoise(int i, int j, int sample) const;

  /// A dipping wave: its samples at column (0, 0), from the first that any column needs on.
  struct PlaneWave
  {
    std::array<double, 2> Slope = { 0.0, 0.0 }; // samples from a column to the next one
    double First = 0.0;
    std::vector<double> Samples;
  };

  /// What migration makes of a burst of noise: a bowl that rises from it, to the surface at `Radius` columns.
  struct Smile
  {
    std::array<double, 2> Middle = { 0.0, 0.0 };
    double Bottom = 0.0;
    double Radius = 1.0;
    double Strength = 1.0;
  };

  CubeGeneratorOptions Given;
  CubeReflectors Reflectors;
  std::vector<double> Wavelet; // at whole samples, for noise of its frequencies
  std::array<double, 2> Turn = { 1.0, 0.0 }; // cosine and sine of the phase
  std::vector<PlaneWave> Waves;
  std::vector<Smile> Smiles;
};

/// (1 - 2a) exp(-a) with a = (pi frequency time)^2: a wavelet of amplitude 1 at time 0. Time in seconds.
double RickerWavelet(double frequency, double time);

/// Its Hilbert transform.
double TurnedRickerWavelet(double frequency, double time);
}

#endif
