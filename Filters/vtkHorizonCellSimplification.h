// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonCellSimplification
 * @brief   what the simplifications of the inside have in common
 *
 * Input: what vtkHorizonExteriorBoundary or vtkHorizonBoundarySimplification gives. Output: boundary points and loops
 * as they were, then the points that represent cells. PointCount is summed: it says how many points of the original
 * horizon each point represents. Where a point is the barycentre of several, arrays of floating point numbers and
 * VerticalIndex are averaged, weighted by PointCount; all other arrays are labels, and are taken from the nearest of
 * the points that were merged. VerticalIndex becomes an array of doubles.
 *
 * Point data added: CellOrigin (int, 3 components named Level, Ring, Kind): how many times the cell of the point was
 * halved; the ring of the cell, from 1 at the boundary, or 0 where cells have no rings; and whether the point is a
 * boundary point (0), the barycentre of several points (1) or a point of the input (2).
 *
 * With ShowCells the output is for inspection only: the cells as wireframe, with the cell data CellOrigin, CellSize
 * (double, lattice units), PatchId and PointCount (points of the input in it).
 *
 * @sa vtkHorizonRoughSimplification vtkHorizonElaborateSimplification
 */

#ifndef vtkHorizonCellSimplification_h
#define vtkHorizonCellSimplification_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class vtkFieldData;

namespace SeismicHorizons
{
struct BoundedHorizon;
struct Reduction;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonCellSimplification : public vtkHorizonAlgorithm
{
public:
  vtkTypeMacro(vtkHorizonCellSimplification, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The side of a cell (s of the thesis): of the squares of the rough simplification, where 1 keeps every point inside
   * the outline and 3 about one in nine, or of the cubes that the elaborate one halves. Unit: lattice units. Range: at
   * least 1. Default: 3 in vtkHorizonRoughSimplification, 8 in vtkHorizonElaborateSimplification.
   */
  vtkSetMacro(CellSize, int);
  vtkGetMacro(CellSize, int);
  ///@}

  ///@{
  /**
   * The largest number of points. The rough simplification uses the smallest cell size for it, the elaborate one a
   * FlatnessThreshold that leaves nearly as many, with larger or smaller cells if needed (thesis 6.2). The field data
   * have the choice (ChosenCellSize, ChosenFlatnessThreshold). 0: CellSize and FlatnessThreshold as given. Outline
   * points are always kept. Unit: points. Range: at least 0. Default: 0.
   */
  vtkSetMacro(MaximumNumberOfPoints, int);
  vtkGetMacro(MaximumNumberOfPoints, int);
  ///@}

  /// Values of Representative.
  enum RepresentativeChoice
  {
    Barycentre = 0,
    NearestPoint = 1
  };

  ///@{
  /**
   * The representative of the points of a cell. Barycentre: their mean, with mean attributes, as in the thesis.
   * NearestPoint: the point nearest to it on the map, with its own attributes, so that every output point is one of
   * the input. Default: Barycentre.
   */
  vtkSetClampMacro(Representative, int, Barycentre, NearestPoint);
  vtkGetMacro(Representative, int);
  void SetRepresentativeToBarycentre() { this->SetRepresentative(Barycentre); }
  void SetRepresentativeToNearestPoint() { this->SetRepresentative(NearestPoint); }
  ///@}

  ///@{
  /**
   * For inspection: the output is the cells as wireframe, squares at the mean height of their points, or cubes. The
   * cell data array CellOrigin has the halvings and the ring of each cell. Default: off.
   */
  vtkSetMacro(ShowCells, bool);
  vtkGetMacro(ShowCells, bool);
  vtkBooleanMacro(ShowCells, bool);
  ///@}

protected:
  explicit vtkHorizonCellSimplification(int cellSize)
    : CellSize(cellSize)
  {
  }
  ~vtkHorizonCellSimplification() override = default;

  /// Runs the method of the subclass on a horizon. Adds what was chosen for a number of points to the field data.
  virtual SeismicHorizons::Reduction Simplify(
    const SeismicHorizons::BoundedHorizon& horizon, vtkFieldData* chosen, const SeismicHorizons::Monitor& monitor) = 0;
  /// Whether cells are cubes, which are shown as boxes, or squares, which are shown flat.
  virtual bool HasCubes() const = 0;

  void ProcessHorizon(vtkPolyData* input, const Outputs& outputs, const SeismicHorizons::Monitor& monitor) final;

private:
  vtkHorizonCellSimplification(const vtkHorizonCellSimplification&) = delete;
  void operator=(const vtkHorizonCellSimplification&) = delete;

  int CellSize;
  int MaximumNumberOfPoints = 0;
  int Representative = Barycentre;
  bool ShowCells = false;
};

#endif
