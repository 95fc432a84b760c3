// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonReducedMesh
 * @brief   base class of filters that make a mesh with few triangles within an error
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
   * Largest vertical distance of horizon points from the mesh. -1: automatic, six times the noise. 0.75 is best for
   * heights in whole voxels. Unit: ErrorUnit. Range: at least 0, or -1. Default: -1.
   */
  vtkHorizonNumberMacro(MaximumError, double);

  /**
   * Unit of MaximumError. Steps: vertical index (voxel). World: unit of z. Diagonal: bounding-box diagonal in
   * lattice units. Default: Steps.
   */
  vtkHorizonChoice3Macro(ErrorUnit, ErrorUnits, Steps, World, Diagonal);

  /**
   * Fit heights of inner vertices to nearby points, for fewer vertices. Off: vertices are points of the horizon, with
   * their attributes. Default: on.
   */
  vtkHorizonFlagMacro(FitHeights);

  /**
   * How thoroughly the mesh is optimised. Best needs half as many points as Fast, or fewer, in two to four times the
   * time. Default: Best.
   *
   * Fast inserts points where the mesh is farthest from the horizon; Best then removes and moves vertices and flips
   * edges.
   */
  vtkHorizonChoice2Macro(Effort, Efforts, Fast, Best);

  /**
   * Error to minimise unless Target is LargestError. LargestErrors: the largest. SumOfSquares: the sum of squares, and
   * so the mean. Default: SumOfSquares.
   */
  vtkHorizonChoice2Macro(Priority, Priorities, LargestErrors, SumOfSquares);

  /**
   * Smallest angle in map view that optimisation may create. Within an error, points are added at sharper ones: all
   * with the effort Fast, below 2 degrees with Best. 5: 5 % more points; 10: 20 %. Unit: degrees. Range: 0 to 60.
   * Default: 2.
   *
   * Angles are measured on the lattice. A change may leave a smaller angle where there was a smaller one before.
   */
  vtkHorizonNumberMacro(SmallestAngle, double);

  /**
   * For even, near-equilateral triangles within an error: longest inner edge, less where the error requires it. Angles
   * are at least 25 degrees unless outlines prevent it; Effort has no effect. 0: off. Unit: columns. Range: 0, or at
   * least 4. Default: 0.
   */
  vtkHorizonNumberMacro(EdgeLength, double);

  /**
   * Growth of edges per distance from outlines and faults, from at most three columns up to EdgeLength. 0: EdgeLength
   * everywhere. Range: 0 to 1. Default: 0.
   */
  vtkHorizonNumberMacro(EdgeGrowth, double);

  /**
   * Vertical error of inner edges between columns. Same: that of points. Twice: double, for fewer points on most
   * horizons. Unbounded: still fewer, but spikes between columns. Default: Same.
   *
   * Measured where an edge crosses the line between two neighbouring columns.
   */
  vtkHorizonChoice3Macro(CrossingTolerance, CrossingTolerances, Same, Twice, Unbounded);

  /**
   * Close cracks at faults with steep triangles (1 in array Fault). See "Closed meshes" in HorizonFaults.md. Default:
   * off.
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
  int ErrorUnit = Steps;
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
