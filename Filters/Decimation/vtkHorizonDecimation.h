// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonDecimation
 * @brief   makes a mesh with few triangles, within an error of the horizon that you choose
 *
 * Input: the output of vtkHorizonExteriorBoundary or vtkHorizonBoundarySimplification, with points on whole columns.
 *
 * Output: the remaining vertices with the point arrays of the input, the boundary loops as polylines, and triangles
 * that face +z in the world. Every vertex is in the column of a point of the input; PointCount is the number of points
 * that it represents. New cell data, nan for polylines:
 *  - Compactness, Quality (float): as of vtkHorizonTriangulation;
 *  - Error (double): the largest vertical distance of a point inside a triangle or on its sides, and of these as far as
 *    they count for LargestLoopError, in lattice units.
 *
 * New field data, one value each, distances in lattice units:
 *  - LargestError, MeanError (double): vertical distances of all points from the mesh;
 *  - LargestEdgeError (double): the largest vertical distance of inner sides from the lines between neighbouring columns
 *    that they cross;
 *  - LargestLoopError (double): the largest vertical distance of loops from the lines between neighbouring columns that
 *    they cross, of inner sides from such lines to points that a boundary simplification dropped, and of loops from
 *    these points (OutlineHeightDeviation);
 *  - TriangleCount (vtkIdType), SmallestAngle (double, in degrees), on the map;
 *  - SliverCount (vtkIdType): triangles with an angle below the requested SmallestAngle, nearly all of them at
 *    outlines;
 *  - ChosenMaximumError (double), where MaximumError is automatic.
 *
 * With the Target LargestError no point is farther from the mesh than that, vertically, and no inner side of the mesh
 * is farther from the line between two neighbouring columns where it crosses that line. Fast: greedy insertion in
 * rounds (Garland and Heckbert 1995); the mesh is the constrained Delaunay triangulation of its vertices, seen from
 * above. Best: edges are then flipped and vertices removed, as long as the error is kept (Decimation.h).
 *
 * The result is the same for any number of threads. Time is near linear; memory beyond input and output is about 45
 * bytes per point and 12 per column of the bounding box of a patch.
 *
 * Errors: those of vtkHorizonTriangulation on loops, points off their columns or outside the loops, fewer points than
 * the loops have, or a parameter out of range.
 *
 * @sa vtkHorizonBoundarySimplification vtkHorizonTriangulation vtkHorizonSurfaceDistance
 */

#ifndef vtkHorizonDecimation_h
#define vtkHorizonDecimation_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonReducedMesh.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonDecimation : public vtkHorizonReducedMesh
{
public:
  static vtkHorizonDecimation* New();
  vtkTypeMacro(vtkHorizonDecimation, vtkHorizonReducedMesh);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What limits the mesh: MaximumError, MaximumNumberOfPoints or TargetReduction. Default: LargestError.
   */
  vtkHorizonChoice3Macro(Target, Targets, LargestError, NumberOfPoints, Reduction);

  /**
   * Largest number of points per horizon, outlines included. Unit: points. Range: at least 1. Default: 10000.
   */
  vtkHorizonNumberMacro(MaximumNumberOfPoints, int);

  /**
   * Fraction of points to drop per horizon; 0.95 keeps one in twenty. Unit: fraction of the points. Range: 0 to 1.
   * Default: 0.95.
   */
  vtkHorizonNumberMacro(TargetReduction, double);

protected:
  vtkHorizonDecimation() = default;
  ~vtkHorizonDecimation() override = default;

  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonDecimation(const vtkHorizonDecimation&) = delete;
  void operator=(const vtkHorizonDecimation&) = delete;

  int Target = LargestError;
  int MaximumNumberOfPoints = 10000;
  double TargetReduction = 0.95;
};

#endif
