// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonPairs.h"

#include "Common/Base/Errors.h"
#include "Common/VTK/Ranks.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
std::string List(const std::vector<RankedHorizon>& horizons)
{
  std::string text;
  for (const RankedHorizon& horizon : horizons)
  {
    text += (text.empty() ? "" : ", ") + (horizon.Name.empty() ? "one without a name" : horizon.Name);
  }
  return text.empty() ? "no horizon" : text;
}

std::string Missing(
  const char* missing, const RankedHorizon& horizon, const char* side, const std::vector<RankedHorizon>& others)
{
  return std::string("no ") + missing + " for " + (horizon.Name.empty() ? "a horizon without a name" : horizon.Name) +
    " of the " + side + ", expected one of that name; there is " + List(others);
}

void AppendPairRows(vtkTable* rows, vtkTable* table)
{
  for (vtkIdType row = 0; row < rows->GetNumberOfRows(); ++row)
  {
    table->InsertNextRow(rows->GetRow(row));
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonPairs::HorizonPairs(vtkDataObject* reference, vtkDataObject* mesh, vtkDataObject* referenceOutput,
  vtkDataObject* meshOutput, const Ranks& ranks)
  : Group(ranks)
{
  std::vector<HorizonLeaf> references;
  std::vector<HorizonLeaf> meshes;
  ranks.Together(
    [&]()
    {
      references = ListHorizons(reference, { referenceOutput });
      meshes = ListHorizons(mesh, { meshOutput });
      for (std::size_t n = 0; ranks.Size() > 1 && n < meshes.size(); ++n) // Sending makes VTK read their arrays.
      {
        PrefixErrors(meshes[n].Name, [&]() { CheckArraySizes(meshes[n].Input); });
      }
    });
  this->MatchNames(ListOnRanks(references, ranks), ListOnRanks(meshes, ranks));
  for (const Match& match : this->Matches)
  {
    this->Take(match, references, meshes);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonPairs::MatchNames(const std::vector<RankedHorizon>& references, std::vector<RankedHorizon> meshes)
{
  const bool single = references.size() == 1 && meshes.size() == 1;
  const std::vector<RankedHorizon> all = meshes;
  for (const RankedHorizon& horizon : references)
  {
    const auto match = std::find_if(meshes.begin(), meshes.end(),
      [&](const RankedHorizon& other) { return single || (!horizon.Name.empty() && other.Name == horizon.Name); });
    if (match == meshes.end())
    {
      this->Group.Refuse(Missing("mesh", horizon, "reference", all));
    }
    this->Matches.push_back({ horizon, *match });
    meshes.erase(match);
  }
  if (!meshes.empty())
  {
    this->Group.Refuse(Missing("reference", meshes.front(), "mesh", references));
  }
}

//----------------------------------------------------------------------------------------------------------------------
// All ranks handle all pairs in the same order, so that each message finds its receiver waiting.
void HorizonPairs::Take(
  const Match& match, const std::vector<HorizonLeaf>& references, const std::vector<HorizonLeaf>& meshes)
{
  const int own = this->Group.Own();
  const bool hasMesh = match.Mesh.Rank == own;
  if (match.Reference.Rank == own)
  {
    const HorizonLeaf& reference = references[match.Reference.Leaf];
    HorizonPair pair{ reference.Name, reference.Input, nullptr, reference.Outputs.front(), nullptr,
      { vtkSmartPointer<vtkTable>::New(), vtkSmartPointer<vtkTable>::New() } };
    if (hasMesh)
    {
      pair.Mesh = meshes[match.Mesh.Leaf].Input;
      pair.MeshOutput = meshes[match.Mesh.Leaf].Outputs.front();
    }
    else
    {
      pair.Mesh = vtkSmartPointer<vtkPolyData>::New();
      pair.MeshOutput = vtkSmartPointer<vtkPolyData>::New();
      this->Group.Receive(pair.Mesh, match.Mesh.Rank);
    }
    this->Own.push_back(pair);
  }
  else if (hasMesh)
  {
    this->Group.Send(meshes[match.Mesh.Leaf].Input, match.Reference.Rank);
    this->Away.push_back(meshes[match.Mesh.Leaf].Outputs.front());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonPairs::Deliver(const std::array<vtkTable*, 2>& tables) const
{
  const int own = this->Group.Own();
  auto pair = this->Own.begin();
  auto away = this->Away.begin();
  for (const Match& match : this->Matches)
  {
    const int working = match.Reference.Rank;
    if (working == own)
    {
      if (match.Mesh.Rank != own)
      {
        this->Group.Send(pair->MeshOutput, match.Mesh.Rank);
      }
      for (std::size_t n = 0; n < tables.size(); ++n)
      {
        if (own == 0)
        {
          AppendPairRows(pair->Rows[n], tables[n]);
        }
        else
        {
          this->Group.Send(pair->Rows[n], 0);
        }
      }
      ++pair;
      continue;
    }
    if (match.Mesh.Rank == own)
    {
      this->Group.Receive(*away++, working);
    }
    for (std::size_t n = 0; own == 0 && n < tables.size(); ++n)
    {
      vtkNew<vtkTable> rows;
      this->Group.Receive(rows, working);
      AppendPairRows(rows, tables[n]);
    }
  }
}
}
