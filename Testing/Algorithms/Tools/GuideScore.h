// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Picks of an interpreter who knows the reflectors of a synthetic cube, and how good the surfaces are that follow them.
//
// The parts of a reflector are the connected columns where it is, by at most a quarter of a period from one to the next
// along i and j. Those of less than 100 columns do not count.

#ifndef SeismicHorizonsGuideScore_h
#define SeismicHorizonsGuideScore_h

#include "Filters/Algorithms/Reflections/ReflectionExtraction.h"
#include "Generator/CubeGenerator.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct PickPlan
{
  int PerPart = 5; // picks at random, 3 columns from the rim of the part or more; 0: all places of every 20th line
  double Deviation = 0.0; // of each pick, up or down, at most, in samples
  double BadShare = 0.0; // of the picks, on the next reflector below
};

/// A guide for each reflector, in their order. Reflectors without a part have one without picks.
std::vector<Guide> MakeGuides(const CubeGenerator& cube, const PickPlan& plan, std::uint64_t seed);

struct GuideScore
{
  std::int64_t TruePlaces = 0; // of all parts
  std::int64_t FoundPlaces = 0; // of them those within a quarter of a period
  std::int64_t PresentPicks = 0; // where the reflector is
  std::int64_t OffPicks = 0; // of them those more than half a period away
  std::int64_t AbsentPicks = 0; // where it is not
  double Weakest = 1.0; // the smallest share of a reflector's places that is found

  void Add(const GuideScore& other);
  double Found() const { return Share(this->FoundPlaces, this->TruePlaces); }
  double Off() const { return Share(this->OffPicks, this->PresentPicks); }
  double Absent() const { return Share(this->AbsentPicks, this->PresentPicks + this->AbsentPicks); }

private:
  static double Share(std::int64_t part, std::int64_t whole) { return whole > 0 ? double(part) / double(whole) : 0.0; }
};

/// Of the surface of each reflector, by its number.
GuideScore ScoreGuided(const CubeGenerator& cube, const std::vector<LatticeHorizon>& surfaces);

/// How far the picks of a surface are from the reflector, in half periods; infinite where it is not.
std::vector<double> MeasureMisses(const CubeGenerator& cube, int reflector, const LatticeHorizon& surface);

/// Of surfaces without guides: each part is given the surface that finds most of it.
GuideScore ScoreUnguided(const CubeGenerator& cube, const std::vector<LatticeHorizon>& surfaces);

/// How many of the first surfaces lie on a reflector, or on the floor of a channel, by more than half of their picks.
int CountMain(const CubeGenerator& cube, const std::vector<LatticeHorizon>& surfaces, std::size_t first);
}

#endif
