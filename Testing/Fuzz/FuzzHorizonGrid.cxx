// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An input is a grid file of any format. It is read in buffers of several sizes, which must not matter, and what was
// read is written and read again.

#include "Require.h"

#include "Readers/HorizonGrid/GridReader.h"
#include "Writers/HorizonGrid/GridWriters.h"

#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

using namespace Fuzz;
using namespace SeismicHorizons;

namespace
{
/// What came of a file: an error, or what is in it.
struct Outcome
{
  std::string Error;
  HorizonGrid Grid;
};

Outcome Read(const std::string& file, std::size_t bufferSize)
{
  Outcome outcome;
  try
  {
    std::istringstream stream(file);
    outcome.Grid = ReadHorizonGrid(stream, Monitor(), bufferSize);
  }
  catch (const InputError& error)
  {
    outcome.Error = error.what();
  }
  return outcome;
}

bool IsSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

bool IsSame(const Outcome& a, const Outcome& b)
{
  return a.Error == b.Error && a.Grid.Name == b.Grid.Name && a.Grid.Lattice.Columns == b.Grid.Lattice.Columns &&
    a.Grid.Lattice.Origin == b.Grid.Lattice.Origin && a.Grid.Lattice.ColumnStep == b.Grid.Lattice.ColumnStep &&
    a.Grid.Lattice.RowStep == b.Grid.Lattice.RowStep && IsSame(a.Grid.Z, b.Grid.Z);
}

void CheckGrid(const HorizonGrid& grid)
{
  const SurveyLattice& lattice = grid.Lattice;
  Require(lattice.Columns[0] > 0 && lattice.Columns[1] > 0, "no columns");
  Require(std::int64_t(grid.Z.size()) == std::int64_t(lattice.Columns[0]) * lattice.Columns[1], "number of values");
  Require(lattice.Origin.allFinite() && lattice.ColumnStep.allFinite() && lattice.RowStep.allFinite(),
    "a lattice that is not finite");
  for (const double z : grid.Z)
  {
    Require(!std::isinf(z), "an infinite value");
  }
}

/// A grid that the format can hold keeps its values.
template <typename Write>
void CheckWriter(const HorizonGrid& grid, bool keepsOrder, Write&& write)
{
  std::ostringstream file;
  try
  {
    write(file, grid, Monitor());
  }
  catch (const InputError&)
  {
    return;
  }
  const Outcome again = Read(file.str(), 4096);
  const bool losesDigits = again.Error.find(" to rise") != std::string::npos ||
    again.Error.find("at finite places") != std::string::npos; // steps that their coordinates cannot tell
  Require(again.Error.empty() || losesDigits, "what was written is refused: " + again.Error);
  Require(losesDigits || again.Grid.Z.size() == grid.Z.size(), "what was written has another size");
  Require(losesDigits || !keepsOrder || IsSame(again.Grid.Z, grid.Z), "what was written has other values");
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string file(reinterpret_cast<const char*>(data), size);
  const Outcome whole = Read(file, size + 1);
  Require(whole.Error.empty() || whole.Error.find("expected ") != std::string::npos,
    "an error without what was expected: " + whole.Error);
  for (const std::size_t bufferSize : { std::size_t(1), 2 + size % 61 })
  {
    Require(IsSame(Read(file, bufferSize), whole), "the size of the buffer matters");
  }
  if (whole.Error.empty())
  {
    CheckGrid(whole.Grid);
    CheckWriter(whole.Grid, true, WriteIrapText);
    CheckWriter(whole.Grid, false, WriteZmap);
  }
  return 0;
}
