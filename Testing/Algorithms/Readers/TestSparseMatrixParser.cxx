// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parser of sparse-matrix files: what it reads, and what it refuses in which words. All checks run with several
// sizes of buffer, from two bytes on, so that every token is cut by the end of one somewhere.

#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "VerneySparseMatrix/SparseMatrixParser.h"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr std::array<std::size_t, 6> BufferSizes = { 1, 2, 3, 7, 64, 4096 };

// 3 x 2 x 10 cells, horizons 4 and -7. Column (1, 0) has both, (2, 0) none, the last one has horizon 4.
const std::string Small = "3 2 10\n"
                          "5 4 1.5 -20 21.25\n"
                          "2 -7 1 1e2 8 6 4 2 -0.5 24\n"
                          "\n"
                          "\n"
                          "9 -7 1 7 36\n"
                          "0 4 1 3 0.125\n";

SparseMatrix Load(
  const std::string& text, DuplicatePolicy policy = DuplicatePolicy::StrongestAmplitude, std::size_t bufferSize = 4096)
{
  std::istringstream stream(text);
  return ReadSparseMatrix(stream, { policy }, Monitor(), bufferSize);
}

/// Voxels by surface ID, duplicates included.
using Counts = std::map<int, std::int64_t>;

Counts Count(const SparseMatrix& matrix)
{
  Counts counts;
  for (const HorizonVoxels& horizon : matrix.Horizons)
  {
    counts[horizon.SurfaceId] = static_cast<std::int64_t>(horizon.I.size()) + horizon.DroppedDuplicates;
  }
  return counts;
}

/// The real z of the only voxel of a file, after it went through the parser as `number`.
double ReadNumber(const std::string& number)
{
  return Load("1 1 1\n0 1 0 0 " + number + "\n").Horizons.at(0).RealZ.front();
}

void CheckRefused(const std::string& text, const std::string& message)
{
  for (const std::size_t bufferSize : BufferSizes)
  {
    CHECK_THROWS_WITH(Load(text, DuplicatePolicy::Lowest, bufferSize), message);
  }
}

/// Checks the message for one line of voxels, which is line 3 of a file.
void CheckLineRefused(const std::string& line, const std::string& message)
{
  CheckRefused("2 2 10\n\n" + line + "\n\n\n", "line 3: " + message);
}

// ---- What is read ------------------------------------------------------------------------------------------------
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
    const HorizonVoxels& horizon = matrix.Horizons.at(1);
    CHECK_EQUAL(horizon.SurfaceId, 4);
    CHECK((horizon.I == std::vector<int>{ 0, 1, 2 }));
    CHECK((horizon.J == std::vector<int>{ 0, 0, 1 }));
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
  CHECK_EQUAL(matrix.Horizons.at(0).I.size(), 2u);
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
  CHECK_EQUAL(matrix.Horizons.at(0).I.size(), 1u);
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
  CHECK_EQUAL(matrix.Horizons.at(0).I.size(), 4u);
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

// ---- What is refused ---------------------------------------------------------------------------------------------
void HeaderIsChecked()
{
  const std::string expected = ", expected three positive integers \"nX nY nZ\"";
  CheckRefused("", "line 1: empty file" + expected);
  CheckRefused("\xEF\xBB\xBF", "line 1: empty file" + expected);
  for (const std::string header : { "", "3 2", "3 2 10 1", "3 2 0", "3 -2 10", "3 2 1.5", "a b c", "3 2 2147483648",
         "3 2 99999999999999999999", "3 2 +-1", "3 2 10;" })
  {
    CheckRefused(header + "\n\n\n\n\n\n\n", "line 1: header \"" + header.substr(0, 32));
    CheckRefused(header + "\n\n\n\n\n\n\n", "\"" + expected);
  }
  CheckRefused(
    "2147483647 2147483647 3\n", "line 1: header \"2147483647 2147483647 3\", expected a product below 2^63");
  CheckRefused(std::string(10000, '7'), "line 1: header \"" + std::string(32, '7') + "...\"" + expected);
  CheckRefused(std::string(10000, '\0'), "line 1: header \"" + std::string(32, '?') + "...\"" + expected);
}

