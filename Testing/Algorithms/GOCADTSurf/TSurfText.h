// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads TSurfs from text, with several sizes of buffer, which must not matter.

#ifndef SeismicHorizonsTSurfText_h
#define SeismicHorizonsTSurfText_h

#include "Readers/GOCADTSurf/TSurfParser.h"
#include "Tools/Check.h"

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace TSurfText
{
constexpr std::array<std::size_t, 5> BufferSizes = { 1, 2, 7, 64, 4096 };

inline std::vector<SeismicHorizons::TSurf> Load(const std::string& text, std::size_t bufferSize = 4096)
{
  std::istringstream stream(text);
  return SeismicHorizons::LoadTSurfs(
    stream, [](std::size_t) { return true; }, SeismicHorizons::Monitor(), bufferSize);
}

inline SeismicHorizons::TSurfList List(const std::string& text, std::size_t bufferSize = 4096)
{
  std::istringstream stream(text);
  return SeismicHorizons::ListTSurfs(stream, SeismicHorizons::Monitor(), bufferSize);
}

/// The only TSurf of a text.
inline SeismicHorizons::TSurf LoadOne(const std::string& text)
{
  std::vector<SeismicHorizons::TSurf> surfaces = Load(text);
  CHECK_EQUAL(surfaces.size(), 1u);
  return surfaces.empty() ? SeismicHorizons::TSurf() : surfaces.front();
}

inline void CheckRefused(const std::string& text, const std::string& message)
{
  for (const std::size_t bufferSize : BufferSizes)
  {
    CHECK_THROWS_WITH(Load(text, bufferSize), message);
  }
}
}

#endif
