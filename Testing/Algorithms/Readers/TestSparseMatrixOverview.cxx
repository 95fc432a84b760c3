// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a file has without its voxels, and rows of it read with that: the same as of the whole file, whatever the
// buffer.

#include "Readers/VerneySparseMatrix/SparseMatrixOverview.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr std::array<std::size_t, 4> BufferSizes = { 3, 64, 1000, SparseMatrixBufferSize };

/// Up to three horizons in 9 x 14 columns, with empty rows, duplicates, and lines that end as they like.
std::string MakeFile(Patches::Random& random)
{
  std::ostringstream text;
  text << "9 14 40\n";
  const int emptyFrom = random.Below(14);
  for (int column = 0; column < 9 * 14; ++column)
  {
    const int row = column / 9;
    const bool isEmpty = row >= emptyFrom && row < emptyFrom + 4;
    for (int n = 0; n < 4 && !isEmpty; ++n)
    {
      if (random.Chance(0.4))
      {
        text << 10 * n + random.Below(9) << ' ' << (n == 3 ? 8 : 5 * n - 2) << " 1.5 " << random.Below(90) << ' '
             << 0.25 * random.Below(4000) << ' ';
      }
    }
    text << (random.Chance(0.2) ? "\r\n" : "\n");
  }
  return text.str();
}

std::string Tell(const SparseMatrix& matrix)
{
  std::ostringstream text;
  text.precision(17);
  for (const LatticeHorizon& horizon : matrix.Horizons)
  {
    text << "horizon " << horizon.SurfaceId << ", " << horizon.DroppedDuplicates << " dropped\n";
    for (std::size_t n = 0; n < horizon.Column.size(); ++n)
    {
      text << horizon.Column[n].X << ' ' << horizon.Column[n].Y << ' ' << horizon.K[n] << ' ' << horizon.Thickness[n]
           << ' ' << horizon.Amplitude[n] << ' ' << horizon.RealZ[n] << '\n';
    }
  }
  return text.str();
}

SparseMatrixOverview MakeOverview(const std::string& file, const SparseMatrixOptions& options, std::size_t bufferSize)
{
  std::istringstream stream(file);
  return ReadSparseMatrixOverview(stream, options, Monitor(), bufferSize);
}

void TestRows()
{
  Patches::Random random(3);
  for (int n = 0; n < 200; ++n)
  {
    const std::string file = MakeFile(random);
    SparseMatrixOptions options;
    options.Policy = DuplicatePolicy(n % 3);
    const int first = random.Below(14);
    options.RowRange = { first, n % 5 == 0 ? std::numeric_limits<int>::max() : first + random.Below(16) };
    options.ColumnRange = { random.Below(4), n % 4 == 0 ? std::numeric_limits<int>::max() : 4 + random.Below(6) };
    options.SmallestSize = 1 + random.Below(20);
    if (n % 3 == 0)
    {
      options.Surfaces = { 3, 8 };
    }
    std::istringstream whole(file);
    const std::string expected = Tell(ReadSparseMatrix(whole, options));
    for (const std::size_t bufferSize : BufferSizes)
    {
      const SparseMatrixOverview overview = MakeOverview(file, options, bufferSize);
      std::istringstream stream(file);
      const SparseMatrix rows = ReadSparseMatrixRows(stream, overview, options, Monitor(), bufferSize);
      CHECK_EQUAL(Tell(rows), expected);
      CHECK(rows.Size == overview.Size && rows.VerticalFit.Step == overview.VerticalFit.Step);
    }
  }
}

void TestCounts()
{
  Patches::Random random(4);
  for (int n = 0; n < 50; ++n)
  {
    const std::string file = MakeFile(random);
    const SparseMatrixOverview overview = MakeOverview(file, {}, 64);
    std::istringstream whole(file);
    const SparseMatrix matrix = ReadSparseMatrix(whole);
    CHECK_EQUAL(overview.Horizons.size(), matrix.Horizons.size());
    for (const LatticeHorizon& voxels : matrix.Horizons)
    {
      const HorizonOverview& horizon = overview.Horizons.at(voxels.SurfaceId);
      for (int first = -1; first < 16; ++first)
      {
        for (int last = first - 1; last < 16; ++last)
        {
          const auto count = std::count_if(voxels.Column.begin(), voxels.Column.end(),
            [=](const PlanePoint& column) { return column.Y >= first && column.Y <= last; });
          CHECK_EQUAL(horizon.CountVoxels(first, last), std::int64_t(count));
        }
      }
      CHECK_EQUAL(horizon.CountVoxels(0, std::numeric_limits<int>::max() - 1), std::int64_t(voxels.Column.size()));
    }
    // To the bit, and the same for some rows as for all.
    SparseMatrixOptions rows;
    rows.RowRange = { 3, 5 };
    CHECK_EQUAL(overview.VerticalFit.Offset, matrix.VerticalFit.Offset);
    CHECK_EQUAL(overview.VerticalFit.Step, matrix.VerticalFit.Step);
    CHECK_EQUAL(MakeOverview(file, rows, 1000).VerticalFit.Step, matrix.VerticalFit.Step);
  }
}

/// No more of a file is read than the rows, and what is buffered: an error behind them is not met.
void TestNotRead()
{
  std::string file = "1 1000 9\n";
  std::string broken = file;
  for (int row = 0; row < 1000; ++row)
  {
    file += "3 1 1 1 1\n";
    broken += row < 20 || row > 900 ? "x 1 1 1 1\n" : "3 1 1 1 1\n";
  }
  const SparseMatrixOverview overview = MakeOverview(file, {}, 64);
  CHECK(overview.Lines.size() > 100);
  SparseMatrixOptions options;
  options.RowRange = { 100, 800 };
  std::istringstream stream(broken);
  CHECK_EQUAL(ReadSparseMatrixRows(stream, overview, options, Monitor(), 64).Horizons.at(0).Column.size(), 701u);
  options.RowRange = { 100, 999 };
  std::istringstream again(broken);
  CHECK_THROWS_WITH(ReadSparseMatrixRows(again, overview, options, Monitor(), 64), "line 903: vertical index \"x\"");
}

void TestErrors()
{
  CHECK_THROWS_WITH(
    MakeOverview("2 2 9\n1 1 1 1 1\n2 1 1 1 1", {}, 64), "line 3: end of file after 2 columns, expected 4");
  CHECK_THROWS_WITH(MakeOverview("2 2 9\n\n1 1 1 1\n", {}, 64), "line 3: 4 values, expected a multiple of 5");
  CHECK_THROWS_WITH(MakeOverview("2 2\n", {}, 64), "line 1: header");
  CHECK_EQUAL(MakeOverview("2 1 9\n\n\n", {}, 64).Horizons.size(), 0u);
  CHECK_EQUAL(MakeOverview("2 1 9\n\n\n", {}, 64).VerticalFit.Step, 0.0);
}

void TestMonitor()
{
  std::string file = "1 1000 9\n";
  for (int row = 0; row < 1000; ++row)
  {
    file += "3 1 1 1 1\n";
  }
  CHECK_EQUAL(MonitorChecker::Check(10,
                [&](const Monitor& monitor)
                {
                  std::istringstream stream(file);
                  ReadSparseMatrixOverview(stream, {}, monitor, 64);
                }),
    std::string());
}
}

int TestSparseMatrixOverview(int, char*[])
{
  TestRows();
  TestCounts();
  TestNotRead();
  TestErrors();
  TestMonitor();
  return Check::Result();
}
