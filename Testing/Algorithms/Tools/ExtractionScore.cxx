// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ExtractionScore.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr int Nowhere = -1;

class Scorer
{
public:
  Scorer(const CubeGenerator& cube, const Extraction& extraction)
    : Truth(cube.Truth())
    , Size(cube.Options().Size)
    , HasFault(cube.Options().FaultThrow > 0.0)
    , HasChannel(cube.Options().Channels > 0)
    // The middle lobe of the wavelet is 0.45 / f wide: half a period.
    , Tolerance(0.225 * 1000.0 / (cube.Options().Frequency * cube.Options().SampleInterval))
    , Surfaces(extraction.Surfaces)
  {
    const std::size_t columns = std::size_t(this->Size[0]) * std::size_t(this->Size[1]);
    this->Places.assign(std::size_t(this->Truth.Size()), std::vector<double>(columns));
    for (int n = 0; n < this->Truth.Size(); ++n)
    {
      for (int j = 0; j < this->Size[1]; ++j)
      {
        for (int i = 0; i < this->Size[0]; ++i)
        {
          const bool isLive = !this->Truth.IsDead(i, j) && !this->Truth.IsMissing(i, j);
          this->Places[std::size_t(n)][this->ColumnAt(i, j)] =
            isLive ? this->Truth.Place(n, i, j) : std::numeric_limits<double>::quiet_NaN();
        }
      }
    }
  }

  ExtractionScore Score()
  {
    this->Hits.assign(this->Surfaces.size(), std::vector<SideCounts>(this->Places.size(), SideCounts{ 0, 0 }));
    for (std::size_t surface = 0; surface < this->Surfaces.size(); ++surface)
    {
      this->CountHits(surface);
    }
    for (std::size_t reflector = 0; reflector < this->Places.size(); ++reflector)
    {
      this->ScoreReflector(reflector);
    }
    for (const std::size_t surface : this->Best)
    {
      this->CountWrong(surface);
    }
    this->Result.Reflectors = std::int64_t(this->Places.size());
    return this->Result;
  }

private:
  using SideCounts = std::array<std::int64_t, 2>;

  std::size_t ColumnAt(int i, int j) const { return std::size_t(i) + std::size_t(this->Size[0]) * std::size_t(j); }

  std::size_t SideOf(int i, int j, double sample) const
  {
    return this->HasFault && this->Truth.FaultDistance(i, j, sample) > 0.0 ? 1 : 0;
  }

  bool IsOn(std::size_t reflector, const LatticeHorizon& surface, std::size_t voxel) const
  {
    const std::size_t column = this->ColumnAt(surface.Column[voxel].X, surface.Column[voxel].Y);
    return std::abs(surface.RealZ[voxel] - this->Places[reflector][column]) <= this->Tolerance;
  }

  void CountHits(std::size_t number)
  {
    const LatticeHorizon& surface = this->Surfaces[number];
    SideCounts sides = { 0, 0 };
    for (std::size_t voxel = 0; voxel < surface.Column.size(); ++voxel)
    {
      const int i = surface.Column[voxel].X;
      const int j = surface.Column[voxel].Y;
      const double sample = surface.RealZ[voxel];
      const std::size_t side = this->SideOf(i, j, sample);
      constexpr double unclear = 1.5; // columns
      sides[side] += std::abs(this->Truth.FaultDistance(i, j, sample)) >= unclear ? 1 : 0;
      for (std::size_t reflector = 0; reflector < this->Places.size(); ++reflector)
      {
        this->Hits[number][reflector][side] += this->IsOn(reflector, surface, voxel) ? 1 : 0;
      }
    }
    constexpr std::size_t large = 200;
    if (this->HasFault && surface.Column.size() >= large)
    {
      this->Result.FaultPicks += sides[0] + sides[1];
      this->Result.LeakedPicks += std::min(sides[0], sides[1]);
    }
    this->Result.AllPicks += std::int64_t(surface.Column.size());
    this->Result.DroppedDuplicates += surface.DroppedDuplicates;
    this->Result.HomeSurfaces += this->HomeOf(number) != Nowhere ? 1 : 0;
  }

  int HomeOf(std::size_t surface) const
  {
    std::int64_t most = 0;
    int home = Nowhere;
    for (std::size_t reflector = 0; reflector < this->Places.size(); ++reflector)
    {
      const std::int64_t hits = this->Hits[surface][reflector][0] + this->Hits[surface][reflector][1];
      if (hits > most)
      {
        most = hits;
        home = int(reflector);
      }
    }
    return 2 * most > std::int64_t(this->Surfaces[surface].Column.size()) ? home : Nowhere;
  }

  void ScoreReflector(std::size_t reflector)
  {
    SideCounts places = { 0, 0 };
    for (int j = 0; j < this->Size[1]; ++j)
    {
      for (int i = 0; i < this->Size[0]; ++i)
      {
        const double place = this->Places[reflector][this->ColumnAt(i, j)];
        places[this->SideOf(i, j, place)] += place == place ? 1 : 0;
      }
    }
    std::int64_t found = 0;
    for (const std::size_t side : { 0, 1 })
    {
      found += this->TakeBest(reflector, side);
    }
    const std::int64_t all = places[0] + places[1];
    this->Result.TruePlaces += all;
    this->Result.FoundPlaces += found;
    if (all > 0)
    {
      this->Result.WeakestFound = std::min(this->Result.WeakestFound, double(found) / double(all));
    }
    if (this->HasChannel && int(reflector) == this->Truth.ChannelReflector(0))
    {
      this->CountChannel(reflector);
    }
  }

