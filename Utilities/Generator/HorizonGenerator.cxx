// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every value is computed from its place alone, by noise on hashed lattice points instead of sequences of random
// numbers. So a horizon can be made row by row, in any order, without memory of the rows before.

#include "HorizonGenerator.h"

#include "SmoothNoise.h"
#include "VoxelText.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{

// The columns of the lattice on which FindSize tries how many are occupied.
constexpr double ColumnsToTry = 90000.0;
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGenerator::HorizonGenerator(const HorizonGeneratorOptions& options)
  : Given(options)
{
  CheckOptions(options);
  for (int position = 0; position < options.NumberOfHorizons; ++position)
  {
    this->Shapes.emplace_back(options, Mix(options.Seed + Mix(static_cast<std::uint64_t>(position))));
  }
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixSize HorizonGenerator::FindSize(const HorizonGeneratorOptions& options, std::int64_t numberOfVoxels)
{
  Require(numberOfVoxels > 0, std::to_string(numberOfVoxels) + " points", "at least 1");
  CheckOptions(options);
  // Which part of the columns is occupied hardly depends on the size, and so is found on a lattice of moderate size.
  HorizonGeneratorOptions probe = options;
  const double width = std::sqrt(ColumnsToTry * options.Size[0] / options.Size[1]);
  probe.Size = { std::max(1, static_cast<int>(width)), std::max(1, static_cast<int>(ColumnsToTry / width)),
    options.Size[2] };
  const HorizonGenerator generator(probe);
  double occupied = 0.0;
  for (int position = 0; position < options.NumberOfHorizons; ++position)
  {
    occupied += static_cast<double>(generator.MakeHorizon(position).Column.size());
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
double HorizonGenerator::Fold(const FramePlace& place) const
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
double HorizonGenerator::Elevation(int position, const FramePlace& place, int i, int j) const
{
  // The folds take 55 % of the depth. The horizons share the rest and leave at least half of their share between each
  // other, which is more than one cell as nZ is at least five times their number.
  const std::uint64_t seed = this->Shapes[static_cast<std::size_t>(position)].Seed();
  const double depth = this->Given.Size[2] - 1;
  const double share = ShareOfDepth(this->Given);
  const double roughness = std::min(0.05, 0.4 / share); // at most 0.4 cells
  const double distance =
    (0.25 - roughness) * FractalNoise(SeedOf(seed, Field::Distance), 2.0 * place.X, 2.0 * place.Y, 3) +
    roughness * Noise(SeedOf(seed, Field::Roughness), i / 5.0, j / 5.0);
  const double noise = this->Shapes[static_cast<std::size_t>(position)].RoughPlaces().Offset(i, j);
  return 0.55 * depth * (0.5 + 0.5 * this->Fold(place)) + share * (position + 0.5 + distance) + noise;
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixVoxel HorizonGenerator::MakeVoxel(int position, int i, int j) const
{
  const std::uint64_t seed = this->Shapes[static_cast<std::size_t>(position)].Seed();
  const FramePlace place = ToFrame(this->Given.Size, i, j);
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
  row.clear();
  for (const int i : this->Shapes[static_cast<std::size_t>(position)].FindRow(j))
  {
    row.push_back({ i, this->MakeVoxel(position, i, j) });
  }
}

//----------------------------------------------------------------------------------------------------------------------
LatticeHorizon HorizonGenerator::MakeHorizon(int position) const
{
  LatticeHorizon horizon;
  horizon.SurfaceId = position + 1;
  std::vector<RowVoxel> row;
  for (int j = 0; j < this->Given.Size[1]; ++j)
  {
    this->MakeRow(position, j, row);
    for (const RowVoxel& entry : row)
    {
      horizon.Column.push_back({ entry.I, j });
      horizon.K.push_back(entry.Voxel.VerticalIndex);
      horizon.Thickness.push_back(entry.Voxel.Thickness);
      horizon.Amplitude.push_back(entry.Voxel.Amplitude);
      horizon.RealZ.push_back(entry.Voxel.RealZ);
    }
  }
  return horizon;
}

//----------------------------------------------------------------------------------------------------------------------
std::map<int, std::int64_t> HorizonGenerator::Write(std::ostream& stream, const Monitor& monitor) const
{
  const int nX = this->Given.Size[0];
  const int nY = this->Given.Size[1];
  WriteHeader(this->Given.Size, stream);
  std::map<int, std::int64_t> counts;
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
    WriteLines(columns, stream);
    monitor.Progress((j + 1.0) / nY);
  }
  FinishFile(stream);
  return counts;
}
}
