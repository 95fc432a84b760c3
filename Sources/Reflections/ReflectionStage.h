// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsReflectionStage_h
#define SeismicHorizonsReflectionStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/NamedHorizon.h"
#include "CubeGuides.h"
#include "Filters/Algorithms/Reflections/ReflectionExtraction.h"
#include "ImageCube.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct ReflectionInputs
{
  SeismicImage Image;
  std::optional<std::vector<NamedHorizon>> Guides; // as for ReadGuides
  std::optional<std::vector<NamedHorizon>> Limits; // as for ReadLimits
  LimitSide Side = LimitSide::Below;
};

struct FoundReflections
{
  ImageCube Cube;
  std::vector<GuidePicks> Guides;
  ExtractionLimits Limits;
  Extraction Result;
  std::vector<std::string> Names; // by surface
  std::string Description;
  std::vector<std::string> Warnings;
};

/// Throws InputError as MakeImageCube, ReadGuides, ReadLimits and ExtractReflections, which `kept` is for.
FoundReflections FindReflections(ReflectionInputs inputs, const ExtractionOptions& options, const Monitor& monitor,
  std::shared_ptr<JoinedReflections>* kept = nullptr);

/// Frees the surface. World z is of the nearest samples, unless `useRealZ`.
Horizon TakeSurface(FoundReflections& found, std::size_t number, bool useRealZ);
}

#endif
