// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPickPrinter_h
#define SeismicHorizonsPickPrinter_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

#include <ostream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Attributes of points that are where the traces of a single line are, off their lattice.
constexpr const char* LineX = "LineX";
constexpr const char* LineY = "LineY";

struct PrintedColumns
{
  bool HasNames = false;
  bool HasLines = false;
  std::vector<std::string> Attributes;
  SurveyDescription Survey; // The names say the units and direction of z.
};

/// OpendTect's single-line header has no name for the field of horizon names.
void PrintPickHeader(std::ostream& stream, const PrintedColumns& columns);

/// A line has, separated by tabs: the name in quotes, inline and crossline (both optional), x, y, z and attributes.
/// Null values are 1e30. Throws InputError for values that would be read as null.
void PrintPicks(std::ostream& stream, const HorizonColumns& horizon, const PrintedColumns& columns,
  const Monitor& monitor = Monitor());
}

#endif
