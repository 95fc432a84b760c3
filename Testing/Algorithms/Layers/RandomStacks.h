// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stacks of horizons from random numbers, with all that is hard for layers: ragged outlines and holes, ties, noise that
// makes horizons cross, and horizons that run into each other.

#ifndef SeismicHorizonsRandomStacks_h
#define SeismicHorizonsRandomStacks_h

#include "LayerChecker.h"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace RandomStacks
{
using namespace SeismicHorizons;
using LayerChecker::Horizon;

struct Stack
{
  std::vector<Horizon> Horizons; // the uppermost first
  LayerOptions Options;
  std::shared_ptr<LinkCuts> Cuts; // where horizons are thrown; null for most stacks
};

class Generator
{
public:
  explicit Generator(unsigned seed)
    : Random(seed)
  {
  }

  Stack Run()
  {
    Stack stack;
    stack.Horizons.resize(std::size_t(this->Whole(2, 5)));
    this->Width = this->Whole(2, 24);
    this->Height = this->Whole(2, 24);
    this->ChooseOptions(stack);
    const bool isWhole = this->Whole(0, 1) == 1;
    const double noise = this->Pick({ 0.0, 0.3, 1.0, 3.0 });
    const double gap = this->Pick({ 0.0, 1.0, 4.0 });
    const int missing = this->Whole(0, 3) * this->Whole(0, 12); // percent
    const bool areMasksOwn = this->Whole(0, 2) == 0;
    this->MakeMask(missing);
    const double sign = stack.Options.Crossings.HeightsGrowDownwards ? -1.0 : 1.0;
    this->MakeFaults(stack);
    for (std::size_t n = 0; n < stack.Horizons.size(); ++n)
    {
      if (areMasksOwn && n > 0)
      {
        this->MakeMask(missing);
      }
      const Shape shape = this->MakeShape();
      for (int y = 0; y < this->Height; ++y)
      {
        for (int x = 0; x < this->Width; ++x)
        {
          const double height = shape.At(x, y) - gap * double(n) + noise * this->Real(-1.0, 1.0) +
            this->Thrown[std::size_t(y * this->Width + x)];
          if (this->Mask[std::size_t(y * this->Width + x)] != 0)
          {
            stack.Horizons[n].Columns.push_back({ x - 3, y + 5 });
            stack.Horizons[n].Heights.push_back(sign * (isWhole ? std::round(height) : height));
          }
        }
      }
    }
    return stack;
  }

private:
  struct Shape
  {
    double SlopeX, SlopeY, Waves, Length, Phase;

    double At(int x, int y) const
    {
      return this->SlopeX * x + this->SlopeY * y + this->Waves * std::sin((x + 0.7 * y) / this->Length + this->Phase);
    }
  };

  int Whole(int least, int most) { return least + int(this->Random() % unsigned(most - least + 1)); }
  double Real(double least, double most) { return least + (most - least) * double(this->Random()) / 4294967296.0; }
  double Pick(const std::vector<double>& values) { return values[this->Random() % values.size()]; }

  Shape MakeShape()
  {
    const bool isTilted = this->Whole(0, 2) == 0;
    return { isTilted ? this->Real(-0.5, 0.5) : 0.1, isTilted ? this->Real(-0.5, 0.5) : 0.05,
      this->Pick({ 0.0, 1.0, 5.0 }), this->Real(1.0, 6.0), this->Real(0.0, 6.0) };
  }

  void ChooseOptions(Stack& stack)
  {
    LayerOptions& options = stack.Options;
    options.MaximumError = this->Pick({ 0.0, 0.3, 0.75, 2.0 });
    options.OutlineTolerance = this->Pick({ 0.0, 0.75, 1.5 });
    const bool hasGaps = this->Whole(0, 3) == 0; // that outlines pass over, or close
    options.Radius = hasGaps ? this->Whole(1, 3) : 1;
    options.SmallestHoleSize = hasGaps ? this->Whole(1, 12) : 1;
    options.Crossings.HeightsGrowDownwards = this->Whole(0, 1) == 1;
    options.Crossings.MinimumThickness = this->Pick({ 0.0, 0.0, 0.5 });
    options.FitHeights = this->Whole(0, 2) > 0;
    options.Effort = this->Whole(0, 2) > 0 ? DecimationEffort::Best : DecimationEffort::Fast;
    options.SmallestAngle = this->Pick({ 0.0, 2.0, 10.0, 30.0 });
    options.BoundThickness = this->Whole(0, 3) == 0;
    options.PinchOutLines = this->Whole(0, 2) > 0;
    options.SmallestPinch = this->Whole(0, 1) == 0 ? 1 : this->Whole(2, 25);
    options.Crossings.Policies.clear();
    for (std::size_t n = 0; n + 1 < stack.Horizons.size(); ++n)
    {
      const int policy = this->Whole(0, 2);
      options.Crossings.Policies.push_back(policy == 0 ? CrossingPolicy::Mean
          : policy == 1                                ? CrossingPolicy::UpperWins
                                                       : CrossingPolicy::LowerWins);
    }
  }

  /// Up to three faults, which may cross and end inside: links from one side of a line to the other one are cut along
  /// a part of it.
  void MakeFaults(Stack& stack)
  {
    this->Thrown.assign(std::size_t(this->Width * this->Height), 0.0);
    for (int fault = this->Whole(0, 2) == 0 ? this->Whole(1, 3) : 0; fault > 0; --fault)
    {
      const double angle = this->Real(0.0, 6.3);
      const double middleX = this->Real(0.0, this->Width);
      const double middleY = this->Real(0.0, this->Height);
      const double half = this->Real(1.0, 20.0);
      const double most = this->Pick({ 0.0, 2.0, 8.0 });
      // Across and along the line.
      const auto across = [&](int x, int y)
      { return (x - middleX) * std::cos(angle) + (y - middleY) * std::sin(angle); };
      const auto along = [&](int x, int y)
      { return (y - middleY) * std::cos(angle) - (x - middleX) * std::sin(angle); };
      const auto isCut = [&](int x, int y, int toX, int toY)
      { return (across(x, y) > 0.0) != (across(toX, toY) > 0.0) && std::abs(along(x, y)) < half; };
      if (!stack.Cuts)
      {
        PlaneBox box;
        box.Least = { -3, 5 };
        box.Greatest = { this->Width - 4, this->Height + 4 };
        stack.Cuts = std::make_shared<LinkCuts>(box);
      }
      for (int y = 0; y < this->Height; ++y)
      {
        for (int x = 0; x < this->Width; ++x)
        {
          const bool isThrown = across(x, y) > 0.0 && std::abs(along(x, y)) < half;
          this->Thrown[std::size_t(y * this->Width + x)] +=
            isThrown ? most * (1.0 - std::abs(along(x, y)) / half) : 0.0;
          if (isCut(x, y, x + 1, y))
          {
            stack.Cuts->CutEast({ x - 3, y + 5 });
          }
          if (isCut(x, y, x, y + 1))
          {
            stack.Cuts->CutNorth({ x - 3, y + 5 });
          }
        }
      }
    }
    stack.Options.Cuts = stack.Cuts.get();
  }

  /// Single columns and discs.
  void MakeMask(int missing)
  {
    this->Mask.assign(std::size_t(this->Width * this->Height), 1);
    for (unsigned char& one : this->Mask)
    {
      one = this->Whole(0, 99) < missing ? 0 : 1;
    }
    for (int disc = this->Whole(0, 2); disc > 0; --disc)
    {
      const int middleX = this->Whole(0, this->Width);
      const int middleY = this->Whole(0, this->Height);
      const int radius = this->Whole(0, 6);
      for (int n = 0; n < this->Width * this->Height; ++n)
      {
        const int x = n % this->Width - middleX;
        const int y = n / this->Width - middleY;
        this->Mask[std::size_t(n)] = x * x + y * y < radius * radius ? 0 : this->Mask[std::size_t(n)];
      }
    }
  }

  std::mt19937 Random;
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Mask;
  std::vector<double> Thrown; // by the faults
};
}

#endif
