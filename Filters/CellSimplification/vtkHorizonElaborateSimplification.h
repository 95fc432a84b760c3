// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonElaborateSimplification
 * @brief   thins a horizon where it is flat, in cells whose size changes gradually from the outline inwards
 *
 * Input and output: as of vtkHorizonCellSimplification. Use it after vtkHorizonRoughSimplification (the thesis's global
 * method), which makes it faster, or on its own.
 *
 * The points of each patch are sorted into cubes of CellSize lattice units, from the minimum corner of the bounding
 * box. Cubes are halved along all three axes as needed, and their octants again; both are called cells. A cell that is
 * not halved gives the barycentre of its points, or the point nearest to that (thesis 4.3.2, Alg. 4.2 and 4.3). Cubes
 * with boundary points are the first ring. They are halved until the boundary points in a cell are dense and far enough
 * apart; a large cell then keeps its boundary points and one point for the others, a small one its boundary points
 * alone. Each further ring is the cubes that touch the previous one. They are halved until the points in each cell are
 * flat, by principal component analysis, and no cell is larger than the mean of those of the previous ring.
 *
 * A barycentre that is not strictly inside the boundary, or in the place of another point, is replaced by the point
 * nearest to it. So points stay strictly inside, and no two share a place on the map.
 *
 * New point data: Flatness (double), as FlatnessThreshold measures it, of all points in the cell, boundary points
 * included. With ShowCells, it is cell data.
 *
 * Time is linear in the points and the cells of the bounding box; the result is bitwise identical for any number of
 * threads. Noise counts as curvature: small cells are not flat if points are off by a voxel.
 *
 * Errors: a parameter out of range, no boundary loops, no PatchId, or no lattice in the field data.
 *
 * @sa vtkHorizonRoughSimplification vtkHorizonBoundarySimplification vtkQuadricClustering
 */

#ifndef vtkHorizonElaborateSimplification_h
#define vtkHorizonElaborateSimplification_h

#include "vtkHorizonCellSimplification.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonElaborateSimplification : public vtkHorizonCellSimplification
{
public:
  static vtkHorizonElaborateSimplification* New();
  vtkTypeMacro(vtkHorizonElaborateSimplification, vtkHorizonCellSimplification);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Largest curvature of a flat cell. Smaller values keep more points; the thesis uses 0.03 to 0.20. Range: 0 to 1/3.
   * Default: 0.12.
   *
   * The least eigenvalue of the covariance of the points of a cell, divided by the sum of the three (thesis, eq. 4.5).
   */
  vtkHorizonNumberMacro(FlatnessThreshold, double);

  /**
   * Cells with outline points are halved until they have more per unit of edge length, and exceed
   * BoundaryExtentThreshold. Unit: points per lattice unit. Range: at least 0. Default: 0.25.
   *
   * PD of the thesis, eq. 4.2.
   */
  vtkHorizonNumberMacro(BoundaryDensityThreshold, double);

  /**
   * Cells with outline points are halved until two of them are farther apart, and BoundaryDensityThreshold is
   * exceeded. Unit: lattice units. Range: at least 0. Default: 2.
   *
   * d_max of the thesis, eq. 4.1 and 4.2.
   */
  vtkHorizonNumberMacro(BoundaryExtentThreshold, double);

  /**
   * Larger cells with outline points also keep one point for all others. Unit: lattice units. Range: at least 0.
   * Default: 2.
   */
  vtkHorizonNumberMacro(BoundaryCellSizeThreshold, double);

  /**
   * Cells are not halved below this size. Unit: lattice units. Range: at least 1. Default: 1.
   */
  vtkHorizonNumberMacro(SmallestCellSize, double);

  /**
   * What GrowthPerRing averages. OverCubes: cubes, each with the mean size of its cells. OverPieces: their cells, for
   * smaller cells inside. Default: OverCubes.
   *
   * OverCubes is eq. 4.3 of the thesis.
   */
  vtkHorizonChoice2Macro(NeighbourMean, NeighbourMeanChoice, OverCubes, OverPieces);

  /**
   * Largest growth of cells from ring to ring inwards. 1: none, as in the thesis. 2: double. Range: at least 1.
   * Default: 1.
   *
   * The size of a cell, divided by the mean of its neighbours one ring further out (thesis, eq. 4.3).
   *
   * Up to the nearest size that halving gives.
   */
  vtkHorizonNumberMacro(GrowthPerRing, double);

protected:
  vtkHorizonElaborateSimplification()
    : vtkHorizonCellSimplification(8)
  {
  }
  ~vtkHorizonElaborateSimplification() override = default;

  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonElaborateSimplification(const vtkHorizonElaborateSimplification&) = delete;
  void operator=(const vtkHorizonElaborateSimplification&) = delete;

  double FlatnessThreshold = 0.12;
  double BoundaryDensityThreshold = 0.25;
  double BoundaryExtentThreshold = 2.0;
  double BoundaryCellSizeThreshold = 2.0;
  double SmallestCellSize = 1.0;
  int NeighbourMean = OverCubes;
  double GrowthPerRing = 1.0;
};

#endif
