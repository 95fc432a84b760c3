// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonPairs.h"

#include "Common/Errors.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
std::string List(const std::vector<HorizonLeaf>& leaves)
{
  std::string text;
  for (const HorizonLeaf& leaf : leaves)
  {
    text += (text.empty() ? "" : ", ") + (leaf.Name.empty() ? "one without a name" : leaf.Name);
  }
  return text.empty() ? "no horizon" : text;
}

[[noreturn]] void RefuseMissing(
  const char* missing, const HorizonLeaf& leaf, const char* side, const std::vector<HorizonLeaf>& others)
{
  throw InputError(std::string("no ") + missing + " for " +
    (leaf.Name.empty() ? "a horizon without a name" : leaf.Name) + " of the " + side +
    ", expected one of that name; there is " + List(others));
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<HorizonPair> MatchHorizons(
  vtkDataObject* reference, vtkDataObject* mesh, vtkDataObject* referenceOutput, vtkDataObject* meshOutput)
{
  const std::vector<HorizonLeaf> references = ListHorizons(reference, { referenceOutput });
  std::vector<HorizonLeaf> meshes = ListHorizons(mesh, { meshOutput });
  const bool single = references.size() == 1 && meshes.size() == 1;
  const std::vector<HorizonLeaf> all = meshes;
  std::vector<HorizonPair> pairs;
  for (const HorizonLeaf& leaf : references)
  {
    const auto match = std::find_if(meshes.begin(), meshes.end(),
      [&](const HorizonLeaf& other) { return single || (!leaf.Name.empty() && other.Name == leaf.Name); });
    if (match == meshes.end())
    {
      RefuseMissing("mesh", leaf, "reference", all);
    }
    pairs.push_back({ leaf.Name, leaf.Input, match->Input, leaf.Outputs.front(), match->Outputs.front() });
    meshes.erase(match);
  }
  if (!meshes.empty())
  {
    RefuseMissing("reference", meshes.front(), "mesh", references);
  }
  return pairs;
}
}
