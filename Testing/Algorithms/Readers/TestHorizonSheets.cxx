// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons that lie above themselves: which voxels are on which sheet.

#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"
#include "Tools/Check.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// A file of one horizon, 7, of width times length columns, with a voxel at each of ks(i, j).
template <typename Ks>
std::string Make(int width, int length, Ks&& ks)
{
  std::ostringstream text;
  text << width << ' ' << length << " 1000\n";
  for (int j = 0; j < length; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      for (const int k : ks(i, j))
      {
        text << k << " 7 1 " << k << ' ' << 4.0 * k << ' ';
      }
      text << '\n';
    }
  }
  return text.str();
}

/// All voxels are there once, no column of a sheet has two, and they are in their order.
std::vector<LatticeHorizon> Split(const std::string& text)
{
  std::istringstream stream(text);
  SparseMatrixOptions options;
  options.Policy = DuplicatePolicy::Sheets;
  std::vector<LatticeHorizon> sheets = ReadSparseMatrix(stream, options).Horizons;
  std::size_t total = 0;
  std::set<std::vector<int>> all;
  for (const LatticeHorizon& sheet : sheets)
  {
    CHECK_EQUAL(sheet.SurfaceId, 7);
    total += sheet.Column.size() + std::size_t(sheet.DroppedDuplicates);
    for (std::size_t n = 0; n < sheet.Column.size(); ++n)
    {
      CHECK(n == 0 ||
        std::make_pair(sheet.Column[n - 1].Y, sheet.Column[n - 1].X) <
          std::make_pair(sheet.Column[n].Y, sheet.Column[n].X));
      CHECK_EQUAL(sheet.RealZ[n], 4.0 * sheet.K[n]);
      all.insert({ sheet.Column[n].X, sheet.Column[n].Y, sheet.K[n] });
    }
  }
  CHECK_EQUAL(
    total, std::size_t(std::count(text.begin(), text.end(), ' ') - 2) / 5); // those of the header, and of voxels
  return sheets;
}

void SingleHorizonsStayWhole()
{
  const std::vector<LatticeHorizon> sheets =
    Split(Make(5, 4, [](int i, int j) { return std::vector<int>{ 9 * i + j }; }));
  CHECK_EQUAL(sheets.size(), 1U);
  CHECK_EQUAL(sheets.front().Column.size(), 20U);
  CHECK(Split(Make(2, 1, [](int, int) { return std::vector<int>(); })).empty());
}

void FaultsThatRunThroughGiveTwoBlocks()
{
  // The left block at 5 reaches over the right one at 15 for three columns. Voxels come in any order.
  const std::vector<LatticeHorizon> sheets = Split(Make(17, 10,
    [](int i, int) {
      return i < 7 ? std::vector<int>{ 5 } : i < 10 ? std::vector<int>{ 15, 5 } : std::vector<int>{ 15 };
    }));
  CHECK_EQUAL(sheets.size(), 2U);
  for (std::size_t n = 0; n < 100U; ++n)
  {
    CHECK_EQUAL(sheets[0].K[n], 5);
    CHECK_EQUAL(sheets[1].K[n], 15);
  }
}

void FaultsThatEndLeaveOneLayer()
{
  // Above itself in the rows 0 to 4 only: the layer above has more contacts, as it reaches one column further.
  const auto sheets = Split(Make(17, 10,
    [](int i, int j)
    {
      const int k = i < 8 ? 5 : 15;
      return j < 5 && i >= 6 && i < 10 ? std::vector<int>{ 5, 15 } : std::vector<int>{ j < 5 ? k : 10 };
    }));
  CHECK_EQUAL(sheets.size(), 2U);
  CHECK_EQUAL(sheets[0].Column.size(), 170U);
  CHECK_EQUAL(sheets[1].Column.size(), 20U);
  const int layer = sheets[1].K[0];
  for (std::size_t n = 0; n < sheets[1].Column.size(); ++n)
  {
    CHECK_EQUAL(sheets[1].K[n], layer); // one layer whole, and not parts of both
  }
}

void PartsThatAreApartShareASheet()
{
  const auto sheets = Split(Make(20, 3,
    [](int i, int) {
      return i == 4 || i == 12 ? std::vector<int>{ 9, 5 } : std::vector<int>{ 5 };
    }));
  CHECK_EQUAL(sheets.size(), 2U);
  CHECK_EQUAL(sheets[0].Column.size(), 60U);
  CHECK_EQUAL(sheets[1].Column.size(), 6U);
}

void DropsWhatTakesTooManySheets()
{
  std::vector<int> pile;
  for (int k = 0; k < 70; ++k)
  {
    pile.push_back(2 * k);
  }
  const auto sheets = Split(Make(1, 1, [&pile](int, int) { return pile; }));
  CHECK_EQUAL(sheets.size(), 64U);
  CHECK_EQUAL(sheets.front().DroppedDuplicates, 6);
}

void TheParserSplits()
{
  // Two columns with two voxels of horizon 3, and one with one.
  std::istringstream stream("3 1 20\n5 3 1 1 5 15 3 1 9 15\n5 3 1 1 5 15 3 1 9 15\n5 3 1 1 5\n");
  SparseMatrixOptions options;
  options.Policy = DuplicatePolicy::Sheets;
  const SparseMatrix matrix = ReadSparseMatrix(stream, options);
  CHECK_EQUAL(matrix.Horizons.size(), 2U);
  CHECK_EQUAL(matrix.Horizons[0].Column.size(), 3U);
  CHECK_EQUAL(matrix.Horizons[1].Column.size(), 2U);
  CHECK_EQUAL(matrix.Horizons[1].K[1], 15);
  CHECK_EQUAL(matrix.Horizons[1].DroppedDuplicates, 0);
  stream.clear();
  stream.seekg(0);
  options.SmallestSize = 3; // of each sheet
  CHECK_EQUAL(ReadSparseMatrix(stream, options).Horizons.size(), 1U);
}
}

int TestHorizonSheets(int, char*[])
{
  SingleHorizonsStayWhole();
  FaultsThatRunThroughGiveTwoBlocks();
  FaultsThatEndLeaveOneLayer();
  PartsThatAreApartShareASheet();
  DropsWhatTakesTooManySheets();
  TheParserSplits();
  return Check::Result();
}
