// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonBoundarySimplification
 * @brief   drops points from straight stretches of the outlines of a horizon
 *
 * Input: what vtkHorizonExteriorBoundary gives. Output: the same with fewer points on the outlines. Those that the new
 * outlines leave outside, or pass through, leave the horizon; their PointCount goes to the nearer end of the edge that
 * now spans them. Those that come to lie inside stay, with the Boundary 0. New field data, one value each:
 *  - OutlineDeviation (double): the largest distance in plan, in columns, of a point that was on the outlines to the
 *    edge that spans it; 0 when OutlineTolerance is;
 *  - BoundaryDeviation (double): the same in space, in lattice units;
 *  - OutlineHeightDeviation (double): the largest vertical distance, in lattice units, of a point that left the horizon
 *    to the edge that spans it, where that is nearest in plan;
 *  - NumberOfOutsidePoints (vtkIdType): how many points the new outlines leave outside.
 *
 * A loop is split into runs that are straight seen from above; the ends of a run stay. Within a run the middle one of
 * three points in succession is dropped when its distance in space from the line through the other two is less than
 * DistanceThreshold, pass after pass until nothing is dropped (thesis 3.4, Alg. 3.3). So the outline seen from above
 * does not change at all. Points where a loop touches itself or another one, and the points of spurs, stay. Loops of
 * holes are treated in the same way.
 *
 * With an OutlineTolerance corners are dropped too: when all points that the new edge spans are within the tolerance of
 * it in plan, the corner is less than DistanceThreshold above or below it, and no other point of the horizon lies
 * between the new edge and the two old ones. So loops never cross themselves or each other, and points inside stay
 * strictly inside.
 *
 * With the Method FewestPoints every loop gets the fewest points for which all dropped points are within
 * OutlineTolerance of the edge that spans them, seen from above, and not more than DistanceThreshold above or below it
 * (a shortest path over all edges that can be; FewestPoints.h; Imai and Iri 1988). The same points stay as above, and
 * of a loop without any such point one that stays when its first does: with that, no loop could have fewer points, as
 * long as no edge could span more than 512 and no run of more than 64 is straight in space; otherwise the number is
 * near the least.
 *
 * @warning Without BoundDeviation the threshold holds for each single step. Over many passes distances add up, and the
 * largest can exceed it: BoundaryDeviation says by how much. Without an OutlineTolerance outlines that run slantwise
 * over the lattice are staircases without straight runs, and stay as they are.
 *
 * Errors: a threshold or tolerance below 0, no boundary loops, no lattice in the field data; with FewestPoints points
 * beside their columns.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonRoughSimplification
 */

#ifndef vtkHorizonBoundarySimplification_h
#define vtkHorizonBoundarySimplification_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonBoundarySimplification : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonBoundarySimplification* New();
  vtkTypeMacro(vtkHorizonBoundarySimplification, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Method.
  enum MethodType
  {
    Threshold = 0,
    FewestPoints = 1
  };

  ///@{
  /**
   * Which points are dropped. Threshold: one after the other, if near enough to the line through their neighbours, as
   * in the thesis. FewestPoints: as many as OutlineTolerance and DistanceThreshold allow. Default: Threshold.
   */
  vtkSetClampMacro(Method, int, Threshold, FewestPoints);
  vtkGetMacro(Method, int);
  void SetMethodToThreshold() { this->SetMethod(Threshold); }
  void SetMethodToFewestPoints() { this->SetMethod(FewestPoints); }
  ///@}

  ///@{
  /**
   * A point is dropped if it is nearer than this to the line through its neighbours (t of the thesis). With
   * FewestPoints: the largest height of a dropped point above or below the new outline. Unit: lattice units. Range: at
   * least 0. Default: 0.4.
   */
  vtkSetMacro(DistanceThreshold, double);
  vtkGetMacro(DistanceThreshold, double);
  ///@}

  ///@{
  /**
   * Whether dropped points stay within DistanceThreshold above or below the final outline. Off: only of the line when
   * they are dropped, so that deviations add up. FewestPoints always does this. Default: off.
   */
  vtkSetMacro(BoundDeviation, bool);
  vtkGetMacro(BoundDeviation, bool);
  vtkBooleanMacro(BoundDeviation, bool);
  ///@}

  ///@{
  /**
   * The largest distance of a dropped point from the new outline on the map. 0 keeps the outline on the map; from about
   * 0.5, staircases of the lattice become straight lines. Unit: columns. Range: at least 0. Default: 0.
   */
  vtkSetMacro(OutlineTolerance, double);
  vtkGetMacro(OutlineTolerance, double);
  ///@}

protected:
  vtkHorizonBoundarySimplification() = default;
  ~vtkHorizonBoundarySimplification() override = default;

  void ProcessHorizon(vtkPolyData* input, const Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonBoundarySimplification(const vtkHorizonBoundarySimplification&) = delete;
  void operator=(const vtkHorizonBoundarySimplification&) = delete;

  int Method = Threshold;
  double DistanceThreshold = 0.4;
  bool BoundDeviation = false;
  double OutlineTolerance = 0.0;
};

#endif
