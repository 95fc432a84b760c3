// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonBoundarySimplification
 * @brief   drops points from straight stretches of the outlines of a horizon
 *
 * Input: the output of vtkHorizonExteriorBoundary. Output: the same with fewer points on the outlines. Points that come
 * to lie outside the new outlines, or on them, leave the horizon; their PointCount goes to the nearer end of the edge
 * that spans them. Points that come to lie inside stay, with the Boundary 0. New field data, one value each:
 *  - OutlineDeviation (double): the largest distance on the map, in columns, of a point that was on an outline to the
 *    edge that spans it; 0 without an OutlineTolerance;
 *  - BoundaryDeviation (double): the same in space, in lattice units;
 *  - OutlineHeightDeviation (double): the largest vertical distance, in lattice units, of a point that left the horizon
 *    to the edge that spans it, where that is nearest on the map;
 *  - NumberOfOutsidePoints (vtkIdType): points outside the new outlines.
 *
 * Threshold (thesis 3.4, Alg. 3.3): a loop is divided into runs that are straight seen from above. In a run, the middle
 * one of three successive points is dropped if its distance in space from the line through the others is less than
 * DistanceThreshold, pass after pass. The outline on the map does not change. The ends of runs, the points of spurs,
 * and those where loops touch stay. With an OutlineTolerance corners are dropped, too, if all points that the new edge
 * spans are within the tolerance of it on the map, the corner is less than DistanceThreshold above or below it, and no
 * other point of the horizon lies between the new edge and the old ones.
 *
 * FewestPoints: each loop gets the fewest points for which all dropped points are within OutlineTolerance of the edge
 * that spans them on the map, and at most DistanceThreshold above or below it: a shortest path over all possible edges
 * (Imai and Iri 1988; FewestPoints.h). The same points stay as above. The number is the least for a given start, unless
 * edges could span more than 512 points, or a run of more than 64 points is straight in space.
 *
 * Loops never cross, and points inside stay strictly inside.
 *
 * @warning Without BoundDeviation the threshold holds for each single step; BoundaryDeviation is what the steps add up
 * to. Without an OutlineTolerance, slanted outlines are staircases without straight runs, and stay.
 *
 * Errors: a negative threshold or tolerance, no boundary loops, no lattice in the field data; with FewestPoints, points
 * off their columns.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonRoughSimplification
 */

#ifndef vtkHorizonBoundarySimplification_h
#define vtkHorizonBoundarySimplification_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonBoundarySimplification : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonBoundarySimplification* New();
  vtkTypeMacro(vtkHorizonBoundarySimplification, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Threshold: drops points close to the line through their neighbours. FewestPoints: drops as many as
   * OutlineTolerance and DistanceThreshold allow. Default: Threshold.
   *
   * Threshold is the method of the thesis.
   */
  vtkHorizonChoice2Macro(Method, MethodType, Threshold, FewestPoints);

  /**
   * Points closer to the line through their neighbours are dropped. With FewestPoints: largest vertical distance of a
   * dropped point from the new outline. Unit: lattice units. Range: at least 0. Default: 0.4.
   *
   * This is t of the thesis.
   */
  vtkHorizonNumberMacro(DistanceThreshold, double);

  /**
   * Keep dropped points within DistanceThreshold vertically of the final outline, as FewestPoints does. Off:
   * deviations can add up. Default: off.
   */
  vtkHorizonFlagMacro(BoundDeviation);

  /**
   * Largest distance in map view of a dropped point from the new outline. 0: the shape stays; about 0.5 and more:
   * lattice staircases become straight. Unit: columns. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(OutlineTolerance, double);

protected:
  vtkHorizonBoundarySimplification() = default;
  ~vtkHorizonBoundarySimplification() override = default;

  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonBoundarySimplification(const vtkHorizonBoundarySimplification&) = delete;
  void operator=(const vtkHorizonBoundarySimplification&) = delete;

  int Method = Threshold;
  double DistanceThreshold = 0.4;
  bool BoundDeviation = false;
  double OutlineTolerance = 0.0;
};

#endif
