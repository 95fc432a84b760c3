// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonGeneratorOptions.h"

#include "Common/Base/Errors.h"

#include <limits>

namespace SeismicHorizons
{
namespace
{
void CheckNoise(const HorizonGeneratorOptions& options)
{
  Require(options.NoiseFraction >= 0.0 && options.NoiseFraction <= 1.0,
    "noise " + std::to_string(options.NoiseFraction), "a part of the area from 0 to 1");
  Require(options.NoiseGaps >= 0.0 && options.NoiseGaps < 1.0, "noise gaps " + std::to_string(options.NoiseGaps),
    "a part of the voxels from 0 to below 1");
  // Horizons leave half of their share to each other. One cell of that has to remain, and half of one for rounding.
  const double most = 0.25 * ShareOfDepth(options) - 0.75;
  Require(options.NoiseHeight >= 0.0 && (options.NoiseFraction == 0.0 || options.NoiseHeight <= most),
    "noise height " + std::to_string(options.NoiseHeight),
    "0 to " + std::to_string(most) + ", for which there is room between the horizons");
}
}

//----------------------------------------------------------------------------------------------------------------------
void Require(bool condition, const std::string& found, const std::string& expected)
{
  if (!condition)
  {
    throw InputError(found + ", expected " + expected);
  }
}

//----------------------------------------------------------------------------------------------------------------------
double ShareOfDepth(const HorizonGeneratorOptions& options)
{
  return 0.45 * (options.Size[2] - 1) / options.NumberOfHorizons;
}

//----------------------------------------------------------------------------------------------------------------------
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
  CheckNoise(options);
}
}
