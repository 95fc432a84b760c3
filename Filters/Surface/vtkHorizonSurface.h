// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSurface
 * @brief   makes a mesh with few triangles from the points of a horizon, with automatic parameters
 *
 * Input: as of vtkHorizonExteriorBoundary. Output 0: the mesh, as of vtkHorizonDecimation. Output 1: the outlines over
 * all points, as of vtkHorizonExteriorBoundary, for measuring the mesh against them.
 *
 * You choose how far the mesh may be from the horizon (outlines may be as far off sideways), or how many triangles it
 * may have; the rest follows from that and from the points, unless you switch it off (Automatic...). The result is
 * bitwise identical to running vtkHorizonExteriorBoundary, vtkHorizonBoundarySimplification (FewestPoints) and
 * vtkHorizonDecimation in sequence with the chosen parameters, which are field data of the mesh, one value each:
 *  - ChosenRadius (int), ChosenSmallestHoleSize (vtkIdType, columns);
 *  - ChosenOutlineTolerance (double, columns), ChosenDistanceThreshold (double, lattice units);
 *  - ChosenMaximumError (double, lattice units): the error of the mesh, or, with NumberOfTriangles, the one that
 *    outlines were simplified for (0 if their tolerances were given);
 *  - ChosenMaximumNumberOfPoints (vtkIdType): with NumberOfTriangles the number of points of the decimation, else 0.
 *
 * With NumberOfTriangles, outlines are simplified for an error that is expected to leave about that many triangles, from
 * the distances at which points are inserted into a first mesh, and inner points are added up to the number.
 *
 * With a SmallestAngle above 0, outlines also keep points beside slivers of a first mesh of the effort Fast, and with a
 * bound of CrossingTolerance those on lines that its edges cross too far away; so they do in the search for the
 * largest error. Otherwise the mesh is that of the single stages.
 *
 * Horizons of more than about 8.4 million columns are meshed in bands of rows (see "Large horizons" in
 * HorizonSurface.md), which leaves about as many triangles.
 *
 * The result is the same for any number of threads. Time is near linear; memory beyond the input is about 50 bytes per
 * point and 12 per column of the bounding box of a patch.
 *
 * Errors: those of the three stages, and fewer triangles than the outlines need.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonBoundarySimplification vtkHorizonDecimation vtkHorizonSurfaceDistance
 */

#ifndef vtkHorizonSurface_h
#define vtkHorizonSurface_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonReducedMesh.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

namespace SeismicHorizons
{
class PartRanks;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonSurface : public vtkHorizonReducedMesh
{
public:
  static vtkHorizonSurface* New();
  vtkTypeMacro(vtkHorizonSurface, vtkHorizonReducedMesh);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What limits the mesh: MaximumError or MaximumNumberOfTriangles. Default: LargestError.
   */
  vtkHorizonChoice2Macro(Target, Targets, LargestError, NumberOfTriangles);

  /**
   * Largest number of triangles per horizon. Must suffice for the outlines. Unit: triangles. Range: at least 1.
   * Default: 20000.
   */
  vtkHorizonNumberMacro(MaximumNumberOfTriangles, int);

  /**
   * Choose the radius from the spacing of points. Off: Radius. See "Automatic parameters" in HorizonSurface.md.
   * Default: on.
   */
  vtkHorizonFlagMacro(AutomaticRadius);

  /**
   * Largest hop of outlines along each axis, without AutomaticRadius. Unit: columns. Range: 1 to 32. Default: 1.
   */
  vtkHorizonNumberMacro(Radius, int);

  /**
   * How outlines run with a radius above 1. Distance: around every detail. Clockwise: straight across narrow bays.
   * Default: Clockwise.
   */
  vtkHorizonChoice2Macro(GrowthStrategy, GrowthStrategies, Distance, Clockwise);

  /**
   * Keep holes open unless too small. Off: close all. Default: on.
   */
  vtkHorizonFlagMacro(KeepHoles);

  /**
   * Split the horizon at faults (field data FaultedLinks). Off: later stages ignore them, too. See "Faults" in
   * HorizonExteriorBoundary.md. Default: on.
   *
   * Off: the outputs have no FaultedLinks.
   */
  vtkHorizonFlagMacro(TearAtFaults);

  /**
   * Derive the smallest open hole from radius and outline tolerance. Off: SmallestHoleSize. Default: on.
   */
  vtkHorizonFlagMacro(AutomaticSmallestHoleSize);

  /**
   * Without AutomaticSmallestHoleSize, holes with fewer columns strictly inside are closed. Unit: columns. Range: at
   * least 1. Default: 1.
   */
  vtkHorizonNumberMacro(SmallestHoleSize, int);

  /**
   * Patches with fewer points are dropped. Unit: points. Range: at least 1. Default: 1.
   */
  vtkHorizonNumberMacro(MinimumPatchSize, int);

  /**
   * Use the mesh error as outline tolerance in map view, in columns, at most 0.75, or more if
   * outlines would need over half of MaximumNumberOfTriangles.
   * Off: OutlineTolerance. Default: on.
   */
  vtkHorizonFlagMacro(AutomaticOutlineTolerance);

  /**
   * Largest distance in map view of a dropped point from its outline, without AutomaticOutlineTolerance. Unit:
   * columns. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(OutlineTolerance, double);

  /**
   * Use the mesh error as vertical tolerance of outlines. Off: DistanceThreshold. Default: on.
   */
  vtkHorizonFlagMacro(AutomaticDistanceThreshold);

  /**
   * Largest vertical distance of a dropped point from its outline, without AutomaticDistanceThreshold. Unit: lattice
   * units. Range: at least 0. Default: 0.4.
   */
  vtkHorizonNumberMacro(DistanceThreshold, double);

protected:
  vtkHorizonSurface();
  ~vtkHorizonSurface() override = default;

  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;
  bool IsForAllRanks(const SeismicHorizons::RankedHorizon& horizon) override;
  void ProcessOnRanks(const SeismicHorizons::RankedHorizon& horizon, const SeismicHorizons::Ranks& ranks,
    const SeismicHorizons::Monitor& monitor, const std::function<void()>& process) override;

private:
  vtkHorizonSurface(const vtkHorizonSurface&) = delete;
  void operator=(const vtkHorizonSurface&) = delete;

  int Target = LargestError;
  int MaximumNumberOfTriangles = 20000;
  bool AutomaticRadius = true;
  int Radius = 1;
  int GrowthStrategy = Clockwise;
  bool KeepHoles = true;
  bool TearAtFaults = true;
  bool AutomaticSmallestHoleSize = true;
  int SmallestHoleSize = 1;
  int MinimumPatchSize = 1;
  bool AutomaticOutlineTolerance = true;
  double OutlineTolerance = 0.0;
  bool AutomaticDistanceThreshold = true;
  double DistanceThreshold = 0.4;
  const SeismicHorizons::PartRanks* Helpers = nullptr; // while ranks process a horizon together
};

#endif
