// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CubeReflectors.h"

#include "CubeRandom.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr double None = std::numeric_limits<double>::quiet_NaN();
}

//----------------------------------------------------------------------------------------------------------------------
CubeReflectors::CubeReflectors(const CubeGeneratorOptions& options)
  : Given(options)
  , Shifts(options)
{
  double depth = options.FoldHeight + 0.5 * options.Spacing;
  const double last = options.Size[2] - 0.5 * options.Spacing;
  const double eroded = 0.45 * options.Size[2];
  const bool hasForesets = options.Has(Trouble::Clinoforms);
  const bool hasUnconformity = options.HasUnconformity || hasForesets;
  const double foresets = hasForesets ? std::max(options.FoldHeight, eroded - 2.2 * options.Spacing) : eroded;
  bool isOld = false;
  for (int n = 0; depth < last; ++n)
  {
    if (hasUnconformity && depth > eroded && !isOld)
    {
      isOld = true;
      this->AddForesets(foresets, eroded);
      this->AddLayer(eroded, LayerKind::Unconformity);
    }
    if (!hasForesets || isOld || depth < foresets - 0.7 * options.Spacing)
    {
      this->AddLayer(depth, !hasUnconformity ? LayerKind::Plain : (isOld ? LayerKind::Old : LayerKind::Young));
    }
    depth +=
      options.Spacing * (1.0 + options.SpacingVariation * (2.0 * RandomOf(options.Seed, LayerSpacing, n, 0) - 1.0));
  }
  if (options.Has(Trouble::Reef))
  {
    this->Layers[this->Layers.size() / 2].IsReef = true;
  }
  this->AddShortFaults();
}

//----------------------------------------------------------------------------------------------------------------------
void CubeReflectors::AddLayer(double depth, LayerKind kind)
{
  const std::uint64_t seed = this->Given.Seed;
  const int n = this->Size();
  const double smallest = this->Given.SmallestStrength;
  Layer layer;
  layer.Kind = kind;
  layer.Depth = depth;
  layer.Seed = Mix(seed + Mix(std::uint64_t(n)));
  const double part = RandomOf(seed, LayerStrength, n, 0);
  const double sign = RandomOf(seed, LayerStrength, n, 1) < 0.5 ? -1.0 : 1.0;
  // The second is as weak as any.
  layer.Strength = sign * (n == 1 ? smallest : smallest + part * (1.0 - smallest));
  this->Layers.push_back(layer);
}

