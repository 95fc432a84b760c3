// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parser of sparse-matrix files on compressed ones: the same voxels, the same errors with the same lines, and one
// error for whatever is wrong with the compression.

#include "Common/Base/Errors.h"
#include "ParserFixtures.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"
#include "Tools/Check.h"
#include "Tools/Gzip.h"
#include "Tools/MonitorChecker.h"

#include <array>
#include <random>
#include <sstream>
#include <string>

using namespace SeismicHorizons;
using ParserFixtures::Small;

namespace
{
constexpr std::array<std::size_t, 4> BufferSizes = { 1, 7, 64, 4096 };

/// What is in a file, or what is wrong with it.
std::string Describe(std::istream& stream, std::size_t bufferSize)
{
  try
  {
    const SparseMatrix matrix = ReadSparseMatrix(stream, {}, Monitor(), bufferSize);
    std::ostringstream text;
    for (const LatticeHorizon& horizon : matrix.Horizons)
    {
      for (std::size_t n = 0; n < horizon.Column.size(); ++n)
      {
        text << horizon.SurfaceId << ' ' << horizon.Column[n].X << ' ' << horizon.Column[n].Y << ' ' << horizon.K[n]
             << ' ' << horizon.Amplitude[n] << '\n';
      }
    }
    return text.str();
  }
  catch (const InputError& error)
  {
    return error.what();
  }
}

std::string DescribePlain(const std::string& text, std::size_t bufferSize = 4096)
{
  std::istringstream stream(text);
  return Describe(stream, bufferSize);
}

std::string DescribeCompressed(const std::string& compressed, std::size_t bufferSize = 4096)
{
  return Describe(*Gzip::Open(compressed), bufferSize);
}

/// A file with as many columns, each with a voxel of two horizons.
std::string MakeText(int columns)
{
  std::string text = std::to_string(columns) + " 1 100000\n";
  for (int i = 0; i < columns; ++i)
  {
    text += std::to_string(i % 1000) + " 1 2 " + std::to_string(i * 7919 % 10007) + " 3 " +
      std::to_string(2000 + i % 77) + " 2 1 1 1\n";
  }
  return text;
}

void VoxelsAreTheSame()
{
  const std::string large = MakeText(200000);
  CHECK(large.size() > 4352u * 1024); // more than two blocks
  CHECK(DescribeCompressed(Gzip::Compress(large), SparseMatrixBufferSize) == DescribePlain(large));
  for (const std::size_t bufferSize : BufferSizes)
  {
    CHECK_EQUAL(DescribeCompressed(Gzip::Compress(Small), bufferSize), DescribePlain(Small));
    const std::string parts = Gzip::Compress(Small.substr(0, 30)) + Gzip::Compress(Small.substr(30));
    CHECK_EQUAL(DescribeCompressed(parts, bufferSize), DescribePlain(Small));
  }
}

void ErrorsHaveTheLineOfTheText()
{
  for (const std::string text : { "", "1 1", "2 2 5\n\n\n", "2 2 5\n\n5 1 1 1 1\n\n\n", "1 1 5\n1 1 1 1\n" })
  {
    CHECK(DescribePlain(text).find("line ") == 0);
    CHECK_EQUAL(DescribeCompressed(Gzip::Compress(text)), DescribePlain(text));
  }
}

/// However a file is cut, the error is that of the compression, unless the text that is there is wrong itself.
void CutFilesGiveOneError()
{
  const std::string compressed = Gzip::Compress(Small);
  for (const std::size_t bufferSize : BufferSizes)
  {
    for (std::size_t size = 0; size < compressed.size(); ++size)
    {
      CHECK_EQUAL(DescribeCompressed(compressed.substr(0, size), bufferSize),
        "byte " + std::to_string(size) + ": end of file, expected the rest of the compressed data");
    }
  }
}

void DamagedFilesGiveOneErrorOrTheSame()
{
  const std::string compressed = Gzip::Compress(Small);
  std::mt19937_64 engine;
  const auto random = [&engine](std::size_t below) { return static_cast<std::size_t>(engine() % below); };
  int refused = 0;
  constexpr int numberOfFiles = 5000;
  for (int file = 0; file < numberOfFiles; ++file)
  {
    std::string damaged = compressed;
    for (std::size_t change = 0; change <= random(3); ++change)
    {
      damaged[random(damaged.size())] = static_cast<char>(random(256));
    }
    const std::string found = DescribeCompressed(damaged, BufferSizes[random(BufferSizes.size())]);
    const bool isError = found.find("byte ") == 0 || found.find("line ") == 0;
    CHECK(isError || found == DescribePlain(Small));
    CHECK(!isError || found.find(", expected ") != std::string::npos);
    refused += isError ? 1 : 0;
  }
  CHECK(refused > numberOfFiles / 2 && refused < numberOfFiles);
}

void ProgressRunsToTheEndAndStops()
{
  const std::string compressed = Gzip::Compress(MakeText(200000));
  double last = 0.0;
  int calls = 0;
  const auto watch = [&](double part)
  {
    CHECK(part >= last && part <= 1.0);
    last = part;
    ++calls;
    return true;
  };
  ReadSparseMatrix(*Gzip::Open(compressed), {}, Monitor(watch), 256 * 1024);
  CHECK_EQUAL(last, 1.0);
  CHECK(calls > 10);
  const auto read = [&compressed](const Monitor& monitor)
  { ReadSparseMatrix(*Gzip::Open(compressed), {}, monitor, 1024 * 1024); };
  CHECK_EQUAL(MonitorChecker::Check(3, read), std::string());
}
}

int TestCompressedMatrix(int, char*[])
{
  VoxelsAreTheSame();
  ErrorsHaveTheLineOfTheText();
  CutFilesGiveOneError();
  DamagedFilesGiveOneErrorOrTheSame();
  ProgressRunsToTheEndAndStops();
  return Check::Result();
}
