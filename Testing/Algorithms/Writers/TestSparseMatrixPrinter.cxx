// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sparse-matrix files in their normal form.

#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Writers/VerneySparseMatrix/SparseMatrixPrinter.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

using namespace SeismicHorizons;

namespace
{
SparseMatrix Load(const std::string& text)
{
  std::istringstream stream(text);
  return ReadSparseMatrix(stream);
}

std::string Print(const SparseMatrix& matrix)
{
  std::ostringstream stream;
  PrintSparseMatrix(matrix, stream);
  return stream.str();
}

const std::string Normal = "3 2 10\n"
                           "5 4 1.5 -20 21.25\n"
                           "2 -7 1 100 8 6 4 2 -0.5 24\n"
                           "\n"
                           "\n"
                           "9 -7 1 7 36\n"
                           "0 4 1 3e-07 0.30000000000000004\n";

void NormalFilesStayAsTheyAre()
{
  CHECK_EQUAL(Print(Load(Normal)), Normal);
  CHECK_EQUAL(Print(Load("1 1 5\n\n")), "1 1 5\n\n");
  CHECK_EQUAL(Print(SparseMatrix{ { 2, 2, 1 }, {}, {} }), "2 2 1\n\n\n\n\n");
}

void OthersBecomeNormal()
{
  const std::string other = "\xEF\xBB\xBF 3\t2 10\r\n+5 4.0 1.50 -2e1 021.25\n6 4 2 -.5 24 2 -7 1 1e2 8  \n\n\n"
                            "9 -7 1 7 36\n0 4 1 0.0000003 0.30000000000000004";
  CHECK_EQUAL(Print(Load(other)), Normal);
}

/// Horizons, and voxels in them, may come in any order.
void VoxelsAreSorted()
{
  SparseMatrix matrix = Load(Normal);
  std::swap(matrix.Horizons.front(), matrix.Horizons.back());
  for (LatticeHorizon& horizon : matrix.Horizons)
  {
    std::reverse(horizon.Column.begin(), horizon.Column.end());
    std::reverse(horizon.K.begin(), horizon.K.end());
    std::reverse(horizon.Thickness.begin(), horizon.Thickness.end());
    std::reverse(horizon.Amplitude.begin(), horizon.Amplitude.end());
    std::reverse(horizon.RealZ.begin(), horizon.RealZ.end());
  }
  CHECK_EQUAL(Print(matrix), Normal);
}

void FileIsReadBack(const std::string& name)
{
  std::ifstream stream(name, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const SparseMatrix before = Load(text);
  const std::string printed = Print(before);
  CHECK(printed == text); // the generator of test data writes the normal form
  const SparseMatrix after = Load(printed);
  CHECK(before.Size == after.Size);
  CHECK_EQUAL(before.Horizons.size(), after.Horizons.size());
  for (std::size_t n = 0; n < before.Horizons.size(); ++n)
  {
    const LatticeHorizon& a = before.Horizons[n];
    const LatticeHorizon& b = after.Horizons[n];
    CHECK(a.SurfaceId == b.SurfaceId && a.Column == b.Column && a.K == b.K);
    CHECK(a.Thickness == b.Thickness && a.Amplitude == b.Amplitude && a.RealZ == b.RealZ);
  }
  CHECK_EQUAL(Print(after), printed);
}

void WrongVoxelsAreRefused()
{
  const auto check = [](auto&& change, const std::string& message)
  {
    SparseMatrix matrix = Load(Normal);
    change(matrix.Horizons);
    CHECK_THROWS_WITH(Print(matrix), message);
  };
  using Horizons = std::vector<LatticeHorizon>;
  check([](Horizons& horizons) { horizons[1].SurfaceId = -7; },
    "two horizons with the surface ID -7, expected one ID for each");
  check([](Horizons& horizons) { horizons[0].Column[1].X = 3; },
    "i = 3 of voxel 1 of the horizon with the surface ID -7, expected 0 to 2");
  check([](Horizons& horizons) { horizons[0].Column[1].Y = -1; }, "j = -1 of voxel 1");
  check([](Horizons& horizons) { horizons[0].K[0] = 10; }, "k = 10 of voxel 0");
  check([](Horizons& horizons) { horizons[0].K[0] = 6; }, "two voxels in the cell (1, 0, 6), of the surface IDs");
  check([](Horizons& horizons) { horizons[1].RealZ[2] = std::nan(""); },
    "nan as thickness, amplitude or real z of voxel 2 of the horizon with the surface ID 4, expected a finite number");
  check([](Horizons& horizons) { horizons[1].Thickness[0] = HUGE_VAL; }, "inf as thickness");
  check([](Horizons& horizons) { horizons[1].Amplitude[0] = -HUGE_VAL; }, "-inf as thickness, amplitude");
}

void WorkIsMonitored()
{
  const SparseMatrix matrix = { { 1000, 1000, 1 }, {}, {} };
  CHECK_EQUAL(MonitorChecker::Check(10,
                [&matrix](const Monitor& monitor)
                {
                  std::ostringstream stream;
                  PrintSparseMatrix(matrix, stream, monitor);
                }),
    "");
}
}

int TestSparseMatrixPrinter(int, char* argv[])
{
  NormalFilesStayAsTheyAre();
  OthersBecomeNormal();
  VoxelsAreSorted();
  FileIsReadBack(argv[1] + std::string("/blobs.vsm"));
  FileIsReadBack(argv[1] + std::string("/sample.vsm"));
  WrongVoxelsAreRefused();
  WorkIsMonitored();
  return Check::Result();
}
