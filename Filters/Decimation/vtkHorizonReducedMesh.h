// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonReducedMesh
 * @brief   what the filters that make a mesh of few triangles within an error have in common
 *
 * How far the mesh may be from the horizon, and how much is done for few triangles. Its properties are on
 * HorizonSurface.md.
 *
 * @sa vtkHorizonDecimation vtkHorizonSurface
 */

#ifndef vtkHorizonReducedMesh_h
#define vtkHorizonReducedMesh_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

namespace SeismicHorizons
{
struct ReducedMeshOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonReducedMesh : public vtkHorizonAlgorithm
{
public:
  vtkTypeMacro(vtkHorizonReducedMesh, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The largest vertical distance of a point of the horizon from the mesh. -1: automatic, six times the noise of the
   * heights. For heights in whole voxels, 0.75 comes nearest to the true surface. Unit: ErrorUnit. Range: at least 0, or
   * -1. Default: -1.
   */
  vtkHorizonNumberMacro(MaximumError, double);

  /**
   * The unit of MaximumError. Lattice: one vertical index, a voxel. World: the unit of z. Diagonal: the diagonal of the
   * bounding box, in lattice units. Default: Lattice.
   */
  vtkHorizonChoice3Macro(ErrorUnit, ErrorUnits, Lattice, World, Diagonal);

  /**
   * Whether heights of inner vertices are fitted to the points around them, for fewer vertices. Off: every vertex is a
   * point of the horizon, with its attributes. Default: on.
   */
  vtkHorizonFlagMacro(FitHeights);

  /**
   * How thoroughly the mesh is optimised. Fast: points are inserted where the mesh is farthest from the horizon. Best:
   * vertices are then removed or moved and edges flipped, which needs half as many points or fewer, and two to four times
   * the time. Default: Best.
   */
  vtkHorizonChoice2Macro(Effort, Efforts, Fast, Best);

  /**
   * Which error is minimised unless the target is LargestError. LargestErrors: the largest one. SumOfSquares: the sum
   * of squares, and with it the mean. Default: SumOfSquares.
   */
  vtkHorizonChoice2Macro(Priority, Priorities, LargestErrors, SumOfSquares);

  /**
   * No flip or removal makes a smaller angle, seen from above on the lattice, unless a smaller one was there before.
   * Within an error, points are inserted beside smaller ones: all with the effort Fast, those below 2 degrees with Best.
   * Larger values need more points: 5 one in twenty, 10 one in five. Unit: degrees. Range: 0 to 60. Default: 2.
   */
  vtkHorizonNumberMacro(SmallestAngle, double);

  /**
   * For an even mesh within an error, as simulators need it: the longest inner edge. Triangles are near equilateral, and
   * smaller where the error takes that; angles are at least 25 degrees unless outlines leave less. The effort does not
   * matter then. 0: as long as the error allows, for few triangles. Unit: columns. Range: 0, or at least 4. Default: 0.
   */
  vtkHorizonNumberMacro(EdgeLength, double);

  /**
   * With an EdgeLength, edges beside outlines and faults are at most three columns long, and grow by this part of the
   * distance from them. 0: they have the EdgeLength everywhere. Range: 0 to 1. Default: 0.
   */
  vtkHorizonNumberMacro(EdgeGrowth, double);

  /**
   * How far inner edges may be, vertically, from the line between two neighbouring columns where they cross it. Same: as
   * far as points. Twice: twice as far, for 5 to 9 % fewer points. Unbounded: triangles between columns may stand up like
   * spikes, for 5 to 15 % fewer points. Default: Same.
   */
  vtkHorizonChoice3Macro(CrossingTolerance, CrossingTolerances, Same, Twice, Unbounded);

  /**
   * Whether steep triangles, with 1 in the array Fault, close the cracks at faults. See "Closed meshes" in
   * HorizonFaults.md. Default: off.
   *
   * These triangles come last in the new cell data array Fault, 0 elsewhere, and share the vertices of the crack. No
   * other figure or array counts them; the new FaultTriangleCount (vtkIdType) has their number.
   */
  vtkHorizonFlagMacro(CloseFaults);

protected:
  vtkHorizonReducedMesh() = default;
  ~vtkHorizonReducedMesh() override = default;

  bool TakesMeshes() override { return true; }

  /// For other targets, there is no EdgeLength.
  SeismicHorizons::ReducedMeshOptions MakeMeshOptions(bool isWithinError) const;

private:
  vtkHorizonReducedMesh(const vtkHorizonReducedMesh&) = delete;
  void operator=(const vtkHorizonReducedMesh&) = delete;

  double MaximumError = -1.0;
  int ErrorUnit = Lattice;
  bool FitHeights = true;
  int Effort = Best;
  int Priority = SumOfSquares;
  double SmallestAngle = 2.0;
  double EdgeLength = 0.0;
  double EdgeGrowth = 0.0;
  int CrossingTolerance = Same;
  bool CloseFaults = false;
};

#endif
