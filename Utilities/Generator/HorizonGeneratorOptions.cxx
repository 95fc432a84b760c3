// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonGeneratorOptions.h"

#include "Common/Errors.h"

#include <limits>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void Require(bool condition, const std::string& found, const std::string& expected)
{
  if (!condition)
  {
    throw InputError(found + ", expected " + expected);
  }
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
}
}
