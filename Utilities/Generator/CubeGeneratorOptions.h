// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What synthetic seismic cubes are like.

#ifndef SeismicHorizonsCubeGeneratorOptions_h
#define SeismicHorizonsCubeGeneratorOptions_h

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace SeismicHorizons
{
enum class NoiseKind
{
  White, // of all frequencies, as of instruments
  InBand, // of the frequencies of the signal, as of sources
  Coherent, // three dipping plane waves of these frequencies, as of multiples and ground roll
  Mixed, // a half of its energy in band, a quarter white and a quarter coherent
  Lateral // a half white, and a half in band and alike in columns up to three apart, as after migration
};

/// What makes a cube hard in a way of its own.
enum class Trouble
{
  Polarity, // reflectors turn their sign along a line, where they fade
  Wavelet, // its frequency falls to 0.4 of that at the top
  Multiples, // each reflector comes a second time, later by a layer with folds of its own
  DeadStrips, // three strips of four dead traces across the cube
  GasCloud, // which weakens and delays what is below it
  Salt, // a plug with upturned flanks
  Reef, // a bright and rough top with steep flanks on the middle reflector
  Footprint, // amplitudes change from line to line
  Clipped, // to 8 bits at the root mean square
  Statics, // traces are shifted: line by line as sources and receivers are, in patches, and each by a little
  Smiles, // arcs of bursts of noise, inside and at the sides, as migration spreads them
  GrowthFault, // the long fault flattens downwards; layers laid down while it moved are thicker beyond it, bend down
  // to it, and are dragged along it
  Clinoforms // foresets from a surface above down to the unconformity, and nowhere else
};

/// By the names that generate_cube knows.
const std::map<std::string, Trouble>& TroubleNames();

/// The default is an easy cube: reflectors far apart and of one strength all over, and a fault across which none faces
/// another.
struct CubeGeneratorOptions
{
  std::uint64_t Seed = 1;
  /// Columns (crosslines), rows (inlines) and samples.
  std::array<int, 3> Size = { 80, 64, 220 };
  double SampleInterval = 4.0; // ms
  double Frequency = 30.0; // of the Ricker wavelet, Hz
  double Spacing = 32.0; // from a reflector to the next one, in samples, at least 4
  double SpacingVariation = 0.0; // part of it that is random, 0 to 0.9
  double FoldHeight = 10.0; // of folds up and down, in samples
  double FaultThrow = 16.0; // how far the fault throws layers down, in samples; 0: no fault
  double FaultDip = 0.15; // how many columns the fault moves in a sample downwards
  int ShortFaults = 0; // others of all directions, whose throw falls to 0 at their ends inside the cube: 0 to 100
  double SmallestStrength = 0.4; // of the weakest reflector; that of the strongest is 1
  double Fading = 1.0; // to what part of its strength a reflector fades, here and there
  int Channels = 0; // each cuts into a reflector of its own, one into the middle one: 0 to 10
  /// Whether older layers are tilted and cut off at a surface, which younger ones end against where it is high.
  bool HasUnconformity = false;
  double Phase = 0.0; // of the wavelet, in degrees, -360 to 360: 90 is its Hilbert transform
  double DeadFraction = 0.0; // traces of zeros
  double MissingFraction = 0.0; // traces that are not there
  double NoiseFraction = 0.0; // root mean square of the noise, as a part of that of the signal
  NoiseKind Noise = NoiseKind::White;
  std::set<Trouble> Troubles;

  bool Has(Trouble trouble) const { return this->Troubles.count(trouble) > 0; }
};

/// A hard one: layers thick and thin, reflectors that fade and face others across the fault, a channel, and dead and
/// missing traces.
CubeGeneratorOptions HardCube(std::uint64_t seed);

/// A wild one: that, larger, with two channels, an unconformity, and one to four short faults beside the long one.
CubeGeneratorOptions WildCube(std::uint64_t seed);

/// The same rock, on so many times as many samples.
CubeGeneratorOptions SampleFinely(CubeGeneratorOptions options, double times);

/// Throws InputError when an option is out of range.
void CheckOptions(const CubeGeneratorOptions& options);
}

#endif
