// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RankedHorizons.h"

#include "Common/Base/Errors.h"
#include "Ranks.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
// Names cannot contain this character.
constexpr char Separator = '\0';

std::string Write(const std::vector<HorizonLeaf>& leaves)
{
  std::ostringstream text;
  for (const HorizonLeaf& leaf : leaves)
  {
    text << leaf.Position << ' ' << leaf.Input->GetNumberOfPoints() << ' ' << leaf.Name << Separator;
  }
  return text.str();
}

std::vector<RankedHorizon> Read(const std::vector<std::string>& texts)
{
  std::vector<RankedHorizon> horizons;
  for (std::size_t rank = 0; rank < texts.size(); ++rank)
  {
    std::istringstream text(texts[rank]);
    RankedHorizon horizon{ std::string(), 0, 0, int(rank), 0 };
    while (
      text >> horizon.Position >> horizon.Points && text.get() == ' ' && std::getline(text, horizon.Name, Separator))
    {
      horizons.push_back(horizon);
      ++horizon.Leaf;
    }
  }
  return horizons;
}

/// A horizon without points stays if no rank has points at its position.
void DropEmpty(std::vector<RankedHorizon>& horizons)
{
  std::set<int> filled;
  for (const RankedHorizon& horizon : horizons)
  {
    if (horizon.Points > 0)
    {
      filled.insert(horizon.Position);
    }
  }
  horizons.erase(std::remove_if(horizons.begin(), horizons.end(),
                   [&filled](const RankedHorizon& horizon)
                   { return horizon.Points == 0 && !filled.insert(horizon.Position).second; }),
    horizons.end());
}

void CheckNotSplit(const std::vector<RankedHorizon>& horizons, const Ranks& ranks)
{
  std::map<std::pair<int, std::string>, std::set<int>> ranksOf;
  for (const RankedHorizon& horizon : horizons)
  {
    ranksOf[{ horizon.Position, horizon.Name }].insert(horizon.Rank);
  }
  for (const auto& horizon : ranksOf)
  {
    const std::string& name = horizon.first.second;
    if (horizon.second.size() > 1)
    {
      ranks.Refuse((name.empty() ? "a horizon without a name" : name) + " has points on " +
        std::to_string(horizon.second.size()) + " of " + std::to_string(ranks.Size()) +
        " processes, expected each horizon on one process, as the reader distributes them");
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<RankedHorizon> ListOnRanks(const std::vector<HorizonLeaf>& leaves, const Ranks& ranks)
{
  std::vector<RankedHorizon> horizons = Read(ranks.Gather(Write(leaves)));
  if (ranks.Size() > 1)
  {
    DropEmpty(horizons);
    CheckNotSplit(horizons, ranks);
    std::stable_sort(horizons.begin(), horizons.end(),
      [](const RankedHorizon& a, const RankedHorizon& b) { return a.Position < b.Position; });
  }
  return horizons;
}
//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkPolyData>> ShareOnRanks(
  const std::vector<RankedHorizon>& shared, const std::vector<HorizonLeaf>& leaves, const Ranks& ranks)
{
  ranks.Together(
    [&]()
    {
      for (const RankedHorizon& horizon : shared) // Sending makes VTK read their arrays.
      {
        if (horizon.Rank == ranks.Own())
        {
          PrefixErrors(horizon.Name, [&]() { CheckArraySizes(leaves[horizon.Leaf].Input); });
        }
      }
    });
  std::vector<vtkSmartPointer<vtkPolyData>> all;
  for (const RankedHorizon& horizon : shared)
  {
    const bool isOwn = horizon.Rank == ranks.Own();
    all.push_back(isOwn ? leaves[horizon.Leaf].Input : vtkSmartPointer<vtkPolyData>::New());
    for (int rank = 0; isOwn && rank < ranks.Size(); ++rank)
    {
      if (rank != ranks.Own())
      {
        ranks.Send(all.back(), rank);
      }
    }
    if (!isOwn)
    {
      ranks.Receive(all.back(), horizon.Rank);
    }
  }
  return all;
}
}
