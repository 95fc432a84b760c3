// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonRoughSimplification
 * @brief   thins a horizon to one point per square cell inside its outline
 *
 * Input and output: as of vtkHorizonCellSimplification, with one point per cell of the inside, row by row.
 *
 * The lattice is divided into square cells of CellSize columns, from the minimum corner of the bounding box of the
 * horizon. A cell with boundary points keeps only these; any other is replaced by the barycentre of its points (thesis
 * 4.3.1, Alg. 4.1), or by the point nearest to that. Points of different patches are never merged. If a barycentre lies
 * outside the boundary, the nearest point of the cell is the representative, so every point stays strictly inside. A
 * cell size of 1 changes nothing.
 *
 * Time is linear in the points and the cells of the bounding box; the result is bitwise identical for any number of
 * threads. Cells do not depend on the curvature of the surface: use vtkHorizonElaborateSimplification to remove more
 * points.
 *
 * Errors: a cell size below 1, no boundary loops, no PatchId, or no lattice in the field data.
 *
 * @sa vtkHorizonElaborateSimplification vtkHorizonBoundarySimplification vtkBinnedDecimation
 */

#ifndef vtkHorizonRoughSimplification_h
#define vtkHorizonRoughSimplification_h

#include "vtkHorizonCellSimplification.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonRoughSimplification : public vtkHorizonCellSimplification
{
public:
  static vtkHorizonRoughSimplification* New();
  vtkTypeMacro(vtkHorizonRoughSimplification, vtkHorizonCellSimplification);

protected:
  vtkHorizonRoughSimplification()
    : vtkHorizonCellSimplification(3)
  {
  }
  ~vtkHorizonRoughSimplification() override = default;

  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonRoughSimplification(const vtkHorizonRoughSimplification&) = delete;
  void operator=(const vtkHorizonRoughSimplification&) = delete;
};

#endif
