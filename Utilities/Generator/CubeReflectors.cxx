// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CubeReflectors.h"

#include "Common/Parameters.h"
#include "SmoothNoise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr double None = std::numeric_limits<double>::quiet_NaN();

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
  MissingTraces
};

double RandomOf(std::uint64_t seed, Purpose purpose, std::int64_t i, std::int64_t j)
{
  return Random(Mix(seed + Mix(purpose)), i, j);
}

double SmoothOf(std::uint64_t seed, Purpose purpose, double x, double y, int octaves)
{
  return FractalNoise(Mix(seed + Mix(purpose)), x, y, octaves);
}
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
  options.HasChannel = true;
  options.DeadFraction = 0.005;
  options.MissingFraction = 0.02;
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
  CheckWithin("smallest strength", options.SmallestStrength, 0.01, 1.0, "");
  CheckWithin("fading", options.Fading, 0.0, 1.0, "");
  CheckWithin("part of dead traces", options.DeadFraction, 0.0, 1.0, "");
  CheckWithin("part of missing traces", options.MissingFraction, 0.0, 1.0, "");
  CheckWithin("noise", options.NoiseFraction, 0.0, 100.0, "");
}

//----------------------------------------------------------------------------------------------------------------------
CubeReflectors::CubeReflectors(const CubeGeneratorOptions& options)
  : Given(options)
{
  double depth = options.FoldHeight + 0.5 * options.Spacing;
  const double last = options.Size[2] - 0.5 * options.Spacing;
  for (int n = 0; depth < last; ++n)
  {
    Layer layer;
    layer.Depth = depth;
    layer.Seed = Mix(options.Seed + Mix(std::uint64_t(n)));
    const double part = RandomOf(options.Seed, LayerStrength, n, 0);
    const double sign = RandomOf(options.Seed, LayerStrength, n, 1) < 0.5 ? -1.0 : 1.0;
    // The second is as weak as any.
    layer.Strength =
      sign * (n == 1 ? options.SmallestStrength : options.SmallestStrength + part * (1.0 - options.SmallestStrength));
    this->Layers.push_back(layer);
    depth +=
      options.Spacing * (1.0 + options.SpacingVariation * (2.0 * RandomOf(options.Seed, LayerSpacing, n, 0) - 1.0));
  }
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::Fold(double x, double y) const
{
  return SmoothOf(this->Given.Seed, Folds, x, y, 2);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::FaultDistance(double i, double j, double sample) const
{
  // Oblique to rows and columns, through the middle of the cube.
  const double middle = 0.5 * (this->Given.Size[2] - 1) * this->Given.FaultDip;
  const double along = 0.4 * (j - 0.5 * (this->Given.Size[1] - 1));
  return i - 0.5 * (this->Given.Size[0] - 1) + along + middle - sample * this->Given.FaultDip;
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::LayerPlace(const Layer& layer, int i, int j) const
{
  constexpr double foldWidth = 48.0; // columns
  constexpr double shapeWidth = 30.0;
  constexpr double shapeHeight = 0.06; // of the spacing
  const double growth = 0.6 + 0.4 * layer.Depth / this->Given.Size[2];
  const double place = layer.Depth + growth * this->Given.FoldHeight * this->Fold(i / foldWidth, j / foldWidth) +
    shapeHeight * this->Given.Spacing * SmoothOf(layer.Seed, LayerShape, i / shapeWidth, j / shapeWidth, 1);
  const double thrown = place + this->Given.FaultThrow;
  if (this->Given.FaultThrow == 0.0 || this->FaultDistance(i, j, place) < 0.0)
  {
    return place;
  }
  return this->FaultDistance(i, j, thrown) > 0.0 ? thrown : None;
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::Place(int reflector, int i, int j) const
{
  const double place = this->LayerPlace(this->Layers[std::size_t(reflector)], i, j);
  const bool isInside = place >= 0.0 && place <= this->Given.Size[2] - 1;
  const bool isCut = reflector == this->ChannelReflector() && this->InsideChannel(i, j) > 0.0;
  return isInside && !isCut ? place : None;
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::Strength(int reflector, int i, int j) const
{
  constexpr double width = 25.0; // columns
  const Layer& layer = this->Layers[std::size_t(reflector)];
  const double noise = SmoothOf(layer.Seed, Fades, i / width, j / width, 1);
  // Whole over most of the area, and the weakest only where noise is lowest.
  const double part = SmoothStep(std::clamp(2.0 * (noise + 0.8), 0.0, 1.0));
  return layer.Strength * (this->Given.Fading + (1.0 - this->Given.Fading) * part);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::InsideChannel(int i, int j) const
{
  constexpr double halfWidth = 4.0; // columns
  constexpr double bend = 12.0;
  constexpr double length = 20.0;
  if (!this->Given.HasChannel)
  {
    return -halfWidth;
  }
  const double middle =
    0.3 * this->Given.Size[1] + bend * SmoothOf(this->Given.Seed, ChannelCourse, i / length, 0.5, 1);
  return halfWidth - std::abs(j - middle);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::ChannelPlace(int i, int j) const
{
  constexpr double depthPerColumn = 1.5;
  const double inside = this->InsideChannel(i, j);
  return inside > 0.0
    ? this->LayerPlace(this->Layers[std::size_t(this->ChannelReflector())], i, j) + depthPerColumn * inside
    : None;
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::ChannelStrength() const
{
  return -0.8 * this->Layers[std::size_t(this->ChannelReflector())].Strength;
}

//----------------------------------------------------------------------------------------------------------------------
bool CubeReflectors::IsDead(int i, int j) const
{
  return RandomOf(this->Given.Seed, DeadTraces, i, j) < this->Given.DeadFraction;
}

//----------------------------------------------------------------------------------------------------------------------
bool CubeReflectors::IsMissing(int i, int j) const
{
  return RandomOf(this->Given.Seed, MissingTraces, i, j) < this->Given.MissingFraction;
}
}
