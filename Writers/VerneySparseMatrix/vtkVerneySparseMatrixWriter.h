// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVerneySparseMatrixWriter
 * @brief   writes the points of horizons to a sparse-matrix file (.vsm)
 *
 * Takes horizons whose points stand on whole columns of their lattice: as a reader gives them, as Threshold or Clip
 * leave parts of them, or with their exterior boundary. Points that were merged stand on no column any more, and are
 * refused. The lattice is that of the field data LatticeDimensions and LatticeToWorld; all horizons have to have as
 * many cells, and the same vertical indices. Where it lies in the world is not part of the format.
 *
 * Each point becomes a voxel, by the point arrays that the reader gives:
 * - SurfaceId, the same at all points of a horizon and different in each; a horizon without it gets the least positive
 *   ID that no other one has;
 * - VerticalIndex, whole numbers; without it the vertical index nearest to the point by LatticeToWorld;
 * - Thickness; without it 1;
 * - Amplitude; without it 0;
 * - RealZ; without it world z, or its negative unless the field data VerticalDirection are 1.
 *
 * Other arrays, lines and triangles are not part of the format. Horizons without points are left out.
 *
 * The file is in its normal form (Documentation/FileFormat.md): one that is in it already comes out the same, byte by
 * byte, when it is read and written. Time grows as n log n in the points and linear in the columns; memory is about 60
 * bytes for each point.
 *
 * @sa vtkVerneySparseMatrixReader
 */

#ifndef vtkVerneySparseMatrixWriter_h
#define vtkVerneySparseMatrixWriter_h

#include "vtkHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkVerneySparseMatrixWriter : public vtkHorizonWriter
{
public:
  static vtkVerneySparseMatrixWriter* New();
  vtkTypeMacro(vtkVerneySparseMatrixWriter, vtkHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkVerneySparseMatrixWriter() = default;
  ~vtkVerneySparseMatrixWriter() override = default;

  void PrintHorizons(
    const std::vector<NamedHorizon>& horizons, std::ostream& stream, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkVerneySparseMatrixWriter(const vtkVerneySparseMatrixWriter&) = delete;
  void operator=(const vtkVerneySparseMatrixWriter&) = delete;
};

#endif
