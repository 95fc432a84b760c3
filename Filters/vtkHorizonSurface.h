// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSurface
 * @brief   makes a mesh of few triangles from the points of a horizon, with automatically chosen parameters
 *
 * Input: what vtkHorizonExteriorBoundary takes. Output 0: the mesh, as vtkHorizonDecimation gives it. Output 1: the
 * outlines over all points, as vtkHorizonExteriorBoundary gives them: what to measure the mesh against.
 *
 * The filter does what vtkHorizonExteriorBoundary, vtkHorizonBoundarySimplification (FewestPoints) and
 * vtkHorizonDecimation do one after the other, with the same result to the byte, and without data in between. You
 * choose how far the mesh may be from the horizon (outlines may be as far off sideways), or how many triangles it may
 * have; the rest follows from that and from the points, unless you switch it off (Automatic...). What was chosen is new
 * field data of the mesh, one value each, with which the single stages give the same:
 *  - ChosenRadius (int), ChosenSmallestHoleSize (vtkIdType, columns);
 *  - ChosenOutlineTolerance (double, columns), ChosenDistanceThreshold (double, lattice units);
 *  - ChosenMaximumError (double, lattice units): the error of the mesh, or, with NumberOfTriangles, the one that the
 *    outlines were simplified for (0 when they had tolerances of their own);
 *  - ChosenMaximumNumberOfPoints (vtkIdType): with NumberOfTriangles the number of points that the mesh was decimated
 *    to; else 0.
 *
 * With NumberOfTriangles, an error is searched for which a mesh of the effort Fast has about that many triangles: ten
 * meshes at most. Outlines are simplified for that error, and the mesh then gets as many points inside as the number
 * leaves. It never has more triangles than that.
 *
 * With the effort Best and a SmallestAngle above 0, outlines keep points beside which a first mesh of the effort Fast has
 * slivers, which the single stages cannot know of: with a SmallestAngle of 0 the results are the same. This takes a
 * quarter of the time, half on very rough horizons.
 *
 * On several threads, with the same result on any number of them. Near linear; about 50 bytes per point and 12
 * per column of the bounding box of a patch beyond the input, output included.
 *
 * Errors: those of the three stages; fewer triangles than the outlines take alone.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonBoundarySimplification vtkHorizonDecimation vtkHorizonSurfaceDistance
 */

#ifndef vtkHorizonSurface_h
#define vtkHorizonSurface_h

#include "vtkHorizonReducedMesh.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

namespace SeismicHorizons
{
struct LatticePoints;
struct SeamRows;
struct SurfaceOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonSurface : public vtkHorizonReducedMesh
{
public:
  static vtkHorizonSurface* New();
  vtkTypeMacro(vtkHorizonSurface, vtkHorizonReducedMesh);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Target.
  enum Targets
  {
    LargestError = 0,
    NumberOfTriangles = 1
  };

  ///@{
  /**
   * What limits the number of triangles. LargestError: MaximumError. NumberOfTriangles: MaximumNumberOfTriangles.
   * Default: LargestError.
   */
  vtkSetClampMacro(Target, int, LargestError, NumberOfTriangles);
  vtkGetMacro(Target, int);
  void SetTargetToLargestError() { this->SetTarget(LargestError); }
  void SetTargetToNumberOfTriangles() { this->SetTarget(NumberOfTriangles); }
  ///@}

  ///@{
  /**
   * The largest number of triangles of each horizon, enough for its outlines. Unit: triangles. Range: at least 1.
   * Default: 20000.
   */
  vtkSetMacro(MaximumNumberOfTriangles, int);
  vtkGetMacro(MaximumNumberOfTriangles, int);
  ///@}

  ///@{
  /**
   * Whether the radius is chosen, by the steps from point to point. Off: Radius. See "What is chosen" in
   * HorizonSurface.md. Default: on.
   */
  vtkSetMacro(AutomaticRadius, bool);
  vtkGetMacro(AutomaticRadius, bool);
  vtkBooleanMacro(AutomaticRadius, bool);
  ///@}

  ///@{
  /**
   * Without AutomaticRadius, the largest hop of outlines along each axis. Unit: columns. Range: 1 to 32. Default: 1.
   */
  vtkSetMacro(Radius, int);
  vtkGetMacro(Radius, int);
  ///@}

  /// Values of GrowthStrategy.
  enum GrowthStrategies
  {
    Distance = 0,
    Clockwise = 1
  };

  ///@{
  /**
   * How outlines continue where the radius leaves a choice, as in vtkHorizonExteriorBoundary. Distance: from neighbour
   * to neighbour. Clockwise: by the outermost hop. Default: Clockwise.
   */
  vtkSetClampMacro(GrowthStrategy, int, Distance, Clockwise);
  vtkGetMacro(GrowthStrategy, int);
  void SetGrowthStrategyToDistance() { this->SetGrowthStrategy(Distance); }
  void SetGrowthStrategyToClockwise() { this->SetGrowthStrategy(Clockwise); }
  ///@}

