// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GuideScore.h"

#include "Generator/SmoothNoise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t SmallestPart = 100;
constexpr int FromRim = 3;
constexpr int LineSpacing = 20;

class Truth
{
public:
  explicit Truth(const CubeGenerator& cube)
    : Cube(cube)
    , Width(cube.Options().Size[0])
    , Height(cube.Options().Size[1])
    , Period(1000.0 / (cube.Options().Frequency * cube.Options().SampleInterval))
  {
  }

  double Quarter() const { return this->Period / 4.0; }
  double HalfPeriod() const { return this->Period / 2.0; }
  int IOf(int column) const { return column % this->Width; }
  int JOf(int column) const { return column / this->Width; }
  int ColumnOf(const PlanePoint& point) const { return point.X + this->Width * point.Y; }

  double Place(int reflector, int column) const
  {
    const CubeReflectors& truth = this->Cube.Truth();
    const int i = this->IOf(column);
    const int j = this->JOf(column);
    return truth.IsDead(i, j) || truth.IsMissing(i, j) ? std::numeric_limits<double>::quiet_NaN()
                                                       : truth.Place(reflector, i, j);
  }

  std::vector<std::vector<int>> FindParts(int reflector) const
  {
    std::vector<double> places(std::size_t(this->Width * this->Height));
    for (std::size_t column = 0; column < places.size(); ++column)
    {
      places[column] = this->Place(reflector, int(column));
    }
    std::vector<std::vector<int>> parts;
    std::vector<bool> isSeen(places.size(), false);
    for (std::size_t first = 0; first < places.size(); ++first)
    {
      if (isSeen[first] || std::isnan(places[first]))
      {
        continue;
      }
      std::vector<int> part = { int(first) };
      isSeen[first] = true;
      for (std::size_t n = 0; n < part.size(); ++n)
      {
        const int column = part[n];
        this->ForEachNeighbour(column,
          [&](int next)
          {
            if (!isSeen[std::size_t(next)] &&
              std::abs(places[std::size_t(next)] - places[std::size_t(column)]) <= this->Quarter())
            {
              isSeen[std::size_t(next)] = true;
              part.push_back(next);
            }
          });
      }
      if (part.size() >= SmallestPart)
      {
        parts.push_back(std::move(part));
      }
    }
    return parts;
  }

  /// Those of a part with all columns around them in it.
  std::vector<int> Inside(const std::vector<int>& part) const
  {
    const std::set<int> columns(part.begin(), part.end());
    std::vector<int> inside;
    for (const int column : part)
    {
      bool isInside = true;
      for (int j = -FromRim; j <= FromRim; ++j)
      {
        for (int i = -FromRim; i <= FromRim; ++i)
        {
          const int x = this->IOf(column) + i;
          isInside = isInside && x >= 0 && x < this->Width && columns.count(column + i + this->Width * j) > 0;
        }
      }
      if (isInside)
      {
        inside.push_back(column);
      }
    }
    return inside;
  }

private:
  template <typename Visit>
  void ForEachNeighbour(int column, Visit&& visit) const
  {
    const int i = this->IOf(column);
    const int j = this->JOf(column);
    if (i > 0)
    {
      visit(column - 1);
    }
    if (i + 1 < this->Width)
    {
      visit(column + 1);
    }
    if (j > 0)
    {
      visit(column - this->Width);
    }
    if (j + 1 < this->Height)
    {
      visit(column + this->Width);
    }
  }

  const CubeGenerator& Cube;
  const int Width;
  const int Height;
  const double Period;
};

void AddPicks(const Truth& truth, int reflector, const LatticeHorizon& surface, GuideScore& score)
{
  for (std::size_t n = 0; n < surface.Column.size(); ++n)
  {
    const double distance = std::abs(surface.RealZ[n] - truth.Place(reflector, truth.ColumnOf(surface.Column[n])));
    score.AbsentPicks += std::isnan(distance) ? 1 : 0;
    score.PresentPicks += std::isnan(distance) ? 0 : 1;
    score.OffPicks += distance > truth.HalfPeriod() ? 1 : 0;
  }
}

void AddReflector(std::int64_t found, std::int64_t places, GuideScore& score)
{
  score.FoundPlaces += found;
  score.TruePlaces += places;
  score.Weakest = places > 0 ? std::min(score.Weakest, double(found) / double(places)) : score.Weakest;
}

/// For each part the columns of which a surface finds.
std::int64_t CountFound(const Truth& truth, int reflector, const std::vector<int>& part, const LatticeHorizon& surface)
{
  const std::set<int> columns(part.begin(), part.end());
  std::int64_t found = 0;
  for (std::size_t n = 0; n < surface.Column.size(); ++n)
  {
    const int column = truth.ColumnOf(surface.Column[n]);
    found += columns.count(column) > 0 && std::abs(surface.RealZ[n] - truth.Place(reflector, column)) <= truth.Quarter()
      ? 1
      : 0;
  }
  return found;
}
}

