// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonReducedMesh
 * @brief   what the filters that give a mesh of few triangles within an error have in common
 *
 * How far the mesh may be from the horizon, and how much is done for few triangles.
 *
 * @sa vtkHorizonDecimation vtkHorizonSurface
 */

#ifndef vtkHorizonReducedMesh_h
#define vtkHorizonReducedMesh_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <vector> // for places and heights

namespace SeismicHorizons
{
class Lattice;
struct DecimationQuality;
struct PlanePoint;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonReducedMesh : public vtkHorizonAlgorithm
{
public:
  vtkTypeMacro(vtkHorizonReducedMesh, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The largest vertical distance of a point from the mesh, in ErrorUnit; at least 0. For horizons of whole voxels,
   * whose heights are rounded by up to half a voxel, 0.75 brings the mesh nearest to what was rounded. Default: 0.75.
   */
  vtkSetMacro(MaximumError, double);
  vtkGetMacro(MaximumError, double);
  ///@}

  /// The unit of MaximumError.
  enum ErrorUnits
  {
    Lattice = 0,
    World = 1,
    Diagonal = 2
  };

  ///@{
  /**
   * The unit of MaximumError: Lattice (1 is one vertical index), World (that of z), or Diagonal (1 is the diagonal of
   * the bounding box of the horizon, in lattice units). Default: Lattice.
   */
  vtkSetClampMacro(ErrorUnit, int, Lattice, Diagonal);
  vtkGetMacro(ErrorUnit, int);
  void SetErrorUnitToLattice() { this->SetErrorUnit(Lattice); }
  void SetErrorUnitToWorld() { this->SetErrorUnit(World); }
  void SetErrorUnitToDiagonal() { this->SetErrorUnit(Diagonal); }
  ///@}

  ///@{
  /**
   * Whether heights of vertices inside are fitted to the points around them, which takes fewer vertices for the same
   * error; attributes are then averaged. Off: every vertex is a point of the input with its attributes. Default: on.
   */
  vtkSetMacro(FitHeights, bool);
  vtkGetMacro(FitHeights, bool);
  vtkBooleanMacro(FitHeights, bool);
  ///@}

  /// How much is done for few points.
  enum Efforts
  {
    Fast = 0,
    Best = 1
  };

  ///@{
  /**
   * How much is done for few points. Fast: points are inserted where the mesh is farthest from the horizon. Best: then
   * edges are flipped, heights fitted and vertices removed, which takes some times as long and a quarter to a half
   * fewer points for an error, or a smaller mean error for a number of points. Default: Best.
   */
  vtkSetClampMacro(Effort, int, Fast, Best);
  vtkGetMacro(Effort, int);
  void SetEffortToFast() { this->SetEffort(Fast); }
  void SetEffortToBest() { this->SetEffort(Best); }
  ///@}

  /// Which error becomes small where the target is a number.
  enum Priorities
  {
    LargestErrors = 0,
    SumOfSquares = 1
  };

  ///@{
  /**
   * With another target than LargestError, which error becomes small: the largest one (LargestErrors), or the sum of
   * the squares of all (SumOfSquares), and with it the mean. Default: SumOfSquares.
   */
  vtkSetClampMacro(Priority, int, LargestErrors, SumOfSquares);
  vtkGetMacro(Priority, int);
  void SetPriorityToLargestErrors() { this->SetPriority(LargestErrors); }
  void SetPriorityToSumOfSquares() { this->SetPriority(SumOfSquares); }
  ///@}

  ///@{
  /**
   * With the Effort Best, in degrees, seen from above on the lattice, from 0 to 60: no flip and no removal makes a
   * smaller angle, but where there was a smaller one before. Large ones take more points. Default: 2.
   */
  vtkSetMacro(SmallestAngle, double);
  vtkGetMacro(SmallestAngle, double);
  ///@}

  ///@{
  /**
   * Whether cracks of cut links (vtkHorizonFaults) are closed by triangles between their lips. These come last, with 1
   * in the new cell data array Fault, 0 of all other cells, and share the vertices of the lips; all else is as without
   * them, and no other figure or array counts them: the new FaultTriangleCount (vtkIdType) tells how many there are.
   * Gaps of missing points stay open. Default: off.
   */
  vtkSetMacro(CloseFaults, bool);
  vtkGetMacro(CloseFaults, bool);
  vtkBooleanMacro(CloseFaults, bool);
  ///@}

protected:
  vtkHorizonReducedMesh() = default;
  ~vtkHorizonReducedMesh() override = default;

  SeismicHorizons::DecimationQuality MakeQuality() const;
  /// MaximumError in lattice units, for a horizon with these places, in sub-voxels, and heights.
  double FindMaximumError(const std::vector<SeismicHorizons::PlanePoint>& plane, const std::vector<double>& height,
    const SeismicHorizons::Lattice& grid) const;

private:
  vtkHorizonReducedMesh(const vtkHorizonReducedMesh&) = delete;
  void operator=(const vtkHorizonReducedMesh&) = delete;

  double MaximumError = 0.75;
  int ErrorUnit = Lattice;
  bool FitHeights = true;
  int Effort = Best;
  int Priority = SumOfSquares;
  double SmallestAngle = 2.0;
  bool CloseFaults = false;
};

#endif