  ///@{
  /**
   * Whether holes stay open unless too small. Off: all are closed. Default: on.
   */
  vtkSetMacro(HoleBoundaries, bool);
  vtkGetMacro(HoleBoundaries, bool);
  vtkBooleanMacro(HoleBoundaries, bool);
  ///@}

  ///@{
  /**
   * Whether faults (field data CutLinks) split the horizon. Off: faults are ignored from here on. See "Faults" in
   * HorizonExteriorBoundary.md. Default: on.
   *
   * Off: the outputs have no CutLinks.
   */
  vtkSetMacro(UseCuts, bool);
  vtkGetMacro(UseCuts, bool);
  vtkBooleanMacro(UseCuts, bool);
  ///@}

  ///@{
  /**
   * Whether the smallest hole that stays open is chosen, by the radius and the outline tolerance. Off:
   * SmallestHoleSize. Default: on.
   */
  vtkSetMacro(AutomaticSmallestHoleSize, bool);
  vtkGetMacro(AutomaticSmallestHoleSize, bool);
  vtkBooleanMacro(AutomaticSmallestHoleSize, bool);
  ///@}

  ///@{
  /**
   * Without AutomaticSmallestHoleSize, holes with fewer columns strictly inside are closed. Unit: columns. Range: at
   * least 1. Default: 1.
   */
  vtkSetMacro(SmallestHoleSize, int);
  vtkGetMacro(SmallestHoleSize, int);
  ///@}

  ///@{
  /**
   * Patches of fewer points are dropped. Unit: points. Range: at least 1. Default: 1.
   */
  vtkSetMacro(MinimumPatchSize, int);
  vtkGetMacro(MinimumPatchSize, int);
  ///@}

  ///@{
  /**
   * Whether the tolerance of outlines on the map, in columns, is the error of the mesh. Off: OutlineTolerance.
   * Default: on.
   */
  vtkSetMacro(AutomaticOutlineTolerance, bool);
  vtkGetMacro(AutomaticOutlineTolerance, bool);
  vtkBooleanMacro(AutomaticOutlineTolerance, bool);
  ///@}

  ///@{
  /**
   * Without AutomaticOutlineTolerance, the largest distance on the map of a dropped point from its outline. Unit:
   * columns. Range: at least 0. Default: 0.
   */
  vtkSetMacro(OutlineTolerance, double);
  vtkGetMacro(OutlineTolerance, double);
  ///@}

  ///@{
  /**
   * Whether the vertical tolerance of outlines is the error of the mesh. Off: DistanceThreshold. Default: on.
   */
  vtkSetMacro(AutomaticDistanceThreshold, bool);
  vtkGetMacro(AutomaticDistanceThreshold, bool);
  vtkBooleanMacro(AutomaticDistanceThreshold, bool);
  ///@}

  ///@{
  /**
   * Without AutomaticDistanceThreshold, the largest vertical distance of a dropped point from its outline. Unit:
   * lattice units. Range: at least 0. Default: 0.4.
   */
  vtkSetMacro(DistanceThreshold, double);
  vtkGetMacro(DistanceThreshold, double);
  ///@}

  ///@{
  /**
   * For a part that vtkHorizonSurfaceJoin joins: the rows of the lattice, below and above, that it shares with other
   * parts; -1 for none. Unit: rows. Range: at least -1. Default: -1, -1.
   *
   * The parts on both sides have the points of such a row (j), and this part none beyond. The target is the error then,
   * not of unit Diagonal, holes have boundaries, MinimumPatchSize is 1 and growth clockwise where the radius is not 1.
   * The mesh has two arrays more: SeamRows (int, 2 components), these rows, as field data, and SeamGap (unsigned char)
   * at points, 1 to the left of gaps along a seam that are not filled. PointCount leaves out the points of the row
   * below.
   */
  vtkSetVector2Macro(SeamRows, int);
  vtkGetVector2Macro(SeamRows, int);
  ///@}

  /**
   * The radius that AutomaticRadius chooses for the points of a horizon, to be given to all its parts; 0 for none, and,
   * after an error, for points that are not on a lattice.
   */
  int ChooseRadius(vtkPolyData* horizon);

protected:
  vtkHorizonSurface();
  ~vtkHorizonSurface() override = default;

  void ProcessHorizon(vtkPolyData* input, const Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonSurface(const vtkHorizonSurface&) = delete;
  void operator=(const vtkHorizonSurface&) = delete;

  SeismicHorizons::SurfaceOptions MakeOptions(const SeismicHorizons::LatticePoints& points) const;
  SeismicHorizons::SeamRows MakeSeams();

  int Target = LargestError;
  int MaximumNumberOfTriangles = 20000;
  bool AutomaticRadius = true;
  int Radius = 1;
  int GrowthStrategy = Clockwise;
  bool HoleBoundaries = true;
  bool UseCuts = true;
  bool AutomaticSmallestHoleSize = true;
  int SmallestHoleSize = 1;
  int MinimumPatchSize = 1;
  bool AutomaticOutlineTolerance = true;
  double OutlineTolerance = 0.0;
  bool AutomaticDistanceThreshold = true;
  double DistanceThreshold = 0.4;
  int SeamRows[2] = { -1, -1 };
};

#endif
