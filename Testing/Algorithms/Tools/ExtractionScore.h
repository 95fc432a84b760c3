// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How good surfaces are that were found in a synthetic cube, whose reflectors are known.

#ifndef SeismicHorizonsExtractionScore_h
#define SeismicHorizonsExtractionScore_h

#include "Filters/Algorithms/Reflections/ReflectionExtraction.h"
#include "Generator/CubeGenerator.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A surface is at home on the reflector that most of its picks lie on: a quarter of a period away at most, and in
/// columns where the reflector is. Of each reflector and each side of the fault, the surface with most picks there is
/// the best one.
struct ExtractionScore
{
  std::int64_t TruePlaces = 0; // columns of reflectors whose trace is not dead or missing
  std::int64_t FoundPlaces = 0; // of them those that the best surface has a pick at
  std::int64_t BestPicks = 0; // picks of the best surfaces
  std::int64_t WrongPicks = 0; // of them those off the reflector of their surface
  std::int64_t FaultPicks = 0; // picks of surfaces of 200 or more that are 1.5 columns from the fault or more
  std::int64_t LeakedPicks = 0; // of them those on the side of the fault where their surface has fewer
  std::int64_t ChannelColumns = 0; // where the channel cut its reflector away
  std::int64_t TakenColumns = 0; // of them those in which a best surface of that reflector has a pick
  std::int64_t HomeSurfaces = 0; // at home on a reflector
  std::int64_t Reflectors = 0;
  std::int64_t DroppedDuplicates = 0;
  std::int64_t AllPicks = 0;
  double WeakestFound = 1.0; // the smallest share of a reflector's places that is found
  std::vector<float> Errors; // of the places found, in samples

  void Add(const ExtractionScore& other);

  double Found() const { return Share(this->FoundPlaces, this->TruePlaces); }
  double Wrong() const { return Share(this->WrongPicks, this->BestPicks); }
  double Leaked() const { return Share(this->LeakedPicks, this->FaultPicks); }
  double Taken() const { return Share(this->TakenColumns, this->ChannelColumns); }
  double Duplicates() const { return Share(this->DroppedDuplicates, this->AllPicks + this->DroppedDuplicates); }
  double PerReflector() const { return Share(this->HomeSurfaces, this->Reflectors); }
  /// The error that a part of the places found is below.
  double ErrorPercentile(double percentile) const;

private:
  static double Share(std::int64_t part, std::int64_t whole) { return whole > 0 ? double(part) / double(whole) : 0.0; }
};

ExtractionScore ScoreExtraction(const CubeGenerator& cube, const Extraction& extraction);
}

#endif
