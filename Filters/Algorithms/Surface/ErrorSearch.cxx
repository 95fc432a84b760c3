// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ErrorSearch.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr double FirstError = 0.75;
constexpr double Power = 1.5; // the number of triangles is as the error to the power of minus this
// How far a first guess goes beyond where that leads, as a factor of the error: it is to come out on the other side.
constexpr double Beyond = 1.3;
// The search ends with so much of the number, or when its ends are so near to each other, as a factor.
constexpr double EnoughOfNumber = 0.97;
constexpr double NearEnough = 1.02;
// Secants keep so far away from their ends, as a part of the way: the line is not quite straight.
constexpr double KeptAway = 0.1;

/// Logarithms of an error, and of the part that its triangles are of the number.
struct Sample
{
  bool IsKnown = false;
  double Error = 0.0;
  double Part = 0.0;
};

class Search
{
public:
  Search(std::size_t most, double largest)
    : Most(double(most))
    , Least(std::log(SmallestSearchedError))
    , Largest(std::max(std::log(largest), this->Least))
    , Next(std::clamp(std::log(FirstError), this->Least, this->Largest))
  {
  }

  double NextError() const { return std::exp(this->Next); }

  /// What the next error gives.
  void Add(std::size_t triangles)
  {
    const bool isFirst = !this->Fine.IsKnown && !this->Coarse.IsKnown;
    const double part = std::log(double(std::max<std::size_t>(triangles, 1)) / this->Most);
    (part > 0.0 ? this->Fine : this->Coarse) = { true, this->Next, part };
    if (this->Fine.IsKnown && this->Coarse.IsKnown)
    {
      this->Next = this->Secant();
    }
    else if (isFirst)
    {
      const double beyond = part > 0.0 ? std::log(Beyond) : -std::log(Beyond);
      this->Next = std::clamp(this->Next + part / Power + beyond, this->Least, this->Largest);
    }
    else
    {
      this->Next = this->Fine.IsKnown ? this->Largest : this->Least;
    }
  }

  bool IsDone() const
  {
    if (!this->Coarse.IsKnown)
    {
      return this->Fine.IsKnown && this->Fine.Error == this->Largest;
    }
    return this->Coarse.Part >= std::log(EnoughOfNumber) || this->Coarse.Error == this->Least ||
      (this->Fine.IsKnown && this->Coarse.Error - this->Fine.Error <= std::log(NearEnough));
  }

  bool HasFound() const { return this->Coarse.IsKnown; }
  double Found() const { return std::exp(this->Coarse.Error); }

private:
  double Secant() const
  {
    const double way = this->Fine.Part / (this->Fine.Part - this->Coarse.Part);
    return this->Fine.Error + std::clamp(way, KeptAway, 1.0 - KeptAway) * (this->Coarse.Error - this->Fine.Error);
  }

  const double Most;
  const double Least;
  const double Largest;
  double Next;
  Sample Fine; // the largest error that gave more triangles than the number
  Sample Coarse; // the least one that did not
};
}

//----------------------------------------------------------------------------------------------------------------------
InputError TooFewTriangles(std::size_t most, std::size_t least)
{
  return InputError("maximum number of triangles " + std::to_string(most) + ", expected at least the " +
    std::to_string(least) + " that the outlines alone take");
}

//----------------------------------------------------------------------------------------------------------------------
double FindErrorForTriangles(std::size_t most, double largest, const TriangleCounter& count)
{
  Search search(most, largest);
  std::size_t triangles = 0;
  for (int run = 0; run < MostSearchRuns && !search.IsDone(); ++run)
  {
    triangles = count(search.NextError());
    search.Add(triangles);
  }
  if (!search.HasFound())
  {
    throw TooFewTriangles(most, triangles);
  }
  return search.Found();
}
}
