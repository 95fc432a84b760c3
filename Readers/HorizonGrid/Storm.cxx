// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Text/LineErrors.h"
#include "Common/Text/TextNumbers.h"
#include "GridBytes.h"
#include "GridParsers.h"
#include "HeaderFields.h"

namespace SeismicHorizons
{
namespace
{
constexpr NullRule IsStormNull = { -999.0 };
constexpr std::size_t LongestWord = 64; // The longest number has 24 characters.

/// Reads a single character after the word, because values may follow.
std::string ReadWord(GridBytes& bytes, const std::string& name, char& end)
{
  std::string word;
  for (end = '\n'; word.empty() || !EndsToken(end);)
  {
    bytes.Read(&end, 1, name);
    if (!EndsToken(end))
    {
      word += end;
    }
    if (word.size() > LongestWord)
    {
      throw bytes.Error(name + ' ' + Quote(word) + ", expected a shorter word");
    }
  }
  return word;
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadStorm(GridBytes& bytes)
{
  HorizonGrid grid;
  char end = ' ';
  const auto count = [&](const char* name)
  {
    const std::string place = bytes.Place();
    return ReadHeaderCount(ReadWord(bytes, name, end), name, place);
  };
  const auto number = [&](const char* name)
  {
    const std::string place = bytes.Place();
    return ReadHeaderNumber(ReadWord(bytes, name, end), name, place);
  };
  ReadWord(bytes, "STORMGRID_BINARY", end);
  const int nx = count("nx");
  const int ny = count("ny");
  const double dx = number("dx");
  const double dy = number("dy");
  const double x = number("xmin");
  number("xmax");
  const double y = number("ymin");
  number("ymax");
  while (end != '\n') // The binary values start after the line of the last number.
  {
    bytes.Read(&end, 1, "the end of the line");
    if (!EndsToken(end))
    {
      throw bytes.Error(Quote(std::string(1, end)) + " after ymax, expected the end of the line");
    }
  }
  grid.Lattice = PrefixErrors(bytes.Place(), [&] { return TurnedLattice({ nx, ny }, { x, y }, { dx, dy }, 0.0); });
  grid.Z = bytes.Values<double>(CountNodes(grid.Lattice.Columns), IsStormNull);
  bytes.RequireEnd();
  return grid;
}
}
