// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonRoughSimplification
 * @brief   thins out a horizon to one point per square cell inside its outline
 *
 * Input and output: as vtkHorizonCellSimplification describes. One point for each cell of the inside, row by row.
 *
 * The plane of the lattice is cut into square cells of CellSize columns, from the least corner of the bounding box of
 * the horizon. A cell with boundary points keeps these and nothing else; any other is replaced by the barycentre of its
 * points (thesis 4.3.1, Alg. 4.1), or by the point nearest to that. Points of different patches are never merged. Where
 * a boundary edge crosses the cell so that the barycentre lies outside, the nearest point of the cell represents it,
 * with its own attributes; so every point stays strictly inside the boundary. A cell size of 1 changes nothing.
 *
 * Linear in the points and the cells of the bounding box; cells run in parallel (vtkSMPTools), and the result is the
 * same to the bit for any number of threads. How curved the surface is does not matter: use small cells, to thin out a
 * horizon that is sampled too finely, and vtkHorizonElaborateSimplification to remove more points.
 *
 * Errors: a cell size below 1, no boundary loops, no PatchId, no lattice in the field data.
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

  SeismicHorizons::Reduction Simplify(const SeismicHorizons::BoundedHorizon& horizon, vtkFieldData* chosen,
    const SeismicHorizons::Monitor& monitor) override;
  bool HasCubes() const override { return false; }

private:
  vtkHorizonRoughSimplification(const vtkHorizonRoughSimplification&) = delete;
  void operator=(const vtkHorizonRoughSimplification&) = delete;
};

#endif
