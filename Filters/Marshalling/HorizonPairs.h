// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which horizon of one dataset belongs to which of another, on all ranks of a program.

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

/// A horizon of the reference and of the mesh, with an empty output for each.
struct HorizonPair
{
  std::string Name; // empty when there is none
  vtkSmartPointer<vtkPolyData> Reference;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> ReferenceOutput;
  vtkSmartPointer<vtkPolyData> MeshOutput;
  std::array<vtkSmartPointer<vtkTable>, 2> Rows; // of the pair in each of the tables; empty
};

/// Pairs the horizons of two datasets, each a vtkPolyData or a composite of them, in the order of the reference. One
/// horizon on either side are a pair whatever they are called. Otherwise names have to agree: that of the block or of
/// the dataset above it, or "Horizon <SurfaceId>" where there is none; of equal names the first belong together, then
/// the second.
///
/// A pair is worked on by the rank of its reference. When its mesh is on another one, it is sent there, and what is
/// made of it is sent back.
class HorizonPairs
{
public:
  /// Gives each output the structure of its input. Throws InputError when a horizon has no counterpart, and on other
  /// data than vtkPolyData. Collective. Keeps the reference.
  HorizonPairs(vtkDataObject* reference, vtkDataObject* mesh, vtkDataObject* referenceOutput, vtkDataObject* meshOutput,
    const Ranks& ranks);

  /// The pairs that this rank works on.
  std::vector<HorizonPair>& OwnPairs() { return this->Own; }

  /// When all are done: sends the outputs of meshes to the ranks that have these, and the rows of all pairs to the
  /// tables on the first rank, in the order of pairs. Collective.
  void Deliver(const std::array<vtkTable*, 2>& tables) const;

private:
  /// A pair by the ranks of its two sides.
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
  std::vector<vtkPolyData*> Away; // the outputs of meshes that other ranks work on, in that order
};
}

#endif