//----------------------------------------------------------------------------------------------------------------------
void CubeReflectors::AddForesets(double top, double bottom)
{
  if (!this->Given.Has(Trouble::Clinoforms))
  {
    return;
  }
  constexpr double gap = 16.0; // columns, from edge to edge
  this->ForesetHeight = bottom - top;
  this->Toplap = this->Layers.size();
  this->AddLayer(top, LayerKind::Young);
  // The youngest, which reaches farthest, is above all others.
  for (double edge = this->Given.Size[0]; edge > -2.5 * gap;)
  {
    this->AddLayer(top, LayerKind::Foreset);
    this->Layers.back().Edge = edge;
    edge -= gap * (0.75 + 0.5 * RandomOf(this->Given.Seed, ForesetShape, this->Size(), 0));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CubeReflectors::AddShortFaults()
{
  const double period = this->Period();
  for (int n = 0; n < this->Given.ShortFaults; ++n)
  {
    const auto random = [&](std::int64_t which) { return RandomOf(this->Given.Seed, FaultShape, n, which); };
    ShortFault fault;
    fault.Middle = { (0.15 + 0.7 * random(0)) * this->Given.Size[0], (0.15 + 0.7 * random(1)) * this->Given.Size[1] };
    const double x = 2.0 * random(2) - 1.0;
    const double y = 2.0 * random(3) - 1.0;
    const double length = std::sqrt(x * x + y * y);
    fault.Across = length > 0.1 ? std::array<double, 2>{ x / length, y / length } : std::array<double, 2>{ 1.0, 0.0 };
    fault.Dip = 0.1 + 0.15 * random(4);
    fault.Throw = period * (0.3 + 2.2 * random(5));
    fault.HalfLength = 25.0 + 35.0 * random(6);
    this->Faults.push_back(fault);
  }
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::ShortFault::ThrowAt(double i, double j) const
{
  const double along =
    ((i - this->Middle[0]) * this->Across[1] - (j - this->Middle[1]) * this->Across[0]) / this->HalfLength;
  return this->Throw * std::max(0.0, 1.0 - along * along);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::UnconformityPlace(int i, int j) const
{
  constexpr double width = 45.0; // columns
  const double relief = this->Given.Spacing * (this->Given.Has(Trouble::Clinoforms) ? 0.3 : 1.0);
  return 0.45 * this->Given.Size[2] + relief * SmoothOf(this->Given.Seed, Erosion, i / width, j / width, 2);
}

//----------------------------------------------------------------------------------------------------------------------
// Steepest at the middle. What would be below the unconformity was never laid down.
double CubeReflectors::ForesetPlace(const Layer& foreset, int i, int j) const
{
  constexpr double lobe = 8.0; // columns
  constexpr double width = 30.0;
  const double length = 12.5 * this->ForesetHeight / this->Period(); // columns
  const double edge = foreset.Edge + lobe * SmoothOf(this->Given.Seed, ForesetShape, j / width, 0.5, 1);
  const double part = (i - edge) / length;
  const double drop = 0.625 * this->ForesetHeight * (part + SmoothStep(std::min(1.0, part)));
  const double place = this->LaidPlace(this->Layers[this->Toplap], i, j) + drop;
  return part > 0.0 && place < this->UnconformityPlace(i, j) ? place : None;
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
  // A growth fault is twice as steep at the top, and flattens below.
  const double part = this->Given.Has(Trouble::GrowthFault) ? 0.5 + sample / this->Given.Size[2] : 1.0;
  return i - 0.5 * (this->Given.Size[0] - 1) + along + middle - part * sample * this->Given.FaultDip;
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::LaidPlace(const Layer& layer, int i, int j) const
{
  constexpr double foldWidth = 48.0; // columns
  constexpr double shapeWidth = 30.0;
  constexpr double shapeHeight = 0.06; // of the spacing
  if (layer.Kind == LayerKind::Foreset)
  {
    return this->ForesetPlace(layer, i, j);
  }
  const double growth = 0.6 + 0.4 * layer.Depth / this->Given.Size[2];
  const double place = layer.Depth + growth * this->Given.FoldHeight * this->Fold(i / foldWidth, j / foldWidth) +
    shapeHeight * this->Given.Spacing * SmoothOf(layer.Seed, LayerShape, i / shapeWidth, j / shapeWidth, 1);
  switch (layer.Kind)
  {
    case LayerKind::Young:
      return place < this->UnconformityPlace(i, j) ? place : None;
    case LayerKind::Unconformity:
      return this->UnconformityPlace(i, j);
    case LayerKind::Old:
    {
      constexpr double tilt = 0.3; // samples for each column
      const double tilted = place + tilt * (i - 0.5 * (this->Given.Size[0] - 1));
      return tilted > this->UnconformityPlace(i, j) ? tilted : None;
    }
    default:
      return place;
  }
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::FaultedPlace(const Layer& layer, int i, int j) const
{
  double place = this->LaidPlace(layer, i, j);
  for (const ShortFault& fault : this->Faults)
  {
    const auto isBeyond = [&](double sample)
    {
      const double across = (i - fault.Middle[0]) * fault.Across[0] + (j - fault.Middle[1]) * fault.Across[1];
      return across > (sample - 0.5 * (this->Given.Size[2] - 1)) * fault.Dip;
    };
    const double moved = place + fault.ThrowAt(i, j);
    place = !isBeyond(place) ? place : (isBeyond(moved) ? moved : None);
  }
  if (this->Given.Has(Trouble::GrowthFault))
  {
    return this->BesideGrowthFault(place, i, j);
  }
  const double thrown = place + this->Given.FaultThrow;
  if (this->Given.FaultThrow == 0.0 || this->FaultDistance(i, j, place) < 0.0)
  {
    return place;
  }
  return this->FaultDistance(i, j, thrown) > 0.0 ? thrown : None;
}

//----------------------------------------------------------------------------------------------------------------------
// The fault moved while the layers from its top down to three quarters were laid down: younger ones are thrown by less.
double CubeReflectors::BesideGrowthFault(double place, int i, int j) const
{
  const double age = std::clamp((place / this->Given.Size[2] - 0.15) / 0.6, 0.0, 1.0);
  const double whole = SmoothStep(age) * (this->Given.FaultThrow + 2.0 * this->Period());
  const double width = 3.0 + 0.4 * whole; // columns
  const auto drag = [whole, width](double distance)
  {
    const double nearness = std::max(0.0, 1.0 - distance / width);
    return 0.2 * whole * nearness * nearness;
  };
  const double stayed = place + drag(std::max(0.0, -this->FaultDistance(i, j, place)));
  if (this->FaultDistance(i, j, stayed) < 0.0)
  {
    return stayed;
  }
  constexpr double rollover = 30.0; // columns
  const double distance = std::max(0.0, this->FaultDistance(i, j, place + whole));
  const double part = distance / rollover;
  const double thrown = place + whole * (0.55 + 0.45 / (1.0 + part * part)) - drag(distance);
  return this->FaultDistance(i, j, thrown) > 0.0 ? thrown : None;
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::LayerPlace(const Layer& layer, int i, int j) const
{
  double place = this->FaultedPlace(layer, i, j);
  place -= layer.IsReef ? this->ReefHeight(i, j) : 0.0;
  if (this->Given.Has(Trouble::Salt))
  {
    place = this->BesideSalt(place, i, j);
  }
  constexpr double delay = 6.0; // samples
  place += this->Given.Has(Trouble::GasCloud) ? delay * this->InGas(place, i, j) : 0.0;
  return place + this->Shifts.At(i, j);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::FromBody(double centerX, double centerY, double radius, int i, int j) const
{
  const double x = i - centerX * this->Given.Size[0];
  const double y = j - centerY * this->Given.Size[1];
  return std::sqrt(x * x + y * y) / (radius * this->Given.Size[0]);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::BesideSalt(double place, int i, int j) const
{
  constexpr double top = 0.3; // of the trace
  constexpr double rise = 30.0; // samples, at the end of the trace
  const double distance = this->FromBody(0.35, 0.6, 0.15, i, j);
  const double depth = place / this->Given.Size[2];
  const double outside = std::max(0.0, distance - 1.0);
  return distance < 1.0 && depth > top ? None : place - rise * depth / (1.0 + 3.0 * outside * outside);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::ReefHeight(int i, int j) const
{
  constexpr double height = 10.0; // samples
  constexpr double roughness = 1.5;
  constexpr double flank = 0.25; // of the radius
  constexpr double width = 3.0; // columns
  const double inside = std::clamp((1.0 - this->FromBody(0.5, 0.5, 0.2, i, j)) / flank, 0.0, 1.0);
  return SmoothStep(inside) * (height + roughness * SmoothOf(this->Given.Seed, ReefShape, i / width, j / width, 1));
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::InGas(double place, int i, int j) const
{
  constexpr double top = 0.25; // of the trace
  constexpr double thickness = 0.15;
  const double inside = std::max(0.0, 1.0 - this->FromBody(0.6, 0.45, 0.22, i, j));
  return SmoothStep(inside) * std::clamp((place / this->Given.Size[2] - top) / thickness, 0.0, 1.0);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::Place(int reflector, int i, int j) const
{
  const double place = this->LayerPlace(this->Layers[std::size_t(reflector)], i, j);
  const bool isInside = place >= 0.0 && place <= this->Given.Size[2] - 1;
  bool isCut = false;
  for (int channel = 0; channel < this->Given.Channels; ++channel)
  {
    isCut = isCut || (reflector == this->ChannelReflector(channel) && this->InsideChannel(channel, i, j) > 0.0);
  }
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
  double strength = layer.Strength * (this->Given.Fading + (1.0 - this->Given.Fading) * part);
  strength *= layer.IsReef ? 2.0 / std::abs(layer.Strength) : 1.0;
  if (this->Given.Has(Trouble::GasCloud))
  {
    strength *= 1.0 - 0.85 * this->InGas(this->Place(reflector, i, j), i, j);
  }
  if (this->Given.Has(Trouble::Polarity))
  {
    constexpr double fading = 6.0; // columns
    const auto random = [&](int which) { return 2.0 * RandomOf(layer.Seed, TurningLine, which, 0) - 1.0; };
    const double x = i - (0.5 + 0.2 * random(0)) * this->Given.Size[0];
    const double y = j - (0.5 + 0.2 * random(1)) * this->Given.Size[1];
    const double across = x + random(2) * y;
    strength *= across / std::sqrt(across * across + fading * fading);
  }
  return strength;
}

//----------------------------------------------------------------------------------------------------------------------
int CubeReflectors::ChannelReflector(int channel) const
{
  const int middle = this->Size() / 2;
  const int step = channel % 2 == 1 ? -(channel + 1) : channel; // every second one up and down
  return std::clamp(middle + step, 0, this->Size() - 1);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::InsideChannel(int channel, int i, int j) const
{
  constexpr double halfWidth = 4.0; // columns
  constexpr double bend = 12.0;
  constexpr double length = 20.0;
  const double middle = (channel % 2 == 0 ? 0.3 : 0.7) * this->Given.Size[1] +
    bend * SmoothOf(this->Given.Seed, ChannelCourse, i / length, 0.5 + 3.0 * channel, 1);
  return halfWidth - std::abs(j - middle);
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::ChannelPlace(int channel, int i, int j) const
{
  constexpr double depthPerColumn = 1.5;
  const double inside = this->InsideChannel(channel, i, j);
  return inside > 0.0
    ? this->LayerPlace(this->Layers[std::size_t(this->ChannelReflector(channel))], i, j) + depthPerColumn * inside
    : None;
}

//----------------------------------------------------------------------------------------------------------------------
double CubeReflectors::ChannelStrength(int channel) const
{
  return -0.8 * this->Layers[std::size_t(this->ChannelReflector(channel))].Strength;
}

//----------------------------------------------------------------------------------------------------------------------
bool CubeReflectors::IsDead(int i, int j) const
{
  bool isOnStrip = false;
  for (int strip = 0; strip < 3 && this->Given.Has(Trouble::DeadStrips); ++strip)
  {
    isOnStrip = isOnStrip || std::abs(i - (0.25 + 0.25 * strip) * this->Given.Size[0] - 0.3 * (strip - 1) * j) < 2.0;
  }
  return isOnStrip || RandomOf(this->Given.Seed, DeadTraces, i, j) < this->Given.DeadFraction;
}

//----------------------------------------------------------------------------------------------------------------------
bool CubeReflectors::IsMissing(int i, int j) const
{
  return RandomOf(this->Given.Seed, MissingTraces, i, j) < this->Given.MissingFraction;
}
}
