// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVerneySparseMatrixWriter
 * @brief   writes the points of horizons to a sparse-matrix file (.vsm)
 *
 * Points must be on whole columns of their lattice: as from a reader, reduced by Threshold or Clip, or with their
 * exterior boundary. Merged points are refused. The lattice is that of the field data LatticeDimensions and
 * LatticeToWorld; all horizons must have the same dimensions and vertical indices. The format has no world coordinates
 * of the lattice.
 *
 * Each point becomes a voxel, from these point arrays:
 * - SurfaceId, constant per horizon and different in each; else the smallest positive ID that no other has
 * - VerticalIndex, whole numbers; else the vertical index nearest to the point by LatticeToWorld
 * - Thickness; else 1
 * - Amplitude; else 0
 * - RealZ; else world z, negated unless the field data VerticalDirection are 1
 *
 * Other arrays, lines and triangles are not part of the format. Horizons without points are left out.
 *
 * The file is in normal form (Documentation/VerneySparseMatrix.md): reading and writing one in that form reproduces it byte for
 * byte. Time is n log n in the points and linear in the columns; memory is about 60 bytes per point.
 *
 * @sa vtkVerneySparseMatrixReader
 */

#ifndef vtkVerneySparseMatrixWriter_h
#define vtkVerneySparseMatrixWriter_h

#include "vtkHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h"

class VTKSEISMICHORIZONS_EXPORT vtkVerneySparseMatrixWriter : public vtkHorizonWriter
{
public:
  static vtkVerneySparseMatrixWriter* New();
  vtkTypeMacro(vtkVerneySparseMatrixWriter, vtkHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkVerneySparseMatrixWriter() = default;
  ~vtkVerneySparseMatrixWriter() override = default;

  void PrintHorizons(const std::vector<WrittenHorizon>& horizons, std::ostream& stream,
    const SeismicHorizons::Monitor& monitor) override;

private:
  vtkVerneySparseMatrixWriter(const vtkVerneySparseMatrixWriter&) = delete;
  void operator=(const vtkVerneySparseMatrixWriter&) = delete;
};

#endif
