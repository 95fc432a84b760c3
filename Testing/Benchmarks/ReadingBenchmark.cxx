// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Speed of the parser of sparse-matrix files, beside a bare loop over the mapped bytes: that one knows digits, points
// and minus signs, checks nothing, rounds as it happens, and puts numbers into vectors.
//
//   ReadingBenchmark FILE.vsm...
//
// Prints lines "voxels,what,threads,seconds": by the clock, the least of several runs.

#include "BenchmarkTools.h"
#include "Common/Base/Parallel.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// The bytes of a file in memory.
class MappedFile
{
public:
  explicit MappedFile(const std::string& path)
    : Descriptor(open(path.c_str(), O_RDONLY))
  {
    struct stat status = {};
    if (this->Descriptor < 0 || fstat(this->Descriptor, &status) != 0)
    {
      throw std::runtime_error(path + " cannot be opened");
    }
    this->Length = std::size_t(status.st_size);
    this->Bytes =
      static_cast<const char*>(mmap(nullptr, this->Length, PROT_READ, MAP_PRIVATE | MAP_POPULATE, this->Descriptor, 0));
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile()
  {
    munmap(const_cast<char*>(this->Bytes), this->Length);
    close(this->Descriptor);
  }

  const char* begin() const { return this->Bytes; }
  const char* end() const { return this->Bytes + this->Length; }

private:
  int Descriptor;
  std::size_t Length = 0;
  const char* Bytes = nullptr;
};

struct BareVoxels
{
  std::vector<std::int32_t> Line;
  std::vector<std::int32_t> K;
  std::vector<std::int32_t> SurfaceId;
  std::vector<double> Thickness;
  std::vector<double> Amplitude;
  std::vector<double> RealZ;
};

/// Digits are added to `value`.
const char* AddDigits(const char* text, std::int64_t& value)
{
  for (; *text >= '0' && *text <= '9'; ++text)
  {
    value = value * 10 + (*text - '0');
  }
  return text;
}

const char* BareInteger(const char* text, std::int32_t& value)
{
  const bool isNegative = *text == '-';
  std::int64_t digits = 0;
  text = AddDigits(text + isNegative, digits);
  value = std::int32_t(isNegative ? -digits : digits);
  return text;
}

const char* BareNumber(const char* text, double& value)
{
  constexpr std::array<double, 13> Powers = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12 };
  const bool isNegative = *text == '-';
  std::int64_t digits = 0;
  text = AddDigits(text + isNegative, digits);
  std::size_t places = 0;
  if (*text == '.')
  {
    const char* const first = text + 1;
    text = AddDigits(first, digits);
    places = std::size_t(text - first);
  }
  value = double(digits) / Powers[places];
  value = isNegative ? -value : value;
  return text;
}

BareVoxels ReadBare(const std::string& path)
{
  const MappedFile file(path);
  BareVoxels voxels;
  std::int32_t line = 0;
  const char* text = static_cast<const char*>(std::memchr(file.begin(), '\n', std::size_t(file.end() - file.begin())));
  for (++text; text < file.end();)
  {
    if (*text == '\n')
    {
      ++line;
      ++text;
      continue;
    }
    std::int32_t k = 0;
    std::int32_t id = 0;
    std::array<double, 3> values = {};
    text = BareInteger(text, k) + 1;
    text = BareInteger(text, id);
    for (double& value : values)
    {
      text = BareNumber(text + 1, value);
    }
    text += text < file.end() && *text != '\n';
    voxels.Line.push_back(line);
    voxels.K.push_back(k);
    voxels.SurfaceId.push_back(id);
    voxels.Thickness.push_back(values[0]);
    voxels.Amplitude.push_back(values[1]);
    voxels.RealZ.push_back(values[2]);
  }
  return voxels;
}

std::size_t CountVoxels(const SparseMatrix& matrix)
{
  std::size_t voxels = 0;
  for (const LatticeHorizon& horizon : matrix.Horizons)
  {
    voxels += horizon.Column.size();
  }
  return voxels;
}

template <typename Work>
void Report(std::size_t voxels, const char* what, int threads, Work&& work)
{
  std::printf("%zu,%s,%d,%g\n", voxels, what, threads, BenchmarkTools::Time(work, CLOCK_MONOTONIC));
}

void Measure(const std::string& path)
{
  const auto read = [&path]
  {
    std::ifstream stream(path, std::ios::binary);
    return ReadSparseMatrix(stream);
  };
  const std::size_t voxels = CountVoxels(read());
  if (ReadBare(path).K.size() != voxels)
  {
    throw std::runtime_error(path + ": the bare loop needs one blank between numbers, and no more");
  }
  Report(voxels, "bare", 1, [&path] { ReadBare(path); });
  for (const int threads : { 1, 2 })
  {
    Detail::NumberOfThreads() = threads;
    Report(voxels, "parser", threads, read);
  }
}
}

int main(int argc, char** argv)
{
  try
  {
    std::printf("voxels,what,threads,seconds\n");
    for (int n = 1; n < argc; ++n)
    {
      Measure(argv[n]);
    }
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "ReadingBenchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
