// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that are cut off, damaged or cannot be read on, and work that is stopped, in all formats.

#include "GridSamples.h"
#include "Readers/HorizonGrid/GridReader.h"
#include "Tools/MonitorChecker.h"

#include <algorithm>
#include <stdexcept>

using namespace GridSamples;
using namespace SeismicHorizons;

namespace
{
constexpr std::array<std::size_t, 5> BufferSizes = { 1, 3, 7, 64, 4096 };

bool IsBinary(const std::string& file)
{
  return file.find('\0') != std::string::npos;
}

/// What is left is read as the whole file, or refused. Nothing tells that an EarthVision file has fewer points.
void CutFilesAreRefused()
{
  for (const std::string& file : All())
  {
    const bool isPoints = file == EarthVision();
    const std::size_t lastLetter = IsBinary(file) ? file.size() - 1 : file.find_last_not_of('\n');
    for (std::size_t length = 0; length < file.size(); ++length)
    {
      try
      {
        const HorizonGrid grid = Read(file.substr(0, length));
        CHECK(isPoints || (length > lastLetter && IsTheSample(grid)));
      }
      catch (const InputError& error)
      {
        CHECK(length <= lastLetter);
        CHECK(std::string(error.what()).find(", expected ") != std::string::npos);
      }
    }
  }
}

void BufferSizesDoNotMatter()
{
  for (const std::string& file : All())
  {
    for (const std::size_t size : BufferSizes)
    {
      CHECK(IsTheSample(Read(file, size)));
    }
  }
}

/// Windows ends its lines with two characters.
void LineEndsMayBeOfWindows()
{
  for (const std::string& file : All())
  {
    std::string text;
    for (const char c : file)
    {
      text += c == '\n' ? "\r\n" : std::string(1, c);
    }
    CHECK(IsBinary(file) || IsTheSample(Read(text)));
  }
}

/// A grid, or an error that says what was expected.
bool IsAccepted(const std::string& file, std::size_t bufferSize)
{
  try
  {
    const HorizonGrid grid = Read(file, bufferSize);
    CHECK(std::int64_t(grid.Z.size()) == std::int64_t(grid.Lattice.Columns[0]) * grid.Lattice.Columns[1]);
    CHECK(std::none_of(grid.Z.begin(), grid.Z.end(), [](double z) { return std::isinf(z); }));
    CHECK(grid.Lattice.Origin.allFinite() && grid.Lattice.ColumnStep.allFinite() && grid.Lattice.RowStep.allFinite());
    return true;
  }
  catch (const InputError& error)
  {
    CHECK(std::string(error.what()).find("expected ") != std::string::npos);
    return false;
  }
}

void DamagedFilesAreRefusedOrRead()
{
  const std::string letters = "0123456789+-.eED \t\r\n\n,naif\xFF#!\"@";
  std::uint64_t state = 1;
  const auto random = [&state](std::size_t below)
  {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>((state >> 33) % below);
  };
  for (const std::string& file : All())
  {
    int accepted = 0;
    for (int n = 0; n < 2000; ++n)
    {
      std::string damaged = file;
      for (std::size_t change = 0; change <= random(4); ++change)
      {
        const std::size_t place = random(damaged.size());
        damaged.replace(
          place, random(2), random(8) == 0 ? std::string(1, '\0') : letters.substr(random(letters.size()), 1));
      }
      const bool isFine = IsAccepted(damaged, 4096);
      CHECK_EQUAL(IsAccepted(damaged, 1 + random(20)), isFine);
      accepted += isFine ? 1 : 0;
    }
    CHECK(accepted > 10 && accepted < 2000);
  }
}

/// A stream that breaks after its text, once the format is known.
class BreakingBuffer : public std::stringbuf
{
public:
  using std::stringbuf::stringbuf;

protected:
  std::streamsize xsgetn(char* text, std::streamsize count) override
  {
    ++this->Calls;
    const std::streamsize read = std::stringbuf::xsgetn(text, count);
    return this->Calls == 1 || read == count ? read : throw std::runtime_error("broken");
  }

private:
  int Calls = 0;
};

void ReadErrorsAreTold()
{
  for (const std::string& file : All())
  {
    BreakingBuffer buffer(file.substr(0, file.size() - 2));
    std::istream stream(&buffer);
    CHECK_THROWS_WITH(ReadHorizonGrid(stream), "reading failed, expected ");
  }
}

void ReadingStopsOnRequest()
{
  for (const std::string& file : { IrapText(), Zmap(), CompressedGxf(), EarthVision() })
  {
    const auto read = [&](const Monitor& monitor)
    {
      std::istringstream stream(file);
      ReadHorizonGrid(stream, monitor, 16);
    };
    CHECK_EQUAL(MonitorChecker::Check(3, read), std::string());
  }
  const auto readBytes = [](const Monitor& monitor)
  {
    std::istringstream stream(IrapBinary());
    ReadHorizonGrid(stream, monitor);
  };
  CHECK_EQUAL(MonitorChecker::Check(2, readBytes), std::string());
}

/// A grid may stand behind other things in a stream.
void ReadingBeginsWhereTheStreamIs()
{
  for (const std::string& file : { IrapText(), Storm() })
  {
    std::istringstream stream("first line\n" + file);
    std::string line;
    std::getline(stream, line);
    CHECK(IsTheSample(ReadHorizonGrid(stream)));
  }
}
}

int TestDamagedGrids(int, char*[])
{
  CutFilesAreRefused();
  BufferSizesDoNotMatter();
  LineEndsMayBeOfWindows();
  DamagedFilesAreRefusedOrRead();
  ReadErrorsAreTold();
  ReadingStopsOnRequest();
  ReadingBeginsWhereTheStreamIs();
  return Check::Result();
}
