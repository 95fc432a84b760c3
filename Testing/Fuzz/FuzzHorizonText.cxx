// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An input is a text file of picks. It is read in buffers and blocks of several sizes, which must not matter, and its
// picks are put onto a lattice.

#include "Require.h"

#include "Common/Survey/PickPlacement.h"
#include "Readers/HorizonText/HorizonTextParser.h"

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
  PickTable Picks;
};

Outcome Read(const std::string& text, const TextPieces& pieces)
{
  Outcome outcome;
  try
  {
    std::istringstream stream(text);
    const TextLayout layout = ReadTextLayout(stream, TextOptions());
    outcome.Picks = ReadPicks(stream, layout, Monitor(), pieces);
    Require(
      outcome.Picks.HasPlaces() || outcome.Picks.HasLines() || outcome.Picks.Size() == 0, "picks without a place");
    Require(!layout.Describe().empty(), "no description");
  }
  catch (const InputError& error)
  {
    outcome.Error = error.what();
  }
  return outcome;
}

/// All columns of a table.
std::vector<const std::vector<double>*> Columns(const PickTable& picks)
{
  std::vector<const std::vector<double>*> columns = { &picks.X, &picks.Y, &picks.Inline, &picks.Crossline, &picks.Z };
  for (const PickAttribute& attribute : picks.Attributes)
  {
    columns.push_back(&attribute.Values);
  }
  return columns;
}

/// Bit by bit.
bool IsSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

bool IsSame(const Outcome& a, const Outcome& b)
{
  const auto columns = Columns(a.Picks);
  const auto others = Columns(b.Picks);
  return a.Error == b.Error && a.Picks.Names == b.Picks.Names && a.Picks.Horizon == b.Picks.Horizon &&
    std::equal(columns.begin(), columns.end(), others.begin(), others.end(),
      [](const auto* x, const auto* y) { return IsSame(*x, *y); });
}

void CheckPicks(const PickTable& picks)
{
  Require(!picks.Names.empty(), "no horizon");
  Require(picks.Horizon.empty() || picks.Horizon.size() == picks.Size(), "picks without a horizon");
  for (const int horizon : picks.Horizon)
  {
    Require(horizon >= 0 && std::size_t(horizon) < picks.Names.size(), "a horizon that is not there");
  }
  for (const std::vector<double>* column : Columns(picks))
  {
    Require(column->empty() || column->size() == picks.Size(), "columns of different lengths");
    for (const double value : *column)
    {
      Require(!std::isinf(value), "an infinite number");
    }
  }
  for (const std::vector<double>* column : { &picks.X, &picks.Y, &picks.Inline, &picks.Crossline })
  {
    for (const double value : *column)
    {
      Require(std::isfinite(value), "a place that is no number");
    }
  }
}

void CheckHorizon(const LatticeHorizon& horizon, const SurveyLattice& lattice)
{
  for (std::size_t n = 0; n < horizon.RealZ.size(); ++n)
  {
    const int i = horizon.Column[n].X;
    const int j = horizon.Column[n].Y;
    Require(std::isfinite(horizon.RealZ[n]), "a point without z");
    Require(i >= 0 && i < lattice.Columns[0] && j >= 0 && j < lattice.Columns[1], "a point outside the lattice");
    Require(n == 0 || horizon.Column[n - 1].Y < j || (horizon.Column[n - 1].Y == j && horizon.Column[n - 1].X < i),
      "points not in order");
  }
}

void CheckPlacement(const PickTable& picks)
{
  try
  {
    const SurveyHorizons placed = PlacePicks(picks, PlacementOptions());
    Require(placed.Horizons.size() == picks.Names.size(), "number of horizons");
    Require(placed.LargestDistance <= PlacementOptions().Tolerance, "a point off the lattice");
    std::int64_t points = 0;
    for (const LatticeHorizon& horizon : placed.Horizons)
    {
      CheckHorizon(horizon, placed.Lattice);
      points += std::int64_t(horizon.RealZ.size()) + horizon.DroppedDuplicates + horizon.DroppedNulls;
    }
    Require(points == std::int64_t(picks.Size()), "counts do not add up");
  }
  catch (const InputError&)
  {
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Outcome whole = Read(text, TextPieces());
  for (const std::size_t bytes : { std::size_t(1), 2 + size % 61, std::size_t(64) })
  {
    Require(IsSame(Read(text, { bytes, 1 + bytes / 2 }), whole), "the size of pieces matters");
  }
  if (whole.Error.empty())
  {
    CheckPicks(whole.Picks);
    CheckPlacement(whole.Picks);
  }
  return 0;
}
