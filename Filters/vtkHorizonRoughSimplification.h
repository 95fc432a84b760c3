// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonRoughSimplification
 * @brief   one point per square cell inside the outline of a horizon
 *
 * Input: what vtkHorizonExteriorBoundary or vtkHorizonBoundarySimplification gives. Output: boundary points and loops
 * as they were, then one point for each cell of the inside, row by row. PointCount is summed: it says how many points
 * of the original horizon each point stands for. Where a point is the barycentre of several, arrays of floating point
 * numbers and VerticalIndex are averaged, weighted by PointCount; all other arrays are labels, and are taken from the
 * nearest of the points that were merged. VerticalIndex becomes an array of doubles.
 *
 * The plane of the lattice is cut into square cells of CellSize columns, from the least corner of the bounding box of
 * the horizon. A cell with boundary points keeps these and nothing else; any other is replaced by the barycentre of
 * its points (thesis 4.3.1, Alg. 4.1). Points of different patches are never merged. Where a boundary edge crosses the
 * cell so that the barycentre lies outside, the nearest point of the cell stands for it, with its own attributes; so
 * every point stays strictly inside the boundary.
 *
 * Linear in the points; beyond input and output about 70 bytes per point. It takes no account of how curved the
 * surface is: use small cells, to thin out a horizon that is sampled too finely.
 *
 * Errors: a cell size below 1, no boundary loops, no PatchId, no lattice in the field data.
 *
 * @sa vtkHorizonBoundarySimplification vtkHorizonTriangulation vtkBinnedDecimation
 */

#ifndef vtkHorizonRoughSimplification_h
#define vtkHorizonRoughSimplification_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonRoughSimplification : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonRoughSimplification* New();
  vtkTypeMacro(vtkHorizonRoughSimplification, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The side of a cell in columns of the lattice (thesis: s). At least 1, and 1 changes nothing. Default: 3.
   */
  vtkSetMacro(CellSize, int);
  vtkGetMacro(CellSize, int);
  ///@}

protected:
  vtkHorizonRoughSimplification() = default;
  ~vtkHorizonRoughSimplification() override = default;

  void ProcessHorizon(vtkPolyData* input, vtkPolyData* output, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonRoughSimplification(const vtkHorizonRoughSimplification&) = delete;
  void operator=(const vtkHorizonRoughSimplification&) = delete;

  int CellSize = 3;
};

#endif
