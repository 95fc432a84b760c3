// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An input is a file of the sparse-matrix format. It is read with every policy for duplicates, and in buffers of
// several sizes, which must not matter.

#include "Require.h"

#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

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
  SparseMatrix Matrix;
};

Outcome Read(const std::string& text, DuplicatePolicy policy, std::size_t bufferSize)
{
  Outcome outcome;
  try
  {
    std::istringstream stream(text);
    outcome.Matrix = ReadSparseMatrix(stream, { policy }, Monitor(), bufferSize);
  }
  catch (const InputError& error)
  {
    outcome.Error = error.what();
  }
  return outcome;
}

/// Bit by bit.
bool IsSame(const HeapArray<double>& a, const HeapArray<double>& b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

bool IsSame(const LatticeHorizon& a, const LatticeHorizon& b)
{
  return a.SurfaceId == b.SurfaceId && a.Column == b.Column && a.K == b.K && IsSame(a.Thickness, b.Thickness) &&
    IsSame(a.Amplitude, b.Amplitude) && IsSame(a.RealZ, b.RealZ) && a.DroppedDuplicates == b.DroppedDuplicates;
}

bool IsSame(const Outcome& a, const Outcome& b)
{
  const auto sameVoxels = [](const LatticeHorizon& x, const LatticeHorizon& y) { return IsSame(x, y); };
  const std::vector<LatticeHorizon>& horizons = a.Matrix.Horizons;
  const std::vector<LatticeHorizon>& others = b.Matrix.Horizons;
  return a.Error == b.Error && a.Matrix.Size == b.Matrix.Size &&
    a.Matrix.VerticalFit.Offset == b.Matrix.VerticalFit.Offset &&
    a.Matrix.VerticalFit.Step == b.Matrix.VerticalFit.Step &&
    std::equal(horizons.begin(), horizons.end(), others.begin(), others.end(), sameVoxels);
}

bool IsInside(int index, int size)
{
  return index >= 0 && index < size;
}

void CheckVoxels(const LatticeHorizon& horizon, const SparseMatrixSize& size)
{
  for (std::size_t n = 0; n < horizon.Column.size(); ++n)
  {
    Require(IsInside(horizon.Column[n].X, size[0]) && IsInside(horizon.Column[n].Y, size[1]) &&
        IsInside(horizon.K[n], size[2]),
      "voxel outside the lattice");
    Require(
      std::isfinite(horizon.Thickness[n]) && std::isfinite(horizon.Amplitude[n]) && std::isfinite(horizon.RealZ[n]),
      "voxel with a number that is not finite");
    Require(n == 0 || horizon.Column[n - 1].Y < horizon.Column[n].Y ||
        (horizon.Column[n - 1].Y == horizon.Column[n].Y && horizon.Column[n - 1].X < horizon.Column[n].X),
      "voxels of a horizon not in the order of the columns");
  }
}

void CheckMatrix(const Outcome& outcome)
{
  const SparseMatrixVerticalFit& fit = outcome.Matrix.VerticalFit;
  Require(std::isfinite(fit.Offset) && std::isfinite(fit.Step), "vertical fit not finite");
  for (std::size_t n = 0; n < outcome.Matrix.Horizons.size(); ++n)
  {
    const LatticeHorizon& horizon = outcome.Matrix.Horizons[n];
    Require(!horizon.Column.empty() && (n == 0 || outcome.Matrix.Horizons[n - 1].SurfaceId < horizon.SurfaceId),
      "horizons without voxels, or not by ascending ID");
    CheckVoxels(horizon, outcome.Matrix.Size);
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const DuplicatePolicy policy :
    { DuplicatePolicy::StrongestAmplitude, DuplicatePolicy::Topmost, DuplicatePolicy::Lowest })
  {
    const Outcome whole = Read(text, policy, size + 1);
    Require(
      whole.Error.empty() || whole.Error.compare(0, 5, "line ") == 0, "an error without its line: " + whole.Error);
    if (whole.Error.empty())
    {
      CheckMatrix(whole);
    }
    for (const std::size_t bufferSize : { std::size_t(1), 2 + size % 61, std::size_t(64) })
    {
      Require(IsSame(Read(text, policy, bufferSize), whole), "the size of the buffer matters");
    }
  }
  return 0;
}