  /// Notes the best surface of one side of a reflector, and its errors, and gives how many places it found.
  std::int64_t TakeBest(std::size_t reflector, std::size_t side)
  {
    std::size_t best = 0;
    std::int64_t most = 0;
    for (std::size_t surface = 0; surface < this->Surfaces.size(); ++surface)
    {
      if (this->Hits[surface][reflector][side] > most)
      {
        most = this->Hits[surface][reflector][side];
        best = surface;
      }
    }
    if (most == 0)
    {
      return 0;
    }
    if (std::find(this->Best.begin(), this->Best.end(), best) == this->Best.end())
    {
      this->Best.push_back(best);
    }
    const LatticeHorizon& surface = this->Surfaces[best];
    for (std::size_t voxel = 0; voxel < surface.Column.size(); ++voxel)
    {
      const double place = this->Places[reflector][this->ColumnAt(surface.Column[voxel].X, surface.Column[voxel].Y)];
      if (this->IsOn(reflector, surface, voxel) &&
        this->SideOf(surface.Column[voxel].X, surface.Column[voxel].Y, surface.RealZ[voxel]) == side)
      {
        this->Result.Errors.push_back(float(std::abs(surface.RealZ[voxel] - place)));
      }
    }
    return most;
  }

  void CountWrong(std::size_t number)
  {
    const LatticeHorizon& surface = this->Surfaces[number];
    std::int64_t most = 0;
    for (const SideCounts& sides : this->Hits[number])
    {
      most = std::max(most, sides[0] + sides[1]);
    }
    this->Result.BestPicks += std::int64_t(surface.Column.size());
    this->Result.WrongPicks += std::int64_t(surface.Column.size()) - most;
  }

  void CountChannel(std::size_t reflector)
  {
    std::vector<char> isTaken(std::size_t(this->Size[0]) * std::size_t(this->Size[1]), 0);
    for (const std::size_t best : this->Best)
    {
      const LatticeHorizon& surface = this->Surfaces[best];
      for (std::size_t voxel = 0; this->HomeOf(best) == int(reflector) && voxel < surface.Column.size(); ++voxel)
      {
        isTaken[this->ColumnAt(surface.Column[voxel].X, surface.Column[voxel].Y)] = 1;
      }
    }
    for (int j = 0; j < this->Size[1]; ++j)
    {
      for (int i = 0; i < this->Size[0]; ++i)
      {
        const double bottom = this->Truth.ChannelPlace(0, i, j);
        const bool isChannel = bottom == bottom && !this->Truth.IsDead(i, j) && !this->Truth.IsMissing(i, j);
        this->Result.ChannelColumns += isChannel ? 1 : 0;
        this->Result.TakenColumns += isChannel && isTaken[this->ColumnAt(i, j)] ? 1 : 0;
      }
    }
  }

  const CubeReflectors& Truth;
  const std::array<int, 3> Size;
  const bool HasFault;
  const bool HasChannel;
  const double Tolerance;
  const std::vector<LatticeHorizon>& Surfaces;

  std::vector<std::vector<double>> Places; // by reflector, then by column
  std::vector<std::vector<SideCounts>> Hits; // by surface, then by reflector
  std::vector<std::size_t> Best; // surfaces
  ExtractionScore Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
void ExtractionScore::Add(const ExtractionScore& other)
{
  for (std::int64_t ExtractionScore::*count :
    { &ExtractionScore::TruePlaces, &ExtractionScore::FoundPlaces, &ExtractionScore::BestPicks,
      &ExtractionScore::WrongPicks, &ExtractionScore::FaultPicks, &ExtractionScore::LeakedPicks,
      &ExtractionScore::ChannelColumns, &ExtractionScore::TakenColumns, &ExtractionScore::HomeSurfaces,
      &ExtractionScore::Reflectors, &ExtractionScore::DroppedDuplicates, &ExtractionScore::AllPicks })
  {
    this->*count += other.*count;
  }
  this->WeakestFound = std::min(this->WeakestFound, other.WeakestFound);
  this->Errors.insert(this->Errors.end(), other.Errors.begin(), other.Errors.end());
}

//----------------------------------------------------------------------------------------------------------------------
double ExtractionScore::ErrorPercentile(double percentile) const
{
  if (this->Errors.empty())
  {
    return 0.0;
  }
  std::vector<float> sorted(this->Errors);
  const auto rank = std::min(sorted.size() - 1, std::size_t(percentile / 100.0 * double(sorted.size())));
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(rank), sorted.end());
  return sorted[rank];
}

//----------------------------------------------------------------------------------------------------------------------
ExtractionScore ScoreExtraction(const CubeGenerator& cube, const Extraction& extraction)
{
  return Scorer(cube, extraction).Score();
}
}
