// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parser of sparse-matrix files: what it reads, which voxels of a column it keeps, and its progress.

#include "ParserFixtures.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

#include <cstdint>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace ParserFixtures;

namespace
{
// ---- What is read ------------------------------------------------------------------------------------------------
/// Voxels by surface ID, duplicates included.
using Counts = std::map<int, std::int64_t>;

Counts Count(const SparseMatrix& matrix)
{
  Counts counts;
  for (const LatticeHorizon& horizon : matrix.Horizons)
  {
    counts[horizon.SurfaceId] = static_cast<std::int64_t>(horizon.Column.size()) + horizon.DroppedDuplicates;
  }
  return counts;
}

void VoxelsAreCounted()
{
  for (const std::size_t bufferSize : BufferSizes)
  {
    const SparseMatrix matrix = Load(Small, DuplicatePolicy::Topmost, bufferSize);
    CHECK((matrix.Size == SparseMatrixSize{ 3, 2, 10 }));
    CHECK((Count(matrix) == Counts{ { -7, 2 }, { 4, 3 } }));
  }
}

void DefaultBufferSizeWorks()
{
  std::istringstream stream(Small);
  CHECK_EQUAL(ReadSparseMatrix(stream).Horizons.size(), 2u);
}

void LoadGivesAllAttributes()
{
  for (const std::size_t bufferSize : BufferSizes)
  {
    const SparseMatrix matrix = Load(Small, DuplicatePolicy::Topmost, bufferSize);
    CHECK((matrix.Size == SparseMatrixSize{ 3, 2, 10 }));
    CHECK_EQUAL(matrix.Horizons.size(), 2u);
    const LatticeHorizon& horizon = matrix.Horizons.at(1);
    CHECK_EQUAL(horizon.SurfaceId, 4);
    CHECK((horizon.Column == std::vector<PlanePoint>{ { 0, 0 }, { 1, 0 }, { 2, 1 } }));
    CHECK((horizon.K == std::vector<int>{ 5, 6, 0 }));
    CHECK((horizon.Thickness == std::vector<double>{ 1.5, 2.0, 1.0 }));
    CHECK((horizon.Amplitude == std::vector<double>{ -20.0, -0.5, 3.0 }));
    CHECK((horizon.RealZ == std::vector<double>{ 21.25, 24.0, 0.125 }));
    CHECK_EQUAL(horizon.DroppedDuplicates, 0);
  }
}

void HorizonsComeByAscendingId()
{
  const SparseMatrix matrix = Load(Small);
  CHECK_EQUAL(matrix.Horizons.size(), 2u);
  CHECK_EQUAL(matrix.Horizons.at(0).SurfaceId, -7);
  CHECK_EQUAL(matrix.Horizons.at(0).Column.size(), 2u);
  CHECK_EQUAL(matrix.Horizons.at(1).SurfaceId, 4);
}

/// What lies outside is checked all the same.
void RangesAndSizesAreLeftOut()
{
  const auto load = [](const SparseMatrixOptions& options, const std::string& text)
  {
    std::istringstream stream(text);
    return Count(ReadSparseMatrix(stream, options));
  };
  const std::string text = "3 2 9\n1 1 0 0 0\n1 1 0 0 0 2 2 0 0 0\n2 2 0 0 0\n\n1 1 0 0 0\n3 2 0 0 0\n";
  SparseMatrixOptions options;
  options.ColumnRange = { 1, 1 };
  CHECK((load(options, text) == Counts{ { 1, 2 }, { 2, 1 } }));
  options.RowRange = { 0, 0 };
  CHECK((load(options, text) == Counts{ { 1, 1 }, { 2, 1 } }));
  options = SparseMatrixOptions();
  options.RowRange = { 1, 9 };
  options.SmallestSize = 2;
  CHECK(load(options, text).empty());
  options = SparseMatrixOptions();
  options.SmallestSize = 3;
  CHECK((load(options, text) == Counts{ { 1, 3 }, { 2, 3 } }));
  options.ColumnRange = { 0, 1 };
  CHECK((load(options, text) == Counts{ { 1, 3 } }));
  CHECK_THROWS_WITH(load(options, text + "x\n"), "line 8: ");
}

void LayoutIsFree()
{
  const Counts one = { { 1, 1 } };
  CHECK((Count(Load("\xEF\xBB\xBF"
                    "1 1 5\n0 1 0 0 0\n")) == one));
  CHECK((Count(Load("1 1 5\r\n0 1 0 0 0\r\n")) == one));
  CHECK((Count(Load("\t1  +1 \t5 \n \t0\t1   0 0 0\t \n")) == one));
  CHECK((Count(Load("1 1 5\n0 1 0 0 0")) == one));
  CHECK((Count(Load("1 1 5\n0 1 0 0 0\n\n \t\r\n\n")) == one));
  CHECK((Count(Load("1 1 5\n4.0 +1.0 0 0 0\n")) == one));
  CHECK((Count(Load("1 1 5\n0 1e0 0 0 0\n")) == one));
}

void EmptyLastColumnNeedsNoNewline()
{
  CHECK((Count(Load("2 1 5\n0 1 0 0 0\n")) == Counts{ { 1, 1 } }));
  CHECK(Load("1 1 5\n").Horizons.empty());
}

/// The real z of the only voxel of a file, after it went through the parser as `number`.
double ReadNumber(const std::string& number)
{
  return Load("1 1 1\n0 1 0 0 " + number + "\n").Horizons.at(0).RealZ.front();
}

void NumbersAreRoundedCorrectly()
{
  CHECK_EQUAL(ReadNumber("1033.46144"), 1033.46144);
  CHECK_EQUAL(ReadNumber("-0.1"), -0.1);
  CHECK_EQUAL(ReadNumber("+.5"), 0.5);
  CHECK_EQUAL(ReadNumber("5."), 5.0);
  CHECK_EQUAL(ReadNumber("+1.5e-3"), 1.5e-3);
  CHECK_EQUAL(ReadNumber("9007199254740993"), 9007199254740992.0);
  CHECK_EQUAL(ReadNumber("0.9007199254740993"), 0.9007199254740993);
  CHECK_EQUAL(ReadNumber("3.141592653589793238462643383279"), 3.141592653589793);
  CHECK_EQUAL(ReadNumber("123456789012345678901234567890"), 123456789012345678901234567890.0);
  CHECK_EQUAL(ReadNumber("00000000000000000000000000000001.25"), 1.25);
  CHECK_EQUAL(ReadNumber("1.7976931348623157e308"), std::numeric_limits<double>::max());
  CHECK_EQUAL(ReadNumber("5e-324"), std::numeric_limits<double>::denorm_min());
}

void NumbersTooSmallAreZero()
{
  CHECK_EQUAL(ReadNumber("1e-400"), 0.0);
  CHECK_EQUAL(ReadNumber("-1e-400"), 0.0);
  CHECK_EQUAL(ReadNumber("0." + std::string(400, '0') + "1"), 0.0);
  CHECK_EQUAL(ReadNumber("0." + std::string(400, '0') + "1e+5"), 0.0);
  CHECK_EQUAL(ReadNumber("-0." + std::string(400, '0') + "1e5"), 0.0);
  CHECK_EQUAL(ReadNumber("1e-99999999999999999999"), 0.0);
  CHECK_EQUAL(ReadNumber("0e99999999999999999999"), 0.0);
}

/// Many zeros and an exponent that takes them back.
void DigitsAndExponentMakeUpForEachOther()
{
  CHECK_EQUAL(ReadNumber("1" + std::string(400, '0') + "e-400"), 1.0);
  CHECK_EQUAL(ReadNumber("0." + std::string(400, '0') + "1e+401"), 1.0);
}

// ---- Duplicates --------------------------------------------------------------------------------------------------
int KeptIndex(const std::string& column, DuplicatePolicy policy, int expectedDropped)
{
  const SparseMatrix matrix = Load("1 1 10\n" + column + "\n", policy);
  CHECK_EQUAL(matrix.Horizons.at(0).DroppedDuplicates, expectedDropped);
  CHECK_EQUAL(matrix.Horizons.at(0).Column.size(), 1u);
  CHECK_EQUAL(matrix.Horizons.at(0).RealZ.front(), 4.0 * matrix.Horizons.at(0).K.front());
  return matrix.Horizons.at(0).K.front();
}

void PolicyChoosesAmongDuplicates()
{
  const std::string column = "5 1 0 -9 20 2 1 0 3 8 8 2 0 99 32 7 1 0 8 28";
  CHECK_EQUAL(KeptIndex(column, DuplicatePolicy::StrongestAmplitude, 2), 5);
  CHECK_EQUAL(KeptIndex(column, DuplicatePolicy::Topmost, 2), 2);
  CHECK_EQUAL(KeptIndex(column, DuplicatePolicy::Lowest, 2), 7);
}

void EquallyStrongDuplicatesKeepTheTopmost()
{
  CHECK_EQUAL(KeptIndex("5 1 0 -9 20 2 1 0 9 8", DuplicatePolicy::StrongestAmplitude, 1), 2);
  CHECK_EQUAL(KeptIndex("2 1 0 9 8 5 1 0 -9 20", DuplicatePolicy::StrongestAmplitude, 1), 2);
}

void NeighbouringColumnsAreNoDuplicates()
{
  const SparseMatrix matrix = Load("2 2 5\n1 1 0 0 0\n1 1 0 0 0\n1 1 0 0 0\n1 1 0 0 0\n");
  CHECK_EQUAL(matrix.Horizons.at(0).Column.size(), 4u);
  CHECK_EQUAL(matrix.Horizons.at(0).DroppedDuplicates, 0);
}

void ManySurfacesAreToldApart()
{
  std::string column;
  for (int k = 0; k < 1000; ++k)
  {
    column += std::to_string(k) + ' ' + std::to_string(64 * (k - 500)) + " 1 1 1 ";
  }
  const Counts counts = Count(Load("2 1 1000\n" + column + '\n' + column + '\n'));
  CHECK_EQUAL(counts.size(), 1000u);
  for (const auto& horizon : counts)
  {
    CHECK_EQUAL(horizon.second, 2);
  }
}

// ---- Progress ----------------------------------------------------------------------------------------------------
void ProgressRunsToTheEnd()
{
  std::istringstream stream(Small);
  double last = 0.0;
  int calls = 0;
  ReadSparseMatrix(stream, {},
    Monitor(
      [&](double part)
      {
        CHECK(part >= last && part <= 1.0);
        last = part;
        ++calls;
        return true;
      }),
    16);
  CHECK_EQUAL(last, 1.0);
  CHECK(calls > 2);
}

void ParsingStopsOnRequest()
{
  const auto scan = [](const Monitor& monitor)
  {
    std::istringstream stream(Small);
    ReadSparseMatrix(stream, {}, monitor, 16);
  };
  CHECK_EQUAL(MonitorChecker::Check(3, scan), std::string());
}
}

int TestSparseMatrixParser(int, char*[])
{
  VoxelsAreCounted();
  DefaultBufferSizeWorks();
  LoadGivesAllAttributes();
  HorizonsComeByAscendingId();
  RangesAndSizesAreLeftOut();
  LayoutIsFree();
  EmptyLastColumnNeedsNoNewline();
  NumbersAreRoundedCorrectly();
  NumbersTooSmallAreZero();
  DigitsAndExponentMakeUpForEachOther();
  PolicyChoosesAmongDuplicates();
  EquallyStrongDuplicatesKeepTheTopmost();
  NeighbouringColumnsAreNoDuplicates();
  ManySurfacesAreToldApart();
  ProgressRunsToTheEnd();
  ParsingStopsOnRequest();
  return Check::Result();
}
