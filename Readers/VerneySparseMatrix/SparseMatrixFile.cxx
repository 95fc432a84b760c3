// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseMatrixFile.h"

#include "SparseMatrixOverview.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
VoxelExtent FindMatrixExtent(const LatticeHorizon& horizon)
{
  if (horizon.Column.empty())
  {
    return EmptyExtent;
  }
  const PlaneBox box({ horizon.Column.data(), horizon.Column.size() });
  const auto k = std::minmax_element(horizon.K.begin(), horizon.K.end());
  return { box.Least.X, box.Greatest.X, box.Least.Y, box.Greatest.Y, *k.first, *k.second };
}

class WholeFile : public SparseMatrixFile
{
public:
  void List(const std::string& name, const SparseMatrixOptions& options, const Monitor& monitor) override
  {
    const FileStamp stamp = MakeFileStamp(name);
    if (this->Stamp == stamp && this->Options == options)
    {
      return;
    }
    this->Stamp = FileStamp();
    this->Listed.clear();
    this->Matrix.reset();
    this->Matrix = ReadSparseMatrix(*OpenInputFile(name), options, monitor);
    this->Stamp = stamp;
    this->Options = options;
    this->Cells = this->Matrix->Size;
    this->Fit = this->Matrix->VerticalFit;
    for (const LatticeHorizon& horizon : this->Matrix->Horizons)
    {
      this->Listed.push_back({ horizon.SurfaceId, std::int64_t(horizon.Column.size()), FindMatrixExtent(horizon) });
    }
  }

  /// The voxels are used once: kept, they would double the memory of the output.
  SparseMatrix Take(const std::vector<int>&, const Monitor& monitor) override
  {
    if (std::optional<SparseMatrix> kept = std::exchange(this->Matrix, std::nullopt))
    {
      return std::move(*kept);
    }
    return ReadSparseMatrix(*OpenInputFile(this->Stamp.Name), this->Options, monitor);
  }

private:
  std::optional<SparseMatrix> Matrix;
};

class FileWithOverview : public SparseMatrixFile
{
public:
  void List(const std::string& name, const SparseMatrixOptions& options, const Monitor& monitor) override
  {
    const FileStamp stamp = MakeFileStamp(name);
    this->Listed.clear();
    if (!(this->Stamp == stamp) || !(ForAllRows(this->Options) == ForAllRows(options)))
    {
      this->Stamp = FileStamp();
      this->Overview = SparseMatrixOverview();
      this->Overview = ReadSparseMatrixOverview(*OpenInputFile(name), options, monitor);
      this->Stamp = stamp;
      this->Cells = this->Overview.Size;
      this->Fit = this->Overview.VerticalFit;
    }
    this->Options = options;
    for (const auto& [surfaceId, horizon] : this->Overview.Horizons)
    {
      const std::int64_t size = horizon.CountVoxels(options.RowRange[0], options.RowRange[1]);
      if (size >= options.SmallestSize)
      {
        this->Listed.push_back({ surfaceId, size });
      }
    }
  }

  SparseMatrix Take(const std::vector<int>& places, const Monitor& monitor) override
  {
    SparseMatrix matrix;
    matrix.Size = this->Cells;
    SparseMatrixOptions options = this->Options;
    for (const int place : places)
    {
      options.Surfaces.push_back(this->Listed[place].SurfaceId);
    }
    if (!places.empty())
    {
      matrix = ReadSparseMatrixRows(*OpenInputFile(this->Stamp.Name), this->Overview, options, monitor);
    }
    std::vector<LatticeHorizon> horizons(this->Listed.size());
    auto read = matrix.Horizons.begin();
    for (const int place : places)
    {
      horizons[place].SurfaceId = this->Listed[place].SurfaceId;
      if (read != matrix.Horizons.end() && read->SurfaceId == horizons[place].SurfaceId)
      {
        horizons[place] = std::move(*read++);
      }
    }
    assert(read == matrix.Horizons.end());
    matrix.Horizons = std::move(horizons);
    return matrix;
  }

  int CountRows() const override { return this->Overview.Size[1]; }

  std::int64_t CountVoxels(std::size_t place, int firstRow, int lastRow) const override
  {
    return this->OverviewOf(place).CountVoxels(firstRow, lastRow);
  }

  PlaneBox ColumnsOf(std::size_t place) const override { return this->OverviewOf(place).Box; }

  SparseMatrix TakeRows(std::size_t place, int firstRow, int lastRow) const override
  {
    SparseMatrixOptions options = ForAllRows(this->Options);
    options.Surfaces = { this->Listed[place].SurfaceId };
    options.RowRange = { firstRow, lastRow };
    SparseMatrix matrix = ReadSparseMatrixRows(*OpenInputFile(this->Stamp.Name), this->Overview, options);
    matrix.Horizons.resize(1);
    matrix.Horizons.front().SurfaceId = this->Listed[place].SurfaceId;
    return matrix;
  }

private:
  const HorizonOverview& OverviewOf(std::size_t place) const
  {
    return this->Overview.Horizons.at(this->Listed[place].SurfaceId);
  }

  SparseMatrixOverview Overview;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::unique_ptr<SparseMatrixFile> MakeSparseMatrixFile(bool withOverview)
{
  if (withOverview)
  {
    return std::make_unique<FileWithOverview>();
  }
  return std::make_unique<WholeFile>();
}
}
