// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances of samples on the faces of a surface.

#ifndef SeismicHorizonsFaceMeter_h
#define SeismicHorizonsFaceMeter_h

#include "Common/Monitor.h"
#include "MeasuredSurface.h"
#include "WeightedHistogram.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace SeismicHorizons
{
/// What the samples on the faces of a surface, or of a chunk of it, add up to, by metric.
struct FaceSums
{
  struct Sums
  {
    double Area = 0.0;
    double Distance = 0.0; // weighted by area
    double Square = 0.0; // of the distance, weighted by area
    double Largest = 0.0;
  };
  std::array<Sums, MostMetrics> In;
  std::int64_t Samples = 0;

  void Add(const FaceSums& other)
  {
    for (std::size_t metric = 0; metric < MostMetrics; ++metric)
    {
      this->In[metric].Area += other.In[metric].Area;
      this->In[metric].Distance += other.In[metric].Distance;
      this->In[metric].Square += other.In[metric].Square;
      this->In[metric].Largest = std::max(this->In[metric].Largest, other.In[metric].Largest);
    }
    this->Samples += other.Samples;
  }
};

using Histograms = std::array<WeightedHistogram, MostMetrics>;

/// Measures `density` samples on each unit of area in the first metric, at least one on each triangle with an area. All
/// distances are added to the histograms, by metric, weighted by area: both surfaces together weigh as much as any two.
FaceSums MeasureFaces(const MeasuredSurface& from, const MeasuredSurface& to, double density, std::uint64_t seed,
  Histograms& histograms, const Monitor& monitor);
}

#endif
