// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VerticalSampling.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
// A sample suffices for the median, which is expensive.
constexpr std::size_t MostDifferences = 1 << 20;

class DifferenceList
{
public:
  explicit DifferenceList(std::size_t points)
    : Stride(points / MostDifferences + 1)
  {
  }

  void Add(const LatticeHorizon& horizon)
  {
    std::size_t above = 0;
    for (std::size_t n = 0; n < horizon.RealZ.size(); ++n)
    {
      const int i = horizon.Column[n].X;
      const int j = horizon.Column[n].Y;
      if (n + 1 < horizon.RealZ.size() && horizon.Column[n + 1].Y == j && horizon.Column[n + 1].X == i + 1)
      {
        this->Add(horizon.RealZ[n + 1] - horizon.RealZ[n]);
      }
      while (above < horizon.RealZ.size() &&
        (horizon.Column[above].Y <= j || (horizon.Column[above].Y == j + 1 && horizon.Column[above].X < i)))
      {
        ++above;
      }
      if (above < horizon.RealZ.size() && horizon.Column[above].Y == j + 1 && horizon.Column[above].X == i)
      {
        this->Add(horizon.RealZ[above] - horizon.RealZ[n]);
      }
    }
  }

  /// Ignores zeros; returns 0 if all are zeros.
  double Median()
  {
    if (this->Differences.empty())
    {
      return 0.0;
    }
    return UpperMedian(this->Differences);
  }

private:
  void Add(double difference)
  {
    if (difference != 0.0 && this->Count++ % this->Stride == 0)
    {
      this->Differences.push_back(std::abs(difference));
    }
  }

  const std::size_t Stride;
  std::size_t Count = 0;
  std::vector<double> Differences;
};

/// Rounds to 1, 2 or 5 times a power of ten, by ratio.
double RoundStep(double step)
{
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  const double digits = step / power;
  const double rounded = digits < std::sqrt(2.0) ? 1.0
    : digits < std::sqrt(10.0)                   ? 2.0
    : digits < std::sqrt(50.0)                   ? 5.0
                                                 : 10.0;
  return rounded * power;
}

double SuitableStep(const LatticeHorizon* horizons, std::size_t count)
{
  std::size_t points = 0;
  for (std::size_t n = 0; n < count; ++n)
  {
    points += horizons[n].RealZ.size();
  }
  DifferenceList differences(2 * points);
  for (std::size_t n = 0; n < count; ++n)
  {
    differences.Add(horizons[n]);
  }
  const double median = differences.Median();
  return median > 0.0 && std::isfinite(median) ? RoundStep(median) : 1.0;
}

VerticalSampling FindHorizonSampling(const LatticeHorizon* horizons, std::size_t count, double step)
{
  if (!(step >= 0.0 && std::isfinite(step)))
  {
    std::ostringstream text;
    text << "VerticalStep " << step << ", expected a positive number, or 0 for one that suits the data";
    throw InputError(text.str());
  }
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t n = 0; n < count; ++n)
  {
    for (const double z : horizons[n].RealZ)
    {
      least = std::min(least, z);
      most = std::max(most, z);
    }
  }
  VerticalSampling sampling;
  sampling.Step = step > 0.0 ? step : SuitableStep(horizons, count);
  if (!(least <= most))
  {
    return sampling;
  }
  sampling.First = std::floor(least / sampling.Step) * sampling.Step;
  const double indices = std::ceil((most - sampling.First) / sampling.Step) + 1.0;
  if (!(indices <= double(std::numeric_limits<int>::max())))
  {
    std::ostringstream text;
    text << "VerticalStep " << sampling.Step << " for z from " << least << " to " << most
         << ", expected one that makes less than 2^31 vertical indices, and NullValues for numbers that mean no z";
    throw InputError(text.str());
  }
  sampling.Indices = int(indices);
  return sampling;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<VerticalSampling> FindVerticalSamplings(
  const std::vector<LatticeHorizon>& horizons, double step, const Monitor& monitor)
{
  monitor.Progress(0.0);
  if (step != 0.0)
  {
    return std::vector<VerticalSampling>(horizons.size(), FindHorizonSampling(horizons.data(), horizons.size(), step));
  }
  std::vector<VerticalSampling> samplings;
  for (const LatticeHorizon& horizon : horizons)
  {
    samplings.push_back(FindHorizonSampling(&horizon, 1, step));
    monitor.Progress(double(samplings.size()) / double(horizons.size()));
  }
  return samplings;
}
}
