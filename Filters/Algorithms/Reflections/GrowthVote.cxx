// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Columns of given picks are kept, and those where both candidates agree. The others form regions, connected along i
// and j, without jumps.
// 2. A region of two candidates takes the one that continues more given picks beside it, and else the one that resembles
// them more and continues into the columns kept. The seam counts less if the region is wide for it. Parts of automatic
// surfaces have an advantage, as long waveforms join them.
// 3. Regions are decided again, as decided neighbours say more than empty ones.
// 4. Regions of one candidate are kept if they continue columns kept, or given picks.

#include "GrowthVote.h"

#include "ReflectionLinks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace SeismicHorizons
{
namespace
{
// Weights beside that of the seam, which is from -2 to 2. They were fitted to regions of generated cubes.
constexpr double LikenessWeight = 2.5;
constexpr double ContrastWeight = 1.2;
constexpr double PartWeight = 1.0;
// A seam of this number of pairs per root of columns counts in full.
constexpr double SeamPerWidth = 6.0;
constexpr double SmallestContinuing = 0.5; // fraction of the pairs of a region of one candidate
constexpr int Decisions = 2;
constexpr int Sweeps = 3;

constexpr std::int32_t NoRegion = -1;

struct SeamCounts
{
  std::int64_t Continues = 0; // pairs within a quarter of the period
  std::int64_t Jumps = 0; // pairs more than half the period apart
  std::int64_t Pairs = 0;
};

class RegionVote
{
public:
  RegionVote(const ReflectionPicks& picks, const std::vector<Candidates>& columns, PickDepth quarter)
    : Picks(picks)
    , Columns(columns)
    , Quarter(quarter)
    , Sides(columns.size(), VoteSide::None)
    , Regions(columns.size(), NoRegion)
  {
  }

  std::vector<VoteSide> Run()
  {
    this->KeepAgreed();
    this->FindRegions();
    for (int n = 0; n < Decisions; ++n)
    {
      this->DecideConflicts();
    }
    for (int n = 0; n < Sweeps && this->KeepSingles(); ++n)
    {
    }
    return std::move(this->Sides);
  }

private:
  using Region = std::vector<std::int32_t>; // columns

  bool Has(std::int32_t column, int side) const { return this->Columns[column][side].Pick != NoPoint; }
  PickDepth PlaceOf(std::int32_t column, int side) const
  {
    return this->Picks.Places[this->Columns[column][side].Pick];
  }
  bool AreConflicting(std::int32_t column) const { return this->Has(column, 0) && this->Has(column, 1); }

  template <typename Visit>
  void ForEachBeside(std::int32_t column, Visit&& visit) const
  {
    ForEachNeighbour(this->Picks, column, ColumnConnectivity::Four, visit);
  }

  void KeepAgreed()
  {
    for (std::size_t column = 0; column < this->Columns.size(); ++column)
    {
      const auto n = std::int32_t(column);
      const auto& [parts, growth] = this->Columns[column];
      if (parts.IsGiven || growth.IsGiven)
      {
        this->Sides[column] = parts.IsGiven ? VoteSide::Parts : VoteSide::Growth;
      }
      else if (this->AreConflicting(n) && std::abs(this->PlaceOf(n, 0) - this->PlaceOf(n, 1)) <= this->Quarter)
      {
        this->Sides[column] = VoteSide::Parts;
      }
    }
  }

  /// The columns are neighbours. Regions have no jumps, and candidates keep their distance.
  bool AreOneRegion(std::int32_t a, std::int32_t b) const
  {
    for (const int side : { 0, 1 })
    {
      if (this->Has(a, side) != this->Has(b, side) ||
        (this->Has(a, side) && std::abs(this->PlaceOf(a, side) - this->PlaceOf(b, side)) > 2 * this->Quarter))
      {
        return false;
      }
    }
    const auto distance = [&](std::int32_t column) { return this->PlaceOf(column, 0) - this->PlaceOf(column, 1); };
    return !this->AreConflicting(a) || std::abs(distance(a) - distance(b)) <= this->Quarter;
  }

  void FindRegions()
  {
    for (std::size_t first = 0; first < this->Columns.size(); ++first)
    {
      const auto start = std::int32_t(first);
      if (!this->IsOpen(start) || this->Regions[first] != NoRegion)
      {
        continue;
      }
      const auto label = std::int32_t(this->Members.size());
      Region region = { start };
      this->Regions[first] = label;
      for (std::size_t n = 0; n < region.size(); ++n)
      {
        const std::int32_t column = region[n];
        this->ForEachBeside(column,
          [&](std::int64_t next)
          {
            if (this->Regions[next] == NoRegion && this->IsOpen(std::int32_t(next)) &&
              this->AreOneRegion(column, std::int32_t(next)))
            {
              this->Regions[next] = label;
              region.push_back(std::int32_t(next));
            }
          });
      }
      this->Members.push_back(std::move(region));
    }
  }

  bool IsOpen(std::int32_t column) const
  {
    return this->Sides[column] == VoteSide::None && (this->Has(column, 0) || this->Has(column, 1));
  }

  /// Pairs are those of the region, if it took the side, and columns kept.
  SeamCounts MeasureSeam(const Region& region, int side, const std::vector<VoteSide>& kept) const
  {
    SeamCounts seam;
    for (const std::int32_t column : region)
    {
      this->ForEachBeside(column,
        [&](std::int64_t next)
        {
          if (kept[next] != VoteSide::None && this->Regions[next] != this->Regions[column])
          {
            const PickDepth step =
              std::abs(this->PlaceOf(column, side) - this->PlaceOf(std::int32_t(next), int(kept[next])));
            ++seam.Pairs;
            seam.Continues += step <= this->Quarter ? 1 : 0;
            seam.Jumps += step > 2 * this->Quarter ? 1 : 0;
          }
        });
    }
    return seam;
  }

  void DecideConflicts()
  {
    const std::vector<VoteSide> kept = this->Sides;
    for (const Region& region : this->Members)
    {
      if (this->AreConflicting(region.front()))
      {
        const std::int64_t ahead = this->CountContinued(region, 0) - this->CountContinued(region, 1);
        const double lead = ahead != 0 ? double(ahead) : this->Lead(region, kept);
        const VoteSide side = lead > 0.0 ? VoteSide::Parts : VoteSide::Growth;
        for (const std::int32_t column : region)
        {
          this->Sides[column] = side;
        }
      }
    }
  }

  /// Counts pairs with given picks, other than strays, that the side continues.
  std::int64_t CountContinued(const Region& region, int side) const
  {
    std::int64_t continued = 0;
    for (const std::int32_t column : region)
    {
      this->ForEachBeside(column,
        [&](std::int64_t next)
        {
          const Candidate& given = this->Columns[next][0];
          const bool isNear =
            given.IsGiven && std::abs(this->PlaceOf(column, side) - this->Picks.Places[given.Pick]) <= this->Quarter;
          continued += isNear ? 1 : 0;
        });
    }
    return continued;
  }

  double MeanContrast(const Region& region, int side) const
  {
    double sum = 0.0;
    for (const std::int32_t column : region)
    {
      sum += double(this->Columns[column][side].Contrast);
    }
    return sum / double(region.size());
  }

  /// Positive values favour Parts.
  double Lead(const Region& region, const std::vector<VoteSide>& kept) const
  {
    double likeness = 0.0;
    double part = 0.0;
    for (const std::int32_t column : region)
    {
      const auto& [parts, growth] = this->Columns[column];
      likeness += double(parts.Likeness) - double(growth.Likeness);
      part += parts.IsPart ? 1.0 : 0.0;
    }
    const auto size = double(region.size());
    // Fading makes large contrasts, too.
    const double contrast = std::tanh(this->MeanContrast(region, 0) - this->MeanContrast(region, 1));
    double lead = (LikenessWeight * likeness + PartWeight * part) / size - ContrastWeight * contrast;
    const SeamCounts parts = this->MeasureSeam(region, 0, kept);
    const SeamCounts growth = this->MeasureSeam(region, 1, kept);
    const auto most = double(std::max(parts.Continues + parts.Jumps, growth.Continues + growth.Jumps));
    if (most > 0.0)
    {
      const auto ahead = double((parts.Continues - parts.Jumps) - (growth.Continues - growth.Jumps));
      lead += std::min(1.0, most / (SeamPerWidth * std::sqrt(size))) * ahead / most;
    }
    return lead;
  }

  /// Returns whether any region was kept.
  bool KeepSingles()
  {
    bool isAny = false;
    const std::vector<VoteSide> kept = this->Sides;
    for (const Region& region : this->Members)
    {
      const std::int32_t first = region.front();
      if (kept[first] != VoteSide::None)
      {
        continue;
      }
      const int side = this->Has(first, 0) ? 0 : 1;
      const SeamCounts seam = this->MeasureSeam(region, side, kept);
      const bool isContinuing = seam.Pairs > 0 && double(seam.Continues) >= SmallestContinuing * double(seam.Pairs);
      if (isContinuing || this->CountContinued(region, side) > 0)
      {
        isAny = true;
        for (const std::int32_t column : region)
        {
          this->Sides[column] = VoteSide(side);
        }
      }
    }
    return isAny;
  }

  const ReflectionPicks& Picks;
  const std::vector<Candidates>& Columns;
  const PickDepth Quarter;
  std::vector<VoteSide> Sides; // kept
  std::vector<std::int32_t> Regions; // by column
  std::vector<Region> Members; // by region
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<VoteSide> VoteByRegions(
  const ReflectionPicks& picks, const std::vector<Candidates>& columns, PickDepth quarter)
{
  return RegionVote(picks, columns, quarter).Run();
}
}
