// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CubeGeneratorOptions.h"

#include "Common/Base/Parameters.h"
#include "SmoothNoise.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
const std::map<std::string, Trouble>& TroubleNames()
{
  static const std::map<std::string, Trouble> names = { { "polarity", Trouble::Polarity },
    { "wavelet", Trouble::Wavelet }, { "multiples", Trouble::Multiples }, { "dead-strips", Trouble::DeadStrips },
    { "gas-cloud", Trouble::GasCloud }, { "salt", Trouble::Salt }, { "reef", Trouble::Reef },
    { "footprint", Trouble::Footprint }, { "clipped", Trouble::Clipped }, { "statics", Trouble::Statics },
    { "smiles", Trouble::Smiles }, { "growth-fault", Trouble::GrowthFault }, { "clinoforms", Trouble::Clinoforms } };
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
CubeGeneratorOptions HardCube(std::uint64_t seed)
{
  CubeGeneratorOptions options;
  options.Seed = seed;
  options.Frequency = 25.0 + 13.0 * Random(Mix(seed), 1, 0);
  const double period = 1000.0 / (options.Frequency * options.SampleInterval);
  options.Spacing = 2.4 * period;
  options.SpacingVariation = 0.45;
  options.FaultThrow = period * (0.25 + 3.0 * Random(Mix(seed), 2, 0));
  options.FaultDip = 0.1 + 0.15 * Random(Mix(seed), 3, 0);
  options.SmallestStrength = 0.35;
  options.Fading = 0.12;
  options.Channels = 1;
  options.DeadFraction = 0.005;
  options.MissingFraction = 0.02;
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
CubeGeneratorOptions WildCube(std::uint64_t seed)
{
  CubeGeneratorOptions options = HardCube(seed);
  options.Size = { 110, 96, 280 };
  options.Channels = 2;
  options.HasUnconformity = true;
  options.ShortFaults = 1 + int(4.0 * Random(Mix(seed), 4, 0));
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
CubeGeneratorOptions SampleFinely(CubeGeneratorOptions options, double times)
{
  options.Size[2] = int(times * options.Size[2]);
  options.SampleInterval /= times;
  options.Spacing *= times;
  options.FoldHeight *= times;
  options.FaultThrow *= times;
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
void CheckOptions(const CubeGeneratorOptions& options)
{
  constexpr int mostColumns = 100000;
  constexpr int mostSamples = 32767; // what headers can tell
  CheckWithin("columns", options.Size[0], 1, mostColumns, "");
  CheckWithin("rows", options.Size[1], 1, mostColumns, "");
  CheckWithin("samples", options.Size[2], 1, mostSamples, "");
  CheckWithin("sample interval", options.SampleInterval, 0.1, 32.0, " ms");
  CheckWithin("frequency", options.Frequency, 0.1, 500.0 / options.SampleInterval, " Hz");
  CheckWithin("spacing", options.Spacing, 4.0, double(mostSamples), " samples");
  CheckWithin("variation of the spacing", options.SpacingVariation, 0.0, 0.9, "");
  CheckWithin("height of folds", options.FoldHeight, 0.0, double(mostSamples), " samples");
  CheckWithin("throw", options.FaultThrow, 0.0, double(mostSamples), " samples");
  CheckWithin("dip of the fault", options.FaultDip, 0.0, 10.0, " columns");
  CheckWithin("short faults", options.ShortFaults, 0, 100, "");
  CheckWithin("channels", options.Channels, 0, 10, "");
  CheckWithin("phase", options.Phase, -360.0, 360.0, " degrees");
  CheckWithin("smallest strength", options.SmallestStrength, 0.01, 1.0, "");
  CheckWithin("fading", options.Fading, 0.0, 1.0, "");
  CheckWithin("part of dead traces", options.DeadFraction, 0.0, 1.0, "");
  CheckWithin("part of missing traces", options.MissingFraction, 0.0, 1.0, "");
  CheckWithin("noise", options.NoiseFraction, 0.0, 100.0, "");
}
}
