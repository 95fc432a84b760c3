// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonPairs_h
#define SeismicHorizonsHorizonPairs_h

#include "HorizonTree.h"
#include "RankedHorizons.h"

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkTable;

namespace SeismicHorizons
{
class Ranks;

struct HorizonPair
{
  std::string Name; // empty if unnamed
  vtkSmartPointer<vtkPolyData> Reference;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> ReferenceOutput;
  vtkSmartPointer<vtkPolyData> MeshOutput;
  std::array<vtkSmartPointer<vtkTable>, 2> Rows; // rows of the pair for each table
};

/// A single horizon on either side makes a pair with any names. Otherwise names must agree, and equal names pair in
/// order. The rank of the reference works on a pair: it receives the mesh, and Deliver returns the output.
class HorizonPairs
{
public:
  /// Throws InputError if a horizon has no counterpart, and on other data than vtkPolyData. Collective. Refers to
  /// `ranks`.
  HorizonPairs(vtkDataObject* reference, vtkDataObject* mesh, vtkDataObject* referenceOutput, vtkDataObject* meshOutput,
    const Ranks& ranks);

  std::vector<HorizonPair>& OwnPairs() { return this->Own; }

  /// Sends outputs to the ranks of the meshes, and all rows, in the order of pairs, to the tables of the first rank.
  /// Collective.
  void Deliver(const std::array<vtkTable*, 2>& tables) const;

private:
  struct Match
  {
    RankedHorizon Reference;
    RankedHorizon Mesh;
  };

  void MatchNames(const std::vector<RankedHorizon>& references, std::vector<RankedHorizon> meshes);
  void Take(const Match& match, const std::vector<HorizonLeaf>& references, const std::vector<HorizonLeaf>& meshes);

  const Ranks& Group;
  std::vector<Match> Matches; // of all ranks
  std::vector<HorizonPair> Own; // in the order of Matches
  std::vector<vtkPolyData*> Away; // outputs of meshes on other ranks' pairs, in the order of Matches
};
}

#endif
