// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An input is a GOCAD file. It is read in buffers of several sizes, which must not matter, and what was read is printed
// and read again.

#include "Require.h"

#include "Readers/GOCADTSurf/TSurfParser.h"
#include "Writers/GOCADTSurf/TSurfPrinter.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

using namespace Fuzz;
using namespace SeismicHorizons;

namespace
{
/// What came of a file: an error, or what is in it.
struct Outcome
{
  std::string Error;
  TSurfList List;
  std::vector<TSurf> Surfaces;
};

Outcome Read(const std::string& text, std::size_t bufferSize)
{
  Outcome outcome;
  try
  {
    std::istringstream loaded(text);
    outcome.Surfaces = LoadTSurfs(
      loaded, [](std::size_t) { return true; }, Monitor(), bufferSize);
    std::istringstream listed(text);
    outcome.List = ListTSurfs(listed, Monitor(), bufferSize);
  }
  catch (const InputError& error)
  {
    outcome.Error = error.what();
  }
  return outcome;
}

/// Bit by bit, but that one nan is as good as another.
bool IsSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](double x, double y) { return (std::isnan(x) && std::isnan(y)) || std::memcmp(&x, &y, sizeof(double)) == 0; });
}

bool IsSame(const TSurfProperty& a, const TSurfProperty& b)
{
  return a.Name == b.Name && a.Unit == b.Unit && a.Size == b.Size && IsSame(a.Values, b.Values);
}

bool IsSame(const TSurf& a, const TSurf& b)
{
  return a.Name == b.Name && a.Colour == b.Colour && a.Positive == b.Positive &&
    a.Survey.VerticalUnit == b.Survey.VerticalUnit && a.Survey.CoordinateSystem == b.Survey.CoordinateSystem &&
    a.Vertices == b.Vertices && a.Triangles == b.Triangles && a.Parts == b.Parts && a.BorderStones == b.BorderStones &&
    a.Borders == b.Borders &&
    std::equal(a.Properties.begin(), a.Properties.end(), b.Properties.begin(), b.Properties.end(),
      [](const TSurfProperty& x, const TSurfProperty& y) { return IsSame(x, y); });
}

bool IsSame(const Outcome& a, const Outcome& b)
{
  return a.Error == b.Error && a.List.Names == b.List.Names && a.List.OtherObjects == b.List.OtherObjects &&
    std::equal(a.Surfaces.begin(), a.Surfaces.end(), b.Surfaces.begin(), b.Surfaces.end(),
      [](const TSurf& x, const TSurf& y) { return IsSame(x, y); });
}

void CheckSurface(const TSurf& surface)
{
  for (const auto& place : surface.Vertices)
  {
    Require(std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]), "coordinate not finite");
  }
  for (const TSurf::Triangle& triangle : surface.Triangles)
  {
    for (const PointId vertex : triangle)
    {
      Require(vertex >= 0 && std::size_t(vertex) < surface.Vertices.size(), "triangle of no vertex");
    }
  }
  Require(surface.Parts.empty() || surface.Parts.size() == surface.Triangles.size(), "number of parts");
  for (const TSurfProperty& property : surface.Properties)
  {
    Require(property.Values.size() == property.Size * surface.Vertices.size(), "number of values");
    for (const double value : property.Values)
    {
      Require(!std::isinf(value), "infinite value");
    }
  }
}

/// What a file said of a surface, as a file of our own.
std::string Print(const TSurf& surface)
{
  std::ostringstream stream;
  PrintTSurf(surface, true, stream);
  return stream.str();
}

/// Text that no line of ours can hold may come from one of another program.
bool CanBePrinted(const TSurf& surface)
{
  try
  {
    Print(surface);
    return true;
  }
  catch (const InputError&)
  {
    return false;
  }
}

/// What is printed is read again, and then printed the same: atoms are vertices of their own by then.
void CheckPrinted(const TSurf& surface)
{
  const Outcome first = Read(Print(surface), 4096);
  Require(first.Error.empty() && first.Surfaces.size() == 1, "own file refused: " + first.Error);
  const Outcome second = Read(Print(first.Surfaces.front()), 4096);
  Require(second.Error.empty() && second.Surfaces.size() == 1, "own file refused: " + second.Error);
  Require(first.Surfaces.front().Name == surface.Name, "another name");
  Require(first.Surfaces.front().Triangles.size() == surface.Triangles.size(), "another number of triangles");
  Require(Print(second.Surfaces.front()) == Print(first.Surfaces.front()), "printed in two ways");
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Outcome whole = Read(text, size + 1);
  Require(whole.Error.empty() || whole.Error.compare(0, 5, "line ") == 0, "an error without its line: " + whole.Error);
  Require(!whole.Error.empty() || whole.List.Names.size() == whole.Surfaces.size(), "list and surfaces differ");
  for (const TSurf& surface : whole.Surfaces)
  {
    CheckSurface(surface);
    if (CanBePrinted(surface))
    {
      CheckPrinted(surface);
    }
  }
  for (const std::size_t bufferSize : { std::size_t(1), 2 + size % 61, std::size_t(64) })
  {
    Require(IsSame(Read(text, bufferSize), whole), "the size of the buffer matters");
  }
  return 0;
}
