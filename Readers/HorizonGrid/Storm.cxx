// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Text/LineErrors.h"
#include "Common/Text/TextNumbers.h"
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

double ReadStormNumber(GridBytes& bytes, const std::string& name)
{
  char end = ' ';
  const std::string place = bytes.Place();
  return ReadHeaderNumber(ReadWord(bytes, name, end), name, place);
}

int ReadCount(GridBytes& bytes, const std::string& name)
{
  char end = ' ';
  const std::string place = bytes.Place();
  return ReadHeaderCount(ReadWord(bytes, name, end), name, place);
}

/// The binary values start after the line of the last number.
void ReadLastNumber(GridBytes& bytes, const std::string& name)
{
  char end = ' ';
  const std::string place = bytes.Place();
  ReadHeaderNumber(ReadWord(bytes, name, end), name, place);
  while (end != '\n')
  {
    bytes.Read(&end, 1, "the end of the line");
    if (!EndsToken(end))
    {
      throw bytes.Error(Quote(std::string(1, end)) + " after " + name + ", expected the end of the line");
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadStorm(GridBytes& bytes)
{
  HorizonGrid grid;
  char end = ' ';
  ReadWord(bytes, "STORMGRID_BINARY", end);
  const int nx = ReadCount(bytes, "nx");
  const int ny = ReadCount(bytes, "ny");
  const double dx = ReadStormNumber(bytes, "dx");
  const double dy = ReadStormNumber(bytes, "dy");
  const double x = ReadStormNumber(bytes, "xmin");
  ReadStormNumber(bytes, "xmax");
  const double y = ReadStormNumber(bytes, "ymin");
  ReadLastNumber(bytes, "ymax");
  grid.Lattice = PrefixErrors(bytes.Place(), [&] { return TurnedLattice({ nx, ny }, { x, y }, { dx, dy }, 0.0); });
  const std::int64_t count = CountNodes(grid.Lattice.Columns);
  grid.Z.reserve(bytes.Room(count, sizeof(double)));
  bytes.ReadValues<double>(count, IsStormNull, grid.Z);
  bytes.RequireEnd();
  return grid;
}
}
