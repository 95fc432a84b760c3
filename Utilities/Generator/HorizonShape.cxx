// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonShape.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace SeismicHorizons
{
namespace
{
/// The distance of a place from the middle when circles are deformed towards stars or squares. Square roots are rounded
/// alike on all machines, other powers are not.
double DeformedRadius(double x, double y, double squareness)
{
  const double circle = std::sqrt(x * x + y * y);
  const double roots = std::sqrt(std::abs(x)) + std::sqrt(std::abs(y));
  const double other = squareness < 0.0 ? roots * roots : std::max(std::abs(x), std::abs(y));
  return circle + std::abs(squareness) * (other - circle);
}

/// A voxel drops out when its random number is below a threshold t and below those of its eight neighbours, which
/// happens to (1 - (1 - t)^9) / 9 of all. Solved for t by bisection.
double FindDropoutThreshold(double fraction)
{
  double low = 0.0;
  double high = fraction > 0.0 ? 1.0 : 0.0;
  for (int step = 0; step < 60; ++step)
  {
    const double middle = 0.5 * (low + high);
    const double rest = 1.0 - middle;
    const double cube = rest * rest * rest;
    (1.0 - cube * cube * cube < 9.0 * fraction ? low : high) = middle;
  }
  return low;
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonShape::HorizonShape(const HorizonGeneratorOptions& options, std::uint64_t seed)
  : Given(options)
  , HorizonSeed(seed)
  , Patches(options, seed)
  , DropoutThreshold(FindDropoutThreshold(options.DropoutFraction))
{
  // The finest detail of the outline is about four cells wide.
  for (int width = std::max(options.Size[0], options.Size[1]) / 12; width > 4; width /= 2)
  {
    ++this->RaggedOctaves;
  }
  this->PlaceBays();
  // The larger ones first, while there is room.
  this->PlaceHoles(0, std::min(1, options.NumberOfHoles));
  this->PlaceIslands();
  this->PlaceHoles(1, options.NumberOfHoles);
  std::stable_partition(this->Features.begin(), this->Features.end(), [](const Feature& f) { return f.Moat > 0; });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<int> HorizonShape::FindRow(int j) const
{
  std::vector<Feature> features;
  std::copy_if(this->Features.begin(), this->Features.end(), std::back_inserter(features),
    [j](const Feature& feature) { return std::abs(j - feature.J) < Reach(feature); });
  std::vector<int> row;
  for (int i = 0; i < this->Given.Size[0]; ++i)
  {
    if (this->IsOccupied(features, i, j) && !this->IsDropout(i, j) && !this->Patches.IsGap(i, j))
    {
      row.push_back(i);
    }
  }
  return row;
}

//----------------------------------------------------------------------------------------------------------------------
double HorizonShape::Reach(const Feature& feature)
{
  return 1.4 * (feature.Radius + feature.Moat); // noise bends it by up to 30 %
}

void HorizonShape::PlaceBays()
{
  // Opposite each other, so that they never meet and cut the horizon in two.
  const std::uint64_t seed = SeedOf(this->HorizonSeed, Field::Bay);
  const double x = Random(seed, 0, 0) - 0.5;
  const double y = Random(seed, 1, 0) < 0.5 ? -0.7 : 0.7;
  this->Bays = { { x, y }, { -x, -y } };
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonShape::PlaceHoles(int first, int last)
{
  const std::uint64_t seed = SeedOf(this->HorizonSeed, Field::Hole);
  const double width = std::min(this->Given.Size[0], this->Given.Size[1]);
  for (int hole = first; hole < last; ++hole)
  {
    Feature feature;
    feature.Radius = hole == 0 ? 0.12 * width : std::max(1.5, (0.01 + 0.02 * Random(seed, hole, 0)) * width);
    Require(this->PlaceFeature(feature, Mix(seed + static_cast<std::uint64_t>(hole))),
      std::to_string(this->Given.NumberOfHoles) + " holes",
      "no more than the lattice has room for (" + std::to_string(hole) + ")");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonShape::PlaceIslands()
{
  const std::uint64_t seed = SeedOf(this->HorizonSeed, Field::Island);
  const double width = std::min(this->Given.Size[0], this->Given.Size[1]);
  for (int island = 0; island < this->Given.NumberOfIslands; ++island)
  {
    Feature feature;
    feature.Radius = std::max(1.5, (0.02 + 0.02 * Random(seed, island, 0)) * width);
    feature.Moat = std::max(4.0, 0.5 * feature.Radius);
    if (island == 0 && this->Given.NumberOfHoles > 0)
    {
      feature.I = this->Features.front().I;
      feature.J = this->Features.front().J;
      this->Features.push_back(feature);
      continue;
    }
    Require(this->PlaceFeature(feature, Mix(seed + static_cast<std::uint64_t>(island))),
      std::to_string(this->Given.NumberOfIslands) + " islands",
      "no more than the lattice has room for (" + std::to_string(island) + ")");
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonShape::PlaceFeature(Feature feature, std::uint64_t seed)
{
  constexpr int attempts = 1000;
  const bool isHole = feature.Moat == 0.0;
  for (int attempt = 0; attempt < 2 * attempts; ++attempt)
  {
    feature.I = Random(seed, attempt, 0) * (this->Given.Size[0] - 1);
    feature.J = Random(seed, attempt, 1) * (this->Given.Size[1] - 1);
    // An island lies outside the horizon, or in a hole of its own where there is no room.
    const bool isInBody = isHole || attempt >= attempts;
    if (this->IsApart(feature) && this->HasRoom(feature, isInBody))
    {
      this->Features.push_back(feature);
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonShape::IsApart(const Feature& feature) const
{
  return std::all_of(this->Features.begin(), this->Features.end(),
    [&feature](const Feature& other)
    {
      const double di = feature.I - other.I;
      const double dj = feature.J - other.J;
      const double distance = Reach(feature) + Reach(other) + 4.0;
      return di * di + dj * dj >= distance * distance;
    });
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonShape::HasRoom(const Feature& feature, bool isInBody) const
{
  const double reach = Reach(feature) + 2.0;
  for (int di = -1; di <= 1; ++di)
  {
    for (int dj = -1; dj <= 1; ++dj)
    {
      if (this->IsInBody(feature.I + di * reach, feature.J + dj * reach) != isInBody)
      {
        return false;
      }
    }
  }
  const double edge = feature.Radius + 1.0;
  return feature.I >= edge && feature.I <= this->Given.Size[0] - 1 - edge && feature.J >= edge &&
    feature.J <= this->Given.Size[1] - 1 - edge;
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonShape::IsInBody(double i, double j) const
{
  const FramePlace place = ToFrame(this->Given.Size, i, j);
  const std::uint64_t outline = SeedOf(this->HorizonSeed, Field::Outline);
  for (const FramePlace& bay : this->Bays)
  {
    // A bay is round at its end and runs straight out of the lattice.
    const double dx = place.X - bay.X;
    const double dy = bay.Y > 0.0 ? std::min(0.0, place.Y - bay.Y) : std::max(0.0, place.Y - bay.Y);
    const double radius = 0.2 + 0.1 * Noise(outline, 5.0 * place.X, 5.0 * place.Y);
    if (dx * dx + dy * dy < radius * radius)
    {
      return false;
    }
  }
  const double radius = DeformedRadius(place.X, place.Y, this->Given.Squareness);
  double depth = 0.9 - radius - 0.3 * FractalNoise(outline, 2.0 * place.X, 2.0 * place.Y, 2);
  constexpr double ragged = 0.06;
  if (std::abs(depth) < ragged)
  {
    depth += ragged *
      FractalNoise(SeedOf(this->HorizonSeed, Field::Raggedness), 6.0 * place.X, 6.0 * place.Y, this->RaggedOctaves);
  }
  return depth > 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonShape::IsOccupied(const std::vector<Feature>& features, int i, int j) const
{
  const std::uint64_t shape = SeedOf(this->HorizonSeed, Field::FeatureShape);
  for (const Feature& feature : features)
  {
    const double di = i - feature.I;
    const double dj = j - feature.J;
    const double reach = Reach(feature);
    if (di * di + dj * dj >= reach * reach)
    {
      continue;
    }
    const double detail = std::max(4.0, feature.Radius);
    const double distance = std::sqrt(di * di + dj * dj) / (1.0 + 0.3 * Noise(shape, i / detail, j / detail));
    if (distance < feature.Radius + feature.Moat)
    {
      return feature.Moat > 0.0 && distance < feature.Radius;
    }
  }
  return this->IsInBody(i, j);
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonShape::IsDropout(int i, int j) const
{
  const std::uint64_t seed = SeedOf(this->HorizonSeed, Field::Dropout);
  const double own = Random(seed, i, j);
  if (own >= this->DropoutThreshold)
  {
    return false;
  }
  for (int di = -1; di <= 1; ++di)
  {
    for (int dj = -1; dj <= 1; ++dj)
    {
      if ((di != 0 || dj != 0) && Random(seed, i + di, j + dj) < own)
      {
        return false;
      }
    }
  }
  return true;
}
}
