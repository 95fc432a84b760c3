// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseMatrixParser.h"

#include "Common/Horizon/Lattice.h"
#include "Common/Survey/ColumnSheets.h"
#include "Common/Text/InputFile.h"
#include "Common/Text/LineBuffer.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"
#include "Common/Text/TextNumbers.h"
#include "Common/Text/TextWords.h"
#include "PieceParser.h"
#include "VerticalFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr const char* ExpectedHeader = ", expected three positive integers \"nX nY nZ\" below 2^31";
constexpr std::size_t MaximumHeader = 4096; // characters with the newline

/// The number of cells must fit 63 bits.
bool IsCountable(const SparseMatrixSize& size)
{
  const std::int64_t columns = std::int64_t(size[0]) * size[1];
  return columns <= std::numeric_limits<std::int64_t>::max() / size[2];
}

SparseMatrixSize ParseHeader(const std::string& line)
{
  const std::string header = "header " + Quote(std::string_view(line).substr(0, line.size() - 1));
  SparseMatrixSize size = {};
  const char* text = SkipBlanks(line.c_str());
  for (int& n : size)
  {
    const std::string_view token = TokenAt(text);
    n = ReadPositiveInteger(token);
    text = SkipBlanks(text + token.size());
  }
  if (*std::min_element(size.begin(), size.end()) == 0 || *text != '\n')
  {
    throw ErrorAt(1, header + ExpectedHeader);
  }
  if (!IsCountable(size))
  {
    throw ErrorAt(1, header + ", expected a product below 2^63");
  }
  if (std::max(size[0], size[1]) > MostColumnsPerSide)
  {
    throw ErrorAt(1, header + ", expected nX and nY below 2^28");
  }
  return size;
}

LatticeHorizon TakeVoxels(const LatticeHorizon& horizon, const std::vector<std::int32_t>& voxels)
{
  LatticeHorizon some;
  some.SurfaceId = horizon.SurfaceId;
  some.Column = Gather<HeapArray<PlanePoint>>(horizon.Column, voxels);
  some.K = Gather<HeapArray<int>>(horizon.K, voxels);
  some.Thickness = Gather<HeapArray<double>>(horizon.Thickness, voxels);
  some.Amplitude = Gather<HeapArray<double>>(horizon.Amplitude, voxels);
  some.RealZ = Gather<HeapArray<double>>(horizon.RealZ, voxels);
  return some;
}

/// The first sheet of a horizon counts the dropped voxels, those of sheets that are too small included.
std::vector<LatticeHorizon> SplitAll(std::vector<LatticeHorizon> horizons, std::int64_t smallestSize)
{
  std::vector<LatticeHorizon> all;
  for (LatticeHorizon& horizon : horizons)
  {
    const ColumnSheets sheets =
      SplitIntoSheets({ horizon.Column.data(), horizon.Column.size() }, { horizon.K.begin(), horizon.K.end() });
    if (sheets.Points.front().size() == horizon.Column.size())
    {
      all.push_back(std::move(horizon));
      continue;
    }
    const std::size_t first = all.size();
    std::int64_t dropped = sheets.Dropped;
    for (const std::vector<std::int32_t>& voxels : sheets.Points)
    {
      if (std::int64_t(voxels.size()) >= smallestSize)
      {
        all.push_back(TakeVoxels(horizon, voxels));
      }
      else
      {
        dropped += std::int64_t(voxels.size());
      }
    }
    if (first < all.size())
    {
      all[first].DroppedDuplicates = dropped;
    }
    horizon = LatticeHorizon();
  }
  return all;
}

/// Lines have five numbers per voxel; others give -1.
int CountVoxels(std::string_view line, int indices)
{
  FieldCursor fields(line, FieldSeparator::Blanks);
  std::string_view field;
  int numbers = 0;
  for (double value = 0.0; fields.Next(field); ++numbers)
  {
    const int place = numbers % 5;
    if (ReadNumber(field, value) != NumberKind::Finite || (place < 2 && value != std::round(value)) ||
      (place == 0 && (value < 0.0 || value >= indices)))
    {
      return -1;
    }
  }
  return numbers % 5 == 0 ? numbers / 5 : -1;
}

bool HasVoxels(std::istream& stream, int indices)
{
  const std::string text = PeekLines(stream);
  int voxels = 0;
  for (std::size_t start = 0; start < text.size(); start = text.find('\n', start) + 1)
  {
    const std::size_t end = text.find('\n', start);
    const int found = CountVoxels(std::string_view(text).substr(start, end - start), indices);
    if (end == std::string::npos)
    {
      return voxels + std::max(found, 0) > 0; // The last line of a truncated file may have any length.
    }
    if (found < 0)
    {
      return false;
    }
    voxels += found;
  }
  return voxels > 0;
}
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixSize ReadSparseMatrixHeader(std::istream& stream)
{
  // Files of other formats may have no newline at all.
  std::array<char, MaximumHeader> text;
  stream.getline(text.data(), text.size());
  if (stream.bad())
  {
    throw ErrorAt(1, std::string("reading failed") + ExpectedHeader);
  }
  const bool isComplete = stream.good();
  const std::size_t length = static_cast<std::size_t>(stream.gcount()) - (isComplete ? 1 : 0);
  const std::string line(WithoutByteOrderMark(std::string_view(text.data(), length)));
  if (!isComplete && line.empty())
  {
    throw CutOffAt(1, std::string("empty file") + ExpectedHeader);
  }
  if (!isComplete && !stream.eof())
  {
    throw ErrorAt(1, "header " + Quote(line) + ExpectedHeader);
  }
  return ParseHeader(line + '\n');
}

//----------------------------------------------------------------------------------------------------------------------
bool BeginsAsSparseMatrix(std::istream& stream)
{
  return HasVoxels(stream, ReadSparseMatrixHeader(stream)[2]);
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrix ReadSparseMatrix(
  std::istream& stream, const SparseMatrixOptions& options, const Monitor& monitor, std::size_t bufferSize)
{
  SparseMatrix matrix;
  matrix.Size = ReadSparseMatrixHeader(stream);
  LineBuffer lines(stream, bufferSize);
  PieceParser pieces(matrix.Size, options);
  HorizonCollector horizons;
  pieces.ParseAll(
    lines, monitor,
    [&](const std::vector<HorizonSorter>& blocks, std::size_t count) { horizons.Add(blocks, count, lines.PartRead()); },
    [](std::int64_t) { return true; });
  pieces.RequireEnd();
  matrix.Horizons = horizons.Take(options.SmallestSize);
  if (options.Policy == DuplicatePolicy::Sheets)
  {
    matrix.Horizons = SplitAll(std::move(matrix.Horizons), options.SmallestSize);
  }
  matrix.VerticalFit = FitVertically(matrix.Horizons);
  return matrix;
}
}
