// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parser of sparse-matrix files: what it refuses, in which words.

#include "ParserFixtures.h"
#include "Tools/Check.h"

#include <stdexcept>
#include <string>

using namespace ParserFixtures;

namespace
{
// ---- What is refused ---------------------------------------------------------------------------------------------
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

void HeaderIsChecked()
{
  const std::string expected = ", expected three positive integers \"nX nY nZ\" below 2^31";
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
  for (const std::string header : { "268435456 2 3", "2 268435456 3" })
  {
    CheckRefused(header + '\n', "line 1: header \"" + header + "\", expected nX and nY below 2^28");
  }
  CheckRefused(std::string(10000, '7'), "line 1: header \"" + std::string(32, '7') + "...\"" + expected);
  CheckRefused(std::string(10000, '\0'), "line 1: header \"" + std::string(32, '?') + "...\"" + expected);
}

void LargeHeaderTakesNoMemory()
{
  CheckRefused("268435455 268435455 2\n0 1 0 0 0\n", "line 3: end of file after 2 columns, expected 72057593501057025");
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
    for (const LatticeHorizon& horizon : matrix.Horizons)
    {
      CHECK(!horizon.Column.empty() && horizon.Column.size() == horizon.Column.size());
      CHECK(horizon.RealZ.size() == horizon.Column.size() && horizon.K.size() == horizon.Column.size());
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
}

int TestSparseMatrixErrors(int, char*[])
{
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
  return Check::Result();
}
