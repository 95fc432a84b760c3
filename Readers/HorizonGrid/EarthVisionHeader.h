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
/// A value that each line has.
struct EarthVisionField
{
  std::string Name;
  std::size_t Index = 0; // among the values of a line
};

struct EarthVisionHeader
{
  SurveyDescription Survey;
  EarthVisionField X, Y, Z, Column, Row;
  std::array<int, 2> Columns = {}; // along i and j; 0 where the file does not say
  std::optional<double> Null; // stands for no value
};

/// Leaves the text at the first line of values.
EarthVisionHeader ReadEarthVisionHeader(GridText& text);
}

#endif
