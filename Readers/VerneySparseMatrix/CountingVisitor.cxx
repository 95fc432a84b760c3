// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CountingVisitor.h"

#include <cmath>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void VerticalFitter::Add(const SparseMatrixVoxel& voxel)
{
  // Relative to the first voxel: the differences between sums of large, nearly equal numbers would be mostly rounding.
  if (this->Count++ == 0)
  {
    this->First = voxel;
  }
  const double k = double(voxel.VerticalIndex) - this->First.VerticalIndex;
  const double z = voxel.RealZ - this->First.RealZ;
  this->SumK += k;
  this->SumZ += z;
  this->SumKK += k * k;
  this->SumKZ += k * z;
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixVerticalFit VerticalFitter::Fit() const
{
  const double count = static_cast<double>(this->Count);
  const double spread = count * this->SumKK - this->SumK * this->SumK;
  const double step = spread > 0.0 ? (count * this->SumKZ - this->SumK * this->SumZ) / spread : 0.0;
  if (step == 0.0 || !std::isfinite(step))
  {
    return {};
  }
  const double offset = (this->SumZ - step * this->SumK) / count;
  return { this->First.RealZ + offset - step * this->First.VerticalIndex, step };
}

//----------------------------------------------------------------------------------------------------------------------
void CountingVisitor::VisitColumn(int, int, const std::vector<SparseMatrixVoxel>& voxels)
{
  for (const SparseMatrixVoxel& voxel : voxels)
  {
    int position = this->Positions.Find(voxel.SurfaceId);
    if (position == SurfacePositions::None)
    {
      position = static_cast<int>(this->CountsById.size());
      this->Positions.Insert(voxel.SurfaceId, position);
      this->CountsById.emplace_back(voxel.SurfaceId, 0);
    }
    ++this->CountsById[static_cast<std::size_t>(position)].second;
    this->Fitter.Add(voxel);
  }
}
}