void LargeHeaderTakesNoMemory()
{
  CheckRefused(
    "2147483647 2147483647 2\n0 1 0 0 0\n", "line 3: end of file after 2 columns, expected 4611686014132420609");
}

void NumberOfColumnsIsChecked()
{
  CheckRefused("2 2 5", "line 1: end of file after 0 columns, expected 4");
  CheckRefused("2 2 5\n\n\n", "line 4: end of file after 3 columns, expected 4");
  CheckRefused("2 2 5\n\n\n\n\n\n1 1 1 1 1\n", "line 7: \"1\" after the last column, expected the end of the file");
}

void NumberOfValuesIsChecked()
{
  CheckLineRefused("1", "1 values, expected a multiple of 5");
  CheckLineRefused("1 1 1 1", "4 values, expected a multiple of 5");
  CheckLineRefused("1 1 1 1 1 2", "6 values, expected a multiple of 5");
}

void VerticalIndexIsChecked()
{
  const std::string expected = ", expected an integer from 0 to 9";
  for (const std::string index : { "10", "-1", "1.5", "1e99", "-0.1" })
  {
    CheckLineRefused(index + " 1 0 0 0", "vertical index \"" + index + '"' + expected);
  }
  CheckLineRefused("1 1 0 0 0 9.5 1 0 0 0", "vertical index \"9.5\"" + expected);
}

void SurfaceIdIsChecked()
{
  for (const std::string id : { "2147483648", "-2147483649", "0.5", "1e300" })
  {
    CheckLineRefused(
      "1 " + id + " 0 0 0", "surface ID \"" + id + "\", expected an integer from -2147483648 to 2147483647");
  }
}

void TextIsRefused()
{
  CheckLineRefused("x 1 0 0 0", "vertical index \"x\", expected a number");
  CheckLineRefused("1 - 0 0 0", "surface ID \"-\", expected a number");
  CheckLineRefused("1 1 0x10 0 0", "thickness \"0x10\", expected a number");
  CheckLineRefused("1 1 0 1,5 0", "amplitude \"1,5\", expected a number");
  for (const std::string text : { "+-5", "++5", "-+5", "--5", "1.2.3", ".", "+", "e5", "1e", "1e+", "5f", "#" })
  {
    CheckLineRefused("1 1 0 0 " + text, "real z \"" + text + "\", expected a number");
  }
  CheckLineRefused(
    "1 1 0 0 " + std::string(5000, 'z'), "real z \"" + std::string(32, 'z') + "...\", expected a number");
  CheckLineRefused(std::string("1 1 0 0 \0", 9), "real z \"?\", expected a number");
  CheckLineRefused("1 1 0 0 \xC3\xA9", "real z \"??\", expected a number");
}

void InfiniteNumbersAreRefused()
{
  for (const std::string text :
    { "nan", "-nan", "NaN", "inf", "+inf", "-Infinity", "1e309", "-1e400", "1e99999999999999999999" })
  {
    CheckLineRefused("1 1 0 " + text + " 0", "amplitude \"" + text + "\", expected a finite number");
  }
  CheckLineRefused(
    "1 1 " + std::string(400, '9') + " 0 0", "thickness \"" + std::string(32, '9') + "...\", expected a finite number");
  for (const std::string exponent : { "e-5", "e+5", ".5e-5" })
  {
    CheckLineRefused("1 1 1" + std::string(400, '0') + exponent + " 0 0",
      "thickness \"1" + std::string(31, '0') + "...\", expected a finite number");
  }
}

