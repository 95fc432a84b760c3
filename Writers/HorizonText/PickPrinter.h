// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPickPrinter_h
#define SeismicHorizonsPickPrinter_h

#include "Common/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

#include <ostream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// What a file of picks has in its columns.
struct PrintedColumns
{
  bool HasNames = false; // of the horizons
  bool HasLines = false; // inline and crossline
  std::vector<std::string> Attributes;
};

/// Prints the names of the columns as OpendTect does: a single-line header, in which that of the horizons' names is
/// left out.
void PrintPickHeader(std::ostream& stream, const PrintedColumns& columns);

/// Prints a line for each column of the lattice that has a z: perhaps the name in quotes, inline and crossline, x, y, z
/// and the attributes, separated by tabs; 1e30 where there is no value. Throws InputError on a z or an attribute that
/// would be read as none.
void PrintPicks(std::ostream& stream, const HorizonColumns& horizon, const PrintedColumns& columns,
  const Monitor& monitor = Monitor());
}

#endif
