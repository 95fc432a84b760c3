// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Everything is a function of the place: value noise on hashed lattice points instead of random sequences. So a horizon
// can be made row by row, in any order, without memory of the rows before.

#include "HorizonGenerator.h"

#include "SmoothNoise.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr double TimePerSample = 4.0; // ms, two-way

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
  Polarity
};

std::uint64_t SeedOf(std::uint64_t seed, Field field)
{
  return Mix(seed + Mix(static_cast<std::uint64_t>(field)));
}

double Round(double value, double stepsPerUnit)
{
  return std::floor(value * stepsPerUnit + 0.5) / stepsPerUnit;
}

// ---- Options -----------------------------------------------------------------------------------------------------
void Require(bool condition, const std::string& found, const std::string& expected)
{
  if (!condition)
  {
    throw InputError(found + ", expected " + expected);
  }
}

void CheckOptions(const HorizonGeneratorOptions& options)
{
  const auto [nX, nY, nZ] = options.Size;
  const std::string size = "size " + std::to_string(nX) + " x " + std::to_string(nY) + " x " + std::to_string(nZ);
  Require(nX > 0 && nY > 0 && nZ > 0, size, "three positive integers");
  Require(std::int64_t(nX) * nY <= std::numeric_limits<std::int64_t>::max() / nZ, size, "a product below 2^63");
  Require(options.NumberOfHorizons > 0, std::to_string(options.NumberOfHorizons) + " horizons", "at least 1");
  Require(nZ / 5 >= options.NumberOfHorizons, size + " for " + std::to_string(options.NumberOfHorizons) + " horizons",
    "nZ at least five times the number of horizons");
  Require(options.NumberOfHoles >= 0, std::to_string(options.NumberOfHoles) + " holes", "0 or more");
  Require(options.NumberOfIslands >= 0, std::to_string(options.NumberOfIslands) + " islands", "0 or more");
  Require(options.DropoutFraction >= 0.0 && options.DropoutFraction <= 0.1,
    "dropouts " + std::to_string(options.DropoutFraction), "a part from 0 to 0.1");
  Require(options.Squareness >= -1.0 && options.Squareness <= 1.0, "squareness " + std::to_string(options.Squareness),
    "a number from -1 to 1");
}

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

