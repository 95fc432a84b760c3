// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseMatrixPrinter.h"

#include "Common/Base/Errors.h"
#include "Common/Text/TextPrinter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t ColumnsBetweenReports = 1 << 16;

struct VoxelReference
{
  std::int64_t Column; // i + nX * j
  std::uint32_t Horizon; // index in the list
  std::uint32_t Voxel; // index in the horizon
};

class MatrixPrinter
{
public:
  MatrixPrinter(const SparseMatrix& matrix, std::ostream& stream)
    : Matrix(matrix)
    , Out(stream)
  {
    this->CheckIds();
    for (std::size_t horizon = 0; horizon < matrix.Horizons.size(); ++horizon)
    {
      const LatticeHorizon& voxels = matrix.Horizons[horizon];
      for (std::size_t voxel = 0; voxel < voxels.Column.size(); ++voxel)
      {
        this->CheckVoxel(voxels, voxel);
        const std::int64_t column = voxels.Column[voxel].X + std::int64_t(matrix.Size[0]) * voxels.Column[voxel].Y;
        this->Voxels.push_back({ column, std::uint32_t(horizon), std::uint32_t(voxel) });
      }
    }
    std::sort(this->Voxels.begin(), this->Voxels.end(),
      [this](const VoxelReference& a, const VoxelReference& b)
      { return a.Column != b.Column ? a.Column < b.Column : this->IndexOf(a) < this->IndexOf(b); });
  }

  void Print(const Monitor& monitor)
  {
    const auto& [nX, nY, nZ] = this->Matrix.Size;
    this->Out.PrintLine(" ", nX, nY, nZ);
    const std::int64_t columns = std::int64_t(nX) * nY;
    auto voxel = this->Voxels.cbegin();
    for (std::int64_t column = 0; column < columns; ++column)
    {
      if (column % ColumnsBetweenReports == 0)
      {
        monitor.Progress(double(column) / double(columns));
      }
      const auto first = voxel;
      for (; voxel != this->Voxels.cend() && voxel->Column == column; ++voxel)
      {
        this->CheckCell(first, voxel);
        this->PrintVoxel(*voxel, voxel == first);
      }
      this->Out.Print('\n');
    }
    this->Out.Flush();
    monitor.Progress(1.0);
  }

private:
  using Reference = std::vector<VoxelReference>::const_iterator;

  const LatticeHorizon& HorizonOf(const VoxelReference& voxel) const { return this->Matrix.Horizons[voxel.Horizon]; }
  int IndexOf(const VoxelReference& voxel) const { return this->HorizonOf(voxel).K[voxel.Voxel]; }

  void CheckIds() const
  {
    std::set<int> ids;
    for (const LatticeHorizon& horizon : this->Matrix.Horizons)
    {
      if (!ids.insert(horizon.SurfaceId).second)
      {
        throw InputError(
          "two horizons with the surface ID " + std::to_string(horizon.SurfaceId) + ", expected one ID for each");
      }
    }
  }

  void CheckVoxel(const LatticeHorizon& horizon, std::size_t voxel) const
  {
    const std::array<int, 3> place = { horizon.Column[voxel].X, horizon.Column[voxel].Y, horizon.K[voxel] };
    for (std::size_t axis = 0; axis < place.size(); ++axis)
    {
      if (place[axis] < 0 || place[axis] >= this->Matrix.Size[axis])
      {
        throw InputError(std::string(1, "ijk"[axis]) + " = " + std::to_string(place[axis]) + " of voxel " +
          std::to_string(voxel) + " of the horizon with the surface ID " + std::to_string(horizon.SurfaceId) +
          ", expected 0 to " + std::to_string(this->Matrix.Size[axis] - 1));
      }
    }
    for (const double number : { horizon.Thickness[voxel], horizon.Amplitude[voxel], horizon.RealZ[voxel] })
    {
      if (!std::isfinite(number))
      {
        throw InputError(std::to_string(number) + " as thickness, amplitude or real z of voxel " +
          std::to_string(voxel) + " of the horizon with the surface ID " + std::to_string(horizon.SurfaceId) +
          ", expected a finite number");
      }
    }
  }

  /// Voxels of a column are sorted, so that duplicates are adjacent.
  void CheckCell(Reference firstOfColumn, Reference voxel) const
  {
    if (voxel != firstOfColumn && this->IndexOf(*voxel) == this->IndexOf(*(voxel - 1)))
    {
      const std::int64_t nX = this->Matrix.Size[0];
      throw InputError("two voxels in the cell (" + std::to_string(voxel->Column % nX) + ", " +
        std::to_string(voxel->Column / nX) + ", " + std::to_string(this->IndexOf(*voxel)) + "), of the surface IDs " +
        std::to_string(this->HorizonOf(*(voxel - 1)).SurfaceId) + " and " +
        std::to_string(this->HorizonOf(*voxel).SurfaceId) + ", expected at most one");
    }
  }

  void PrintVoxel(const VoxelReference& reference, bool isFirst)
  {
    const LatticeHorizon& horizon = this->HorizonOf(reference);
    const std::size_t voxel = reference.Voxel;
    this->Out.Print(isFirst ? "" : " ", horizon.K[voxel], ' ', horizon.SurfaceId);
    this->Out.Print(' ', horizon.Thickness[voxel], ' ', horizon.Amplitude[voxel], ' ', horizon.RealZ[voxel]);
  }

  const SparseMatrix& Matrix;
  std::vector<VoxelReference> Voxels;
  TextPrinter Out;
};
}

//----------------------------------------------------------------------------------------------------------------------
void PrintSparseMatrix(const SparseMatrix& matrix, std::ostream& stream, const Monitor& monitor)
{
  MatrixPrinter(matrix, stream).Print(monitor);
}
}
