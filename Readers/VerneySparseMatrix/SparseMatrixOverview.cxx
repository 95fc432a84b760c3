// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseMatrixOverview.h"

#include "Common/Base/Errors.h"
#include "Common/Text/LineBuffer.h"
#include "PieceParser.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
namespace
{
void Count(const LatticeHorizon& voxels, HorizonOverview& horizon)
{
  if (voxels.Column.empty())
  {
    return;
  }
  if (horizon.RowSizes.empty())
  {
    horizon.FirstRow = voxels.Column.front().Y;
  }
  horizon.RowSizes.resize(std::size_t(voxels.Column.back().Y - horizon.FirstRow) + 1, 0);
  for (const PlanePoint& column : voxels.Column)
  {
    ++horizon.RowSizes[column.Y - horizon.FirstRow];
    horizon.Box.Add(column);
  }
}

SparseMatrixOverview::Line FindLine(const SparseMatrixOverview& overview, int row)
{
  const std::int64_t column = std::int64_t(row) * overview.Size[0];
  const auto after = std::upper_bound(overview.Lines.begin(), overview.Lines.end(), column,
    [](std::int64_t wanted, const SparseMatrixOverview::Line& line) { return wanted < line.Column; });
  return *(after - 1);
}
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t HorizonOverview::CountVoxels(int firstRow, int lastRow) const
{
  const std::int64_t end = std::int64_t(this->RowSizes.size());
  const std::int64_t first = std::clamp<std::int64_t>(std::int64_t(firstRow) - this->FirstRow, 0, end);
  const std::int64_t last = std::clamp<std::int64_t>(std::int64_t(lastRow) + 1 - this->FirstRow, first, end);
  std::int64_t sum = 0;
  std::for_each(this->RowSizes.begin() + first, this->RowSizes.begin() + last, [&sum](std::int32_t n) { sum += n; });
  return sum;
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixOptions ForAllRows(SparseMatrixOptions options)
{
  options.RowRange = SparseMatrixOptions().RowRange;
  options.SmallestSize = SparseMatrixOptions().SmallestSize;
  options.Surfaces.clear();
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixOverview ReadSparseMatrixOverview(
  std::istream& stream, const SparseMatrixOptions& options, const Monitor& monitor, std::size_t bufferSize)
{
  SparseMatrixOverview overview;
  overview.Size = ReadSparseMatrixHeader(stream);
  std::int64_t byte = std::int64_t(stream.tellg());
  VerticalFitter fitter;
  LineBuffer lines(stream, bufferSize);
  PieceParser pieces(overview.Size, ForAllRows(options));
  pieces.ParseAll(
    lines, monitor,
    [&](const std::vector<HorizonSorter>& blocks, std::size_t count)
    {
      fitter.Add(blocks, count);
      for (std::size_t block = 0; block < count; ++block)
      {
        for (const LatticeHorizon& voxels : blocks[block].List())
        {
          if (!voxels.Column.empty())
          {
            Count(voxels, overview.Horizons[voxels.SurfaceId]);
          }
        }
      }
    },
    [&](std::int64_t column)
    {
      overview.Lines.push_back({ byte, column });
      byte += lines.Last() - lines.First();
      return true;
    });
  pieces.RequireEnd();
  overview.VerticalFit = fitter.Fit();
  return overview;
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrix ReadSparseMatrixRows(std::istream& stream, const SparseMatrixOverview& overview,
  const SparseMatrixOptions& options, const Monitor& monitor, std::size_t bufferSize)
{
  SparseMatrix matrix;
  matrix.Size = overview.Size;
  matrix.VerticalFit = overview.VerticalFit;
  const SparseMatrixOverview::Line first = FindLine(overview, std::min(options.RowRange[0], overview.Size[1]));
  const std::int64_t end = (std::int64_t(options.RowRange[1]) + 1) * overview.Size[0];
  stream.seekg(first.Byte);
  LineBuffer lines(stream, bufferSize);
  PieceParser pieces(overview.Size, options, first.Column);
  HorizonCollector horizons;
  pieces.ParseAll(
    lines, monitor,
    [&](const std::vector<HorizonSorter>& blocks, std::size_t count) { horizons.Add(blocks, count, 0.0); },
    [end](std::int64_t column) { return column < end; });
  matrix.Horizons = horizons.Take(options.SmallestSize);
  return matrix;
}
}
