// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonCellSimplification
 * @brief   base class of the simplifications by cells
 *
 * Input: the output of vtkHorizonExteriorBoundary or vtkHorizonBoundarySimplification. Output: boundary points and
 * loops, unchanged, then the representatives of cells. PointCount is summed: it is the number of points of the original
 * horizon that a point represents. At a barycentre, floating-point arrays and VerticalIndex (then double) are averaged,
 * weighted by PointCount; all other arrays are labels, taken from the nearest of the merged points. Its properties are
 * on HorizonCellSimplification.md.
 *
 * New point data: CellOrigin (int, components Level, Ring, Kind): how often the cell was halved; its ring, from 1 at
 * the boundary, 0 without rings; and 0 for a boundary point, 1 for a barycentre, 2 for a point of the input.
 *
 * With ShowCells the output is the cells as wireframe, for inspection, with the cell data CellOrigin, CellSize (double,
 * lattice units), PatchId and PointCount (points of the input in the cell).
 *
 * @sa vtkHorizonRoughSimplification vtkHorizonElaborateSimplification
 */

#ifndef vtkHorizonCellSimplification_h
#define vtkHorizonCellSimplification_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonCellSimplification : public vtkHorizonAlgorithm
{
public:
  vtkTypeMacro(vtkHorizonCellSimplification, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Edge length of cells: squares in the rough simplification (3 keeps about one point in nine), cubes in the
   * elaborate one. Unit: lattice units. Range: at least 1. Default: 3 in vtkHorizonRoughSimplification, 8 in
   * vtkHorizonElaborateSimplification.
   *
   * This is s of the thesis.
   */
  vtkHorizonNumberMacro(CellSize, int);

  /**
   * Largest number of points, for which CellSize or FlatnessThreshold are chosen. 0: both as given. Outline points
   * always stay. Unit: points. Range: at least 0. Default: 0.
   *
   * Thesis 6.2.
   */
  vtkHorizonNumberMacro(MaximumNumberOfPoints, int);

  /**
   * Barycentre: mean of the points of a cell, with mean attributes. NearestPoint: the point nearest to it in map view,
   * with its own attributes. Default: Barycentre.
   *
   * The thesis uses the barycentre.
   */
  vtkHorizonChoice2Macro(Representative, RepresentativeChoice, Barycentre, NearestPoint);

  /**
   * Output the cells as a wireframe, for inspection; array CellOrigin has their levels and rings. Default: off.
   */
  vtkHorizonFlagMacro(ShowCells);

protected:
  explicit vtkHorizonCellSimplification(int cellSize);
  ~vtkHorizonCellSimplification() override;

private:
  vtkHorizonCellSimplification(const vtkHorizonCellSimplification&) = delete;
  void operator=(const vtkHorizonCellSimplification&) = delete;

  int CellSize;
  int MaximumNumberOfPoints = 0;
  int Representative = Barycentre;
  bool ShowCells = false;
};

#endif
