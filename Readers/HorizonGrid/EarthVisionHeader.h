// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsEarthVisionHeader_h
#define SeismicHorizonsEarthVisionHeader_h

#include "Common/Survey/SurveyDescription.h"
#include "GridText.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace SeismicHorizons
{
struct EarthVisionField
{
  std::string Name;
  std::size_t Index = 0;
};

struct EarthVisionHeader
{
  SurveyDescription Survey;
  EarthVisionField X, Y, Z, Column, Row;
  std::array<int, 2> Columns = {}; // Nodes along i and j; 0 if not stated.
  std::optional<double> Null;
};

EarthVisionHeader ReadEarthVisionHeader(GridText& text);
}

#endif
