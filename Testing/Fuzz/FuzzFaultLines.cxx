// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An input is a file of fault lines. What ends its lines must not matter; what was read is printed as plain lines and
// read again, and cuts a small horizon, as traces and as sticks.

#include "Require.h"

#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"
#include "Readers/FaultLines/FaultLineFile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

using namespace Fuzz;
using namespace SeismicHorizons;

namespace
{
/// What came of a file: an error, or what is in it.
struct Outcome
{
  std::string Error;
  FaultLineFile File;
};

Outcome Read(const std::string& text)
{
  Outcome outcome;
  try
  {
    std::istringstream stream(text);
    outcome.File = ReadFaultLines(stream);
  }
  catch (const InputError& error)
  {
    outcome.Error = error.what();
  }
  return outcome;
}

bool AreSamePlaces(const FaultLineFile& a, const FaultLineFile& b)
{
  return a.Ends == b.Ends &&
    std::equal(a.Places.begin(), a.Places.end(), b.Places.begin(), b.Places.end(),
      [](const SpacePoint& x, const SpacePoint& y) { return x.X == y.X && x.Y == y.Y && x.Z == y.Z; });
}

void CheckLines(const FaultLineFile& file)
{
  Require(!file.Ends.empty() && file.Ends.back() == file.Places.size(), "places behind the last line");
  Require(file.Names.size() == file.Ends.size(), "number of names");
  std::size_t start = 0;
  for (const std::size_t end : file.Ends)
  {
    Require(end >= start + 2, "a line of less than two places");
    start = end;
  }
  for (const SpacePoint& place : file.Places)
  {
    Require(std::isfinite(place.X) && std::isfinite(place.Y) && std::isfinite(place.Z), "place not finite");
  }
}

/// Lines of x y z, between which a line is empty; null where a place would be the end of a polyline.
std::string Print(const FaultLineFile& file)
{
  std::ostringstream text;
  text.precision(17);
  std::size_t start = 0;
  for (const std::size_t end : file.Ends)
  {
    for (; start < end; ++start)
    {
      const SpacePoint& place = file.Places[start];
      text << place.X << ' ' << place.Y << ' ' << place.Z << '\n';
    }
    text << '\n';
  }
  return text.str();
}

bool HasEndOfPart(const FaultLineFile& file)
{
  return std::any_of(file.Places.begin(), file.Places.end(),
    [](const SpacePoint& place) { return place.X == 999.0 && place.Y == 999.0 && place.Z == 999.0; });
}

std::string WithCarriageReturns(const std::string& text)
{
  std::string result;
  for (const char character : text)
  {
    result += character == '\n' ? "\r\n" : std::string(1, character);
  }
  return result;
}

/// Each link is cut once at most, and is one of the lattice.
void CheckCuts(const FaultLines& lines, int width, int length)
{
  for (std::size_t n = 0; n < lines.NumberOfLinks(); ++n)
  {
    const LatticeLink& link = lines[n].Place;
    const bool isEast = link.Side == LinkSide::East;
    Require(link.Column.X >= 0 && link.Column.Y >= 0 && link.Column.X + (isEast ? 1 : 0) < width &&
        link.Column.Y + (isEast ? 0 : 1) < length,
      "a cut outside the lattice");
  }
}

void CutHorizon(const FaultLineFile& file)
{
  constexpr int width = 9;
  constexpr int length = 7;
  std::vector<PlanePoint> columns;
  std::vector<double> heights;
  for (int n = 0; n < width * length; ++n)
  {
    columns.push_back({ n % width, n / width });
    heights.push_back(n % width < 4 ? 0.0 : 3.0);
  }
  const ColumnHeights horizon(columns, heights);
  std::vector<FaultPolyline> traces;
  std::vector<FaultStick> sticks;
  std::size_t start = 0;
  for (std::size_t line = 0; line < file.Ends.size(); ++line)
  {
    traces.emplace_back();
    sticks.push_back({ {}, file.Names[line] });
    for (; start < file.Ends[line]; ++start)
    {
      traces.back().push_back({ file.Places[start].X, file.Places[start].Y });
      sticks.back().Places.push_back(file.Places[start]);
    }
  }
  CheckCuts(CutAlong(horizon, traces), width, length);
  CheckCuts(CutAlong(horizon, FindTraces(horizon, MakeFaultSheets(sticks, true))), width, length);
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Outcome whole = Read(text);
  Require(whole.Error.empty() || whole.Error.compare(0, 5, "line ") == 0, "an error without its line: " + whole.Error);
  const Outcome other = Read(WithCarriageReturns(text));
  Require(other.Error.empty() == whole.Error.empty() && AreSamePlaces(other.File, whole.File) &&
      other.File.Names == whole.File.Names,
    "what ends lines matters");
  if (whole.Error.empty())
  {
    CheckLines(whole.File);
    CutHorizon(whole.File);
    const Outcome again = Read(Print(whole.File));
    Require(HasEndOfPart(whole.File) || (again.Error.empty() && AreSamePlaces(again.File, whole.File)),
      "plain lines are read otherwise: " + again.Error);
  }
  return 0;
}