// ---- Text --------------------------------------------------------------------------------------------------------
/// Appends a number to a line. What else there is says how std::to_chars writes it.
template <typename Number, typename... Format>
void AppendNumber(std::string& line, Number number, Format... format)
{
  std::array<char, 64> digits;
  const std::to_chars_result result = std::to_chars(digits.data(), digits.data() + digits.size(), number, format...);
  line += line.empty() ? "" : " ";
  line.append(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
}

void AppendVoxel(std::string& line, const SparseMatrixVoxel& voxel)
{
  AppendNumber(line, voxel.VerticalIndex);
  AppendNumber(line, voxel.SurfaceId);
  AppendNumber(line, voxel.Thickness, std::chars_format::fixed);
  AppendNumber(line, voxel.Amplitude, std::chars_format::fixed);
  AppendNumber(line, voxel.RealZ, std::chars_format::fixed);
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGenerator::HorizonGenerator(const HorizonGeneratorOptions& options)
  : Given(options)
{
  CheckOptions(options);
  this->DropoutThreshold = FindDropoutThreshold(options.DropoutFraction);
  // The finest detail of the outline is about four cells wide.
  for (int width = std::max(options.Size[0], options.Size[1]) / 12; width > 4; width /= 2)
  {
    ++this->RaggedOctaves;
  }
  for (int position = 0; position < options.NumberOfHorizons; ++position)
  {
    Horizon horizon;
    horizon.Seed = Mix(options.Seed + Mix(static_cast<std::uint64_t>(position)));
    this->PlaceBays(horizon);
    // The larger ones first, while there is room.
    this->PlaceHoles(horizon, 0, std::min(1, options.NumberOfHoles));
    this->PlaceIslands(horizon);
    this->PlaceHoles(horizon, 1, options.NumberOfHoles);
    std::stable_partition(
      horizon.Features.begin(), horizon.Features.end(), [](const Feature& f) { return f.Moat > 0; });
    this->Horizons.push_back(std::move(horizon));
  }
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixSize HorizonGenerator::FindSize(const HorizonGeneratorOptions& options, std::int64_t numberOfVoxels)
{
  Require(numberOfVoxels > 0, std::to_string(numberOfVoxels) + " points", "at least 1");
  CheckOptions(options);
  // The occupied part hardly depends on the size, so a lattice of moderate size tells it.
  HorizonGeneratorOptions probe = options;
  const double width = std::sqrt(90000.0 * options.Size[0] / options.Size[1]);
  probe.Size = { std::max(1, static_cast<int>(width)), std::max(1, static_cast<int>(90000.0 / width)),
    options.Size[2] };
  const HorizonGenerator generator(probe);
  double occupied = 0.0;
  for (int position = 0; position < options.NumberOfHorizons; ++position)
  {
    occupied += static_cast<double>(generator.MakeHorizon(position).I.size());
  }
  occupied /= static_cast<double>(probe.Size[0]) * probe.Size[1];
  const double scale = std::sqrt(static_cast<double>(numberOfVoxels) / occupied / options.Size[0] / options.Size[1]);
  const double nX = std::max(1.0, Round(options.Size[0] * scale, 1.0));
  const double nY = std::max(1.0, Round(options.Size[1] * scale, 1.0));
  Require(std::max(nX, nY) <= std::numeric_limits<int>::max(), std::to_string(numberOfVoxels) + " points",
    "as many as a lattice holds");
  return { static_cast<int>(nX), static_cast<int>(nY), options.Size[2] };
}

//----------------------------------------------------------------------------------------------------------------------
double HorizonGenerator::Reach(const Feature& feature)
{
  return 1.4 * (feature.Radius + feature.Moat); // noise bends it by up to 30 %
}

// ---- Outline, holes and islands
// --------------------------------------------------------------------------------------
void HorizonGenerator::PlaceBays(Horizon& horizon) const
{
  // Opposite each other, so that they never cut off more than they bite.
  const std::uint64_t seed = SeedOf(horizon.Seed, Field::Bay);
  const double x = Random(seed, 0, 0) - 0.5;
  const double y = Random(seed, 1, 0) < 0.5 ? -0.7 : 0.7;
  horizon.Bays = { { x, y }, { -x, -y } };
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonGenerator::PlaceHoles(Horizon& horizon, int first, int last) const
{
  const std::uint64_t seed = SeedOf(horizon.Seed, Field::Hole);
  const double width = std::min(this->Given.Size[0], this->Given.Size[1]);
  for (int hole = first; hole < last; ++hole)
  {
    Feature feature;
    feature.Radius = hole == 0 ? 0.12 * width : std::max(1.5, (0.01 + 0.02 * Random(seed, hole, 0)) * width);
    Require(this->PlaceFeature(horizon, feature, Mix(seed + static_cast<std::uint64_t>(hole))),
      std::to_string(this->Given.NumberOfHoles) + " holes",
      "no more than the lattice has room for (" + std::to_string(hole) + ")");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonGenerator::PlaceIslands(Horizon& horizon) const
{
  const std::uint64_t seed = SeedOf(horizon.Seed, Field::Island);
  const double width = std::min(this->Given.Size[0], this->Given.Size[1]);
  for (int island = 0; island < this->Given.NumberOfIslands; ++island)
  {
    Feature feature;
    feature.Radius = std::max(1.5, (0.02 + 0.02 * Random(seed, island, 0)) * width);
    feature.Moat = std::max(4.0, 0.5 * feature.Radius);
    if (island == 0 && this->Given.NumberOfHoles > 0)
    {
      feature.I = horizon.Features.front().I;
      feature.J = horizon.Features.front().J;
      horizon.Features.push_back(feature);
      continue;
    }
    Require(this->PlaceFeature(horizon, feature, Mix(seed + static_cast<std::uint64_t>(island))),
      std::to_string(this->Given.NumberOfIslands) + " islands",
      "no more than the lattice has room for (" + std::to_string(island) + ")");
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonGenerator::PlaceFeature(Horizon& horizon, Feature feature, std::uint64_t seed) const
{
  constexpr int attempts = 1000;
  const bool isHole = feature.Moat == 0.0;
  for (int attempt = 0; attempt < 2 * attempts; ++attempt)
  {
    feature.I = Random(seed, attempt, 0) * (this->Given.Size[0] - 1);
    feature.J = Random(seed, attempt, 1) * (this->Given.Size[1] - 1);
    // An island lies outside the horizon, but if there is no room, in a hole of its own.
    const bool isInBody = isHole || attempt >= attempts;
    if (this->IsApart(horizon, feature) && this->HasRoom(horizon, feature, isInBody))
    {
      horizon.Features.push_back(feature);
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonGenerator::IsApart(const Horizon& horizon, const Feature& feature) const
{
  return std::all_of(horizon.Features.begin(), horizon.Features.end(),
    [&feature](const Feature& other)
    {
      const double di = feature.I - other.I;
      const double dj = feature.J - other.J;
      const double distance = Reach(feature) + Reach(other) + 4.0;
      return di * di + dj * dj >= distance * distance;
    });
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonGenerator::HasRoom(const Horizon& horizon, const Feature& feature, bool isInBody) const
{
  const double reach = Reach(feature) + 2.0;
  for (int di = -1; di <= 1; ++di)
  {
    for (int dj = -1; dj <= 1; ++dj)
    {
      if (this->IsInBody(horizon, feature.I + di * reach, feature.J + dj * reach) != isInBody)
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
HorizonGenerator::Place HorizonGenerator::PlaceOf(double i, double j) const
{
  return { 2.0 * i / std::max(1, this->Given.Size[0] - 1) - 1.0, 2.0 * j / std::max(1, this->Given.Size[1] - 1) - 1.0 };
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonGenerator::IsInBody(const Horizon& horizon, double i, double j) const
{
  const Place place = this->PlaceOf(i, j);
  const std::uint64_t outline = SeedOf(horizon.Seed, Field::Outline);
  for (const Place& bay : horizon.Bays)
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
    depth +=
      ragged * FractalNoise(SeedOf(horizon.Seed, Field::Raggedness), 6.0 * place.X, 6.0 * place.Y, this->RaggedOctaves);
  }
  return depth > 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonGenerator::IsOccupied(const Horizon& horizon, const std::vector<Feature>& features, int i, int j) const
{
  const std::uint64_t shape = SeedOf(horizon.Seed, Field::FeatureShape);
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
  return this->IsInBody(horizon, i, j);
}

//----------------------------------------------------------------------------------------------------------------------
bool HorizonGenerator::IsDropout(const Horizon& horizon, int i, int j) const
{
  const std::uint64_t seed = SeedOf(horizon.Seed, Field::Dropout);
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

// ---- Voxels
// ------------------------------------------------------------------------------------------------------------
double HorizonGenerator::Fold(const Place& place) const
{
  const std::uint64_t phase = SeedOf(this->Given.Seed, Field::FoldPhase);
  const std::uint64_t detail = SeedOf(this->Given.Seed, Field::FoldDetail);
  // A rational point of the unit circle: no sine or cosine is the same everywhere.
  const double t = Random(SeedOf(this->Given.Seed, Field::FoldDirection), 0, 0);
  const double c = (1.0 - t * t) / (1.0 + t * t);
  const double s = 2.0 * t / (1.0 + t * t);
  const double bend = 0.15 * Noise(detail, place.X, place.Y);
  const double along = Wave(0.6 * (c * place.X + s * place.Y) + bend + Random(phase, 0, 0));
  const double across = Wave(0.9 * (c * place.Y - s * place.X) + bend + Random(phase, 1, 0));
  return 0.55 * along + 0.25 * across + 0.2 * FractalNoise(detail, 3.0 * place.X, 3.0 * place.Y, 3);
}

//----------------------------------------------------------------------------------------------------------------------
double HorizonGenerator::Elevation(int position, const Place& place, int i, int j) const
{
  // The folds take 55 % of the depth. The horizons share the rest and leave at least half of their share between each
  // other, which is more than one cell as nZ is at least five times their number.
  const std::uint64_t seed = this->Horizons[static_cast<std::size_t>(position)].Seed;
  const double depth = this->Given.Size[2] - 1;
  const double share = 0.45 * depth / this->Given.NumberOfHorizons;
  const double roughness = std::min(0.05, 0.4 / share); // at most 0.4 cells
  const double distance =
    (0.25 - roughness) * FractalNoise(SeedOf(seed, Field::Distance), 2.0 * place.X, 2.0 * place.Y, 3) +
    roughness * Noise(SeedOf(seed, Field::Roughness), i / 5.0, j / 5.0);
  return 0.55 * depth * (0.5 + 0.5 * this->Fold(place)) + share * (position + 0.5 + distance);
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixVoxel HorizonGenerator::MakeVoxel(int position, int i, int j) const
{
  const std::uint64_t seed = this->Horizons[static_cast<std::size_t>(position)].Seed;
  const Place place = this->PlaceOf(i, j);
  const double elevation = this->Elevation(position, place, i, j);
  const bool isNegative = Noise(SeedOf(seed, Field::Polarity), 5.0 * place.X, 5.0 * place.Y) > 0.6;
  const double strength = 1200.0 +
    800.0 * FractalNoise(SeedOf(seed, Field::Amplitude), 4.0 * place.X, 4.0 * place.Y, 2) +
    100.0 * Random(SeedOf(seed, Field::Speckle), i, j);
  SparseMatrixVoxel voxel;
  voxel.VerticalIndex = static_cast<int>(std::floor(elevation + 0.5));
  voxel.SurfaceId = position + 1;
  voxel.Thickness =
    Round(3.5 + 2.5 * FractalNoise(SeedOf(seed, Field::Thickness), 3.0 * place.X, 3.0 * place.Y, 2), 100.0);
  voxel.Amplitude = Round(isNegative ? -strength : strength, 10.0);
  voxel.RealZ = Round(TimePerSample * elevation, 1000.0);
  return voxel;
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonGenerator::MakeRow(int position, int j, std::vector<RowVoxel>& row) const
{
  const Horizon& horizon = this->Horizons[static_cast<std::size_t>(position)];
  std::vector<Feature> features;
  std::copy_if(horizon.Features.begin(), horizon.Features.end(), std::back_inserter(features),
    [j](const Feature& feature) { return std::abs(j - feature.J) < Reach(feature); });
  row.clear();
  for (int i = 0; i < this->Given.Size[0]; ++i)
  {
    if (this->IsOccupied(horizon, features, i, j) && !this->IsDropout(horizon, i, j))
    {
      row.push_back({ i, this->MakeVoxel(position, i, j) });
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
HorizonVoxels HorizonGenerator::MakeHorizon(int position) const
{
  HorizonVoxels horizon;
  horizon.SurfaceId = position + 1;
  std::vector<RowVoxel> row;
  for (int j = 0; j < this->Given.Size[1]; ++j)
  {
    this->MakeRow(position, j, row);
    for (const RowVoxel& entry : row)
    {
      horizon.I.push_back(entry.I);
      horizon.J.push_back(j);
      horizon.K.push_back(entry.Voxel.VerticalIndex);
      horizon.Thickness.push_back(entry.Voxel.Thickness);
      horizon.Amplitude.push_back(entry.Voxel.Amplitude);
      horizon.RealZ.push_back(entry.Voxel.RealZ);
    }
  }
  return horizon;
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixCounts HorizonGenerator::Write(std::ostream& stream, const Monitor& monitor) const
{
  const auto [nX, nY, nZ] = this->Given.Size;
  stream << std::to_string(nX) + ' ' + std::to_string(nY) + ' ' + std::to_string(nZ) + '\n';
  SparseMatrixCounts counts;
  std::vector<RowVoxel> row;
  std::vector<std::string> columns(static_cast<std::size_t>(nX));
  for (int j = 0; j < nY; ++j)
  {
    for (int position = 0; position < this->Given.NumberOfHorizons; ++position)
    {
      this->MakeRow(position, j, row);
      counts[position + 1] += static_cast<std::int64_t>(row.size());
      for (const RowVoxel& entry : row)
      {
        AppendVoxel(columns[static_cast<std::size_t>(entry.I)], entry.Voxel);
      }
    }
    for (std::string& column : columns)
    {
      column += '\n';
      stream.write(column.data(), static_cast<std::streamsize>(column.size()));
      column.clear();
    }
    monitor.Progress((j + 1.0) / nY);
  }
  if (!stream.flush())
  {
    throw std::runtime_error("writing failed");
  }
  return counts;
}
}
