// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultGenerator.h"

#include "SmoothNoise.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/// A line through the middle of a fault, bent as a parabola.
class Fault
{
public:
  Fault(const FaultGeneratorOptions& options, double x, double y, double angle, std::uint64_t seed)
    : X(x)
    , Y(y)
    , AlongX(std::cos(angle))
    , AlongY(std::sin(angle))
    , Bend(0.001 * (2.0 * Random(seed, 1, 0) - 1.0))
    , HalfLength((0.25 + 0.15 * Random(seed, 2, 0)) * options.Size)
    , Throw(Random(seed, 3, 0) < 0.5 ? options.Throw : -options.Throw)
    , IsTapered(options.AreTapered)
    , RampWidth(options.RampWidth)
  {
  }

  /// How far a place is from the line, with a sign by side.
  double Distance(double x, double y) const
  {
    const double along = this->Along(x, y);
    return (y - this->Y) * this->AlongX - (x - this->X) * this->AlongY - this->Bend * along * along;
  }

  double ThrowAt(double x, double y) const
  {
    const double part = this->Along(x, y) / this->HalfLength;
    return !this->IsTapered ? this->Throw : std::abs(part) < 1.0 ? this->Throw * (1.0 - part * part) : 0.0;
  }

  /// How far the fault moves a place up or down: half the throw at the line, less away from it where the throw tapers.
  double Shift(double x, double y) const
  {
    constexpr double Fade = 50.0; // columns
    const double distance = this->Distance(x, y);
    const double fade = this->IsTapered ? std::exp(-std::abs(distance) / Fade) : 1.0;
    const double side = std::abs(distance) < 0.5 * this->RampWidth ? distance / this->RampWidth
      : distance < 0.0                                             ? -0.5
                                                                   : 0.5;
    return side * this->ThrowAt(x, y) * fade;
  }

  double StepBetween(double x, double y, double otherX, double otherY) const
  {
    const bool isBelow = this->Distance(x, y) < 0.0;
    if (isBelow == (this->Distance(otherX, otherY) < 0.0))
    {
      return 0.0;
    }
    const double step = this->ThrowAt(0.5 * (x + otherX), 0.5 * (y + otherY));
    return isBelow ? step : -step;
  }

private:
  double Along(double x, double y) const { return (x - this->X) * this->AlongX + (y - this->Y) * this->AlongY; }

  double X, Y;
  double AlongX, AlongY;
  double Bend;
  double HalfLength;
  double Throw;
  bool IsTapered;
  double RampWidth;
};

class FaultedSurface
{
public:
  explicit FaultedSurface(const FaultGeneratorOptions& options)
    : Given(options)
    , DipAngle(2.0 * Pi * Random(options.Seed, 0, 1))
  {
    const double angle = Pi * Random(options.Seed, 0, 0);
    this->AddRow(angle, 10);
    if (options.AreCrossed)
    {
      this->AddRow(angle + Pi * (0.3 + 0.3 * Random(options.Seed, 0, 2)), 20);
    }
  }

  bool IsGap(int i, int j) const
  {
    const int holeStart = (this->Given.Size - this->Given.HoleSize) / 2;
    if (std::min(i, j) >= holeStart && std::max(i, j) < holeStart + this->Given.HoleSize)
    {
      return true;
    }
    for (const Fault& fault : this->Faults)
    {
      constexpr double LeastThrow = 1.0; // there is no gap where there is hardly a fault
      if (std::abs(fault.Distance(i, j)) < 0.5 * this->Given.GapWidth && std::abs(fault.ThrowAt(i, j)) > LeastThrow)
      {
        return true;
      }
    }
    return false;
  }

  double Height(int i, int j) const
  {
    const int before = j % this->Given.PickSpacing;
    const double part = double(before) / this->Given.PickSpacing;
    const double height = before == 0
      ? this->Pick(i, j)
      : (1.0 - part) * this->Pick(i, j - before) + part * this->Pick(i, j - before + this->Given.PickSpacing);
    return this->Given.AreHeightsWhole ? std::round(height) : height;
  }

  double Throw(int i, int j, bool isNorth) const
  {
    double step = 0.0;
    for (const Fault& fault : this->Faults)
    {
      step += fault.StepBetween(i, j, isNorth ? i : i + 1, isNorth ? j + 1 : j);
    }
    return step;
  }

private:
  double Pick(int i, int j) const
  {
    const std::uint64_t seed = this->Given.Seed;
    constexpr double FoldWidth = 40.0; // columns
    double height = this->Given.Dip * (i * std::cos(this->DipAngle) + j * std::sin(this->DipAngle));
    height += this->Given.Fold * FoldWidth * this->Given.Dip * Noise(Mix(seed), i / FoldWidth, j / FoldWidth);
    for (const Fault& fault : this->Faults)
    {
      height += fault.Shift(i, j);
    }
    height += this->Given.Noise * NormalNoise(Mix(seed + 1), i, j);
    return height;
  }

  /// Faults side by side, in the middle of strips of the lattice.
  void AddRow(double angle, std::int64_t number)
  {
    const double middle = 0.5 * (this->Given.Size - 1);
    for (int n = 0; n < this->Given.NumberOfFaults; ++n)
    {
      const double offset = ((n + 0.5) / this->Given.NumberOfFaults - 0.5) * 0.8 * this->Given.Size;
      this->Faults.emplace_back(this->Given, middle - offset * std::sin(angle), middle + offset * std::cos(angle),
        angle, Mix(this->Given.Seed + std::uint64_t(number + n)));
    }
  }

  /// By the method of Box and Muller.
  static double NormalNoise(std::uint64_t seed, int i, int j)
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Random(seed, i, j)));
    return radius * std::cos(2.0 * Pi * Random(Mix(seed + 1), i, j));
  }

  FaultGeneratorOptions Given;
  double DipAngle;
  std::vector<Fault> Faults;
};
}

//----------------------------------------------------------------------------------------------------------------------
FaultedHorizon MakeFaultedHorizon(const FaultGeneratorOptions& options)
{
  const FaultedSurface surface(options);
  FaultedHorizon horizon;
  for (int j = 0; j < options.Size; ++j)
  {
    for (int i = 0; i < options.Size; ++i)
    {
      if (!surface.IsGap(i, j))
      {
        horizon.Columns.push_back({ i, j });
        horizon.Height.push_back(surface.Height(i, j));
      }
      for (const bool isNorth : { false, true })
      {
        const double step = (isNorth ? j : i) + 1 < options.Size ? surface.Throw(i, j, isNorth) : 0.0;
        if (step != 0.0)
        {
          horizon.Torn.push_back({ { i, j }, isNorth, step });
        }
      }
    }
  }
  return horizon;
}
}