//----------------------------------------------------------------------------------------------------------------------
void GuideScore::Add(const GuideScore& other)
{
  this->TruePlaces += other.TruePlaces;
  this->FoundPlaces += other.FoundPlaces;
  this->PresentPicks += other.PresentPicks;
  this->OffPicks += other.OffPicks;
  this->AbsentPicks += other.AbsentPicks;
  this->Weakest = std::min(this->Weakest, other.Weakest);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<Guide> MakeGuides(const CubeGenerator& cube, const PickPlan& plan, std::uint64_t seed)
{
  const Truth truth(cube);
  std::vector<Guide> guides;
  std::int64_t draws = 0;
  const auto random = [&]() { return Random(Mix(seed), draws++, 0); };
  for (int reflector = 0; reflector < cube.Truth().Size(); ++reflector)
  {
    std::set<int> columns;
    for (const std::vector<int>& part : truth.FindParts(reflector))
    {
      const std::vector<int> inside = plan.PerPart > 0 ? truth.Inside(part) : part;
      for (int n = 0; n < plan.PerPart && !inside.empty(); ++n)
      {
        columns.insert(inside[std::size_t(random() * double(inside.size()))]);
      }
      for (const int column : inside)
      {
        if (plan.PerPart == 0 &&
          (truth.IOf(column) % LineSpacing == LineSpacing / 2 || truth.JOf(column) % LineSpacing == LineSpacing / 2))
        {
          columns.insert(column);
        }
      }
    }
    Guide guide;
    guide.Name = "Reflector " + std::to_string(reflector);
    for (const int column : columns)
    {
      const double below = reflector + 1 < cube.Truth().Size() ? truth.Place(reflector + 1, column)
                                                               : std::numeric_limits<double>::quiet_NaN();
      const bool isBad = random() < plan.BadShare && !std::isnan(below);
      const double place = (isBad ? below : truth.Place(reflector, column)) + plan.Deviation * (2.0 * random() - 1.0);
      guide.Picks.push_back(
        { truth.IOf(column), truth.JOf(column), std::clamp(place, 0.0, double(cube.Options().Size[2] - 1)) });
    }
    guides.push_back(std::move(guide));
  }
  return guides;
}

//----------------------------------------------------------------------------------------------------------------------
GuideScore ScoreGuided(const CubeGenerator& cube, const std::vector<LatticeHorizon>& surfaces)
{
  const Truth truth(cube);
  GuideScore score;
  for (std::size_t n = 0; n < surfaces.size(); ++n)
  {
    std::int64_t found = 0;
    std::int64_t places = 0;
    for (const std::vector<int>& part : truth.FindParts(int(n)))
    {
      found += CountFound(truth, int(n), part, surfaces[n]);
      places += std::int64_t(part.size());
    }
    AddPicks(truth, int(n), surfaces[n], score);
    AddReflector(found, places, score);
  }
  return score;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> MeasureMisses(const CubeGenerator& cube, int reflector, const LatticeHorizon& surface)
{
  const Truth truth(cube);
  std::vector<double> misses;
  for (std::size_t n = 0; n < surface.Column.size(); ++n)
  {
    const double place = truth.Place(reflector, truth.ColumnOf(surface.Column[n]));
    misses.push_back(std::isnan(place) ? std::numeric_limits<double>::infinity()
                                       : std::abs(surface.RealZ[n] - place) / truth.HalfPeriod());
  }
  return misses;
}

//----------------------------------------------------------------------------------------------------------------------
GuideScore ScoreUnguided(const CubeGenerator& cube, const std::vector<LatticeHorizon>& surfaces)
{
  const Truth truth(cube);
  GuideScore score;
  for (int reflector = 0; reflector < cube.Truth().Size(); ++reflector)
  {
    std::int64_t found = 0;
    std::int64_t places = 0;
    std::set<std::size_t> taken;
    for (const std::vector<int>& part : truth.FindParts(reflector))
    {
      std::int64_t most = 0;
      std::size_t best = 0;
      for (std::size_t n = 0; n < surfaces.size(); ++n)
      {
        const std::int64_t count =
          std::int64_t(surfaces[n].Column.size()) > most ? CountFound(truth, reflector, part, surfaces[n]) : 0;
        best = count > most ? n : best;
        most = std::max(most, count);
      }
      found += most;
      places += std::int64_t(part.size());
      if (most > 0 && taken.insert(best).second)
      {
        AddPicks(truth, reflector, surfaces[best], score);
      }
    }
    AddReflector(found, places, score);
  }
  return score;
}

//----------------------------------------------------------------------------------------------------------------------
int CountMain(const CubeGenerator& cube, const std::vector<LatticeHorizon>& surfaces, std::size_t first)
{
  const Truth truth(cube);
  const int reflectors = cube.Truth().Size();
  int count = 0;
  for (std::size_t n = 0; n < std::min(first, surfaces.size()); ++n)
  {
    const LatticeHorizon& surface = surfaces[n];
    const auto isOn = [&](int interface) // a reflector, or behind these the floor of a channel
    {
      std::size_t picks = 0;
      for (std::size_t pick = 0; pick < surface.Column.size(); ++pick)
      {
        const PlanePoint& column = surface.Column[pick];
        const double place = interface < reflectors
          ? truth.Place(interface, truth.ColumnOf(column))
          : cube.Truth().ChannelPlace(interface - reflectors, column.X, column.Y);
        picks += std::abs(surface.RealZ[pick] - place) <= truth.Quarter() ? 1 : 0;
      }
      return 2 * picks > surface.Column.size();
    };
    bool isMain = false;
    for (int interface = 0; interface < reflectors + cube.Options().Channels && !isMain; ++interface)
    {
      isMain = isOn(interface);
    }
    count += isMain ? 1 : 0;
  }
  return count;
}
}
