// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which columns of the lattice a synthetic horizon has: inside an outline that is lobed and ragged, with two bays, but
// for holes, single missing voxels and gaps in patches of noise; and islands.

#ifndef SeismicHorizonsHorizonShape_h
#define SeismicHorizonsHorizonShape_h

#include "HorizonGeneratorOptions.h"
#include "NoisePatches.h"
#include "RandomFields.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class HorizonShape
{
public:
  /// For options that CheckOptions accepts, and the seed of one horizon. Throws InputError when the lattice has no room
  /// for all holes and islands.
  HorizonShape(const HorizonGeneratorOptions& options, std::uint64_t seed);

  std::uint64_t Seed() const { return this->HorizonSeed; }
  const NoisePatches& RoughPlaces() const { return this->Patches; }

  /// The columns i of row j that the horizon has, from the least.
  std::vector<int> FindRow(int j) const;

private:
  /// A round hole, or an island with the moat around it, before noise bends it. In cells.
  struct Feature
  {
    double I = 0.0;
    double J = 0.0;
    double Radius = 0.0;
    double Moat = 0.0; // how wide; 0 for a hole
  };

  void PlaceBays();
  void PlaceHoles(int first, int last);
  void PlaceIslands();
  bool PlaceFeature(Feature feature, std::uint64_t seed);
  bool IsApart(const Feature& feature) const;
  bool HasRoom(const Feature& feature, bool isInBody) const;
  static double Reach(const Feature& feature);

  /// Whether a place is inside the outline, holes and islands aside.
  bool IsInBody(double i, double j) const;
  bool IsOccupied(const std::vector<Feature>& features, int i, int j) const;
  bool IsDropout(int i, int j) const;

  HorizonGeneratorOptions Given;
  std::uint64_t HorizonSeed;
  NoisePatches Patches;
  int RaggedOctaves = 1;
  double DropoutThreshold;
  std::vector<Feature> Features; // islands first, since one may lie in a hole
  std::vector<FramePlace> Bays;
};
}

#endif