void TwoVoxelsInACellAreRefused()
{
  const std::string message = "two voxels at vertical index 3, expected at most one in a cell";
  CheckLineRefused("3 1 0 0 0 3 1 0 0 0", message);
  CheckLineRefused("3 1 0 0 0 3 2 0 0 0", message);
  CheckLineRefused("9 1 0 0 0 3 1 0 0 0 4 1 0 0 0 3 5 0 0 0", message);
}

/// A stream that breaks after its text.
class BreakingBuffer : public std::stringbuf
{
public:
  using std::stringbuf::stringbuf;

protected:
  std::streamsize xsgetn(char* text, std::streamsize count) override
  {
    const std::streamsize read = std::stringbuf::xsgetn(text, count);
    return read == count ? read : throw std::runtime_error("broken");
  }
};

void ReadErrorsAreTold()
{
  BreakingBuffer buffer("2 2 5\n\n\n");
  std::istream stream(&buffer);
  CHECK_THROWS_WITH(ReadSparseMatrix(stream), "line 2: reading failed, expected the rest of the file");
}

// ---- Wrong files of any kind -------------------------------------------------------------------------------------
/// Parses a file that may be wrong. True when it is accepted; then all arrays are as long.
bool IsAccepted(const std::string& text, std::size_t bufferSize)
{
  try
  {
    const SparseMatrix matrix = Load(text, DuplicatePolicy::Lowest, bufferSize);
    for (const HorizonVoxels& horizon : matrix.Horizons)
    {
      CHECK(!horizon.I.empty() && horizon.J.size() == horizon.I.size());
      CHECK(horizon.RealZ.size() == horizon.I.size() && horizon.K.size() == horizon.I.size());
    }
    return true;
  }
  catch (const InputError& error)
  {
    CHECK(std::string(error.what()).rfind("line ", 0) == 0);
    CHECK(std::string(error.what()).find(", expected ") != std::string::npos);
    return false;
  }
}

void TruncatedFilesAreRefused()
{
  for (const std::size_t bufferSize : BufferSizes)
  {
    // Only within the last value, "0.125", can a cut go unnoticed, or where it leaves the last column empty.
    const std::size_t lastLine = Small.size() - std::string("0 4 1 3 0.125\n").size();
    const std::size_t lastValue = Small.size() - std::string("0.125\n").size();
    for (std::size_t length = 0; length < Small.size(); ++length)
    {
      const bool isFine = length == lastLine || length > lastValue;
      CHECK_EQUAL(IsAccepted(Small.substr(0, length), bufferSize), isFine);
    }
  }
}

void DamagedFilesAreRefusedOrRead()
{
  const std::string letters = "0123456789+-.eE \t\r\n\n\n naif\xFF#";
  std::uint64_t state = 1;
  const auto random = [&state](std::size_t below)
  {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>((state >> 33) % below);
  };
  int accepted = 0;
  constexpr int numberOfFiles = 20000;
  for (int file = 0; file < numberOfFiles; ++file)
  {
    std::string text = Small;
    for (std::size_t change = 0; change <= random(4); ++change)
    {
      const std::size_t place = random(text.size());
      text.replace(place, random(2), random(8) == 0 ? std::string(1, '\0') : letters.substr(random(letters.size()), 1));
    }
    const bool isFine = IsAccepted(text, 4096);
    CHECK_EQUAL(IsAccepted(text, 1 + random(20)), isFine);
    accepted += isFine ? 1 : 0;
  }
  CHECK(accepted > numberOfFiles / 100 && accepted < numberOfFiles);
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
  HeaderIsChecked();
  LargeHeaderTakesNoMemory();
  NumberOfColumnsIsChecked();
  NumberOfValuesIsChecked();
  VerticalIndexIsChecked();
  SurfaceIdIsChecked();
  TextIsRefused();
  InfiniteNumbersAreRefused();
  TwoVoxelsInACellAreRefused();
  ReadErrorsAreTold();
  TruncatedFilesAreRefused();
  DamagedFilesAreRefusedOrRead();
  ProgressRunsToTheEnd();
  ParsingStopsOnRequest();
  return Check::Result();
}
