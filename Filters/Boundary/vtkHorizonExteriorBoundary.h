// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonExteriorBoundary
 * @brief   finds the closed outline of each patch of a horizon
 *
 * Input: a horizon, or a composite dataset of horizons, with at most one point per column of the lattice. Output: the
 * same points and arrays, a vertex cell per point, and closed polylines (the first point is repeated at the end): one
 * per patch, clockwise seen from +z on the lattice, then, with KeepHoles, one per hole, counter-clockwise. Each
 * begins at its point of least x, then least y. New point arrays:
 *  - PatchId (int): the patch of the point, from 0; also the number of its loop;
 *  - Boundary (unsigned char): 0 inside, 1 on the loop of a patch, 2 on the loop of a hole (see BoundaryType).
 *
 * New field data, one vtkIdType each: NumberOfPatches, NumberOfHoles, and DroppedSmallPatchPoints. With faulted links
 * (TearAtFaults) also what CloseFaults needs (Documentation/DataModel.md):
 *  - CrackOpenEnds (int, 4 components): where cracks reach the outside or missing points, as two columns;
 *  - CrackLoops (vtkIdType): the numbers of the loops all along cracks.
 *
 * Two points are connected if they are at most Radius columns apart along each axis; a patch is a set of connected
 * points. A patch inside the loop of another, such as an island in a hole without a loop, belongs to the outer patch.
 * A spur one column wide is traced out and back, and a single point has a loop from itself to itself. Loops may touch
 * themselves and each other, but never cross.
 *
 * The method is that of the thesis (3.3, Def. 3.4, Alg. 3.1 and 3.2) as a walk around the faces of a plane graph of
 * hops, which encloses the patch for every radius and shape. With a radius of 1 it is the border following of Suzuki
 * and Abe (1985). Time is linear in the points and the columns of their bounding box; memory beyond input and output is
 * 16 bytes per point and 4 per column.
 *
 * Errors: two points in one column, points off the lattice or between columns, no lattice in the field data, or a
 * radius out of range.
 *
 * @sa vtkHorizonBoundarySimplification
 */

#ifndef vtkHorizonExteriorBoundary_h
#define vtkHorizonExteriorBoundary_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <cstdint> // for std::int64_t

class VTKSEISMICHORIZONS_EXPORT vtkHorizonExteriorBoundary : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonExteriorBoundary* New();
  vtkTypeMacro(vtkHorizonExteriorBoundary, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What counts as boundary. Exterior: the outline of each patch. Topological4: points with an empty column on any of
   * four sides. Topological8: at corners, too. See "Topological boundaries" in HorizonExteriorBoundary.md. Default:
   * Exterior.
   *
   * Topological4 is Def. 3.2 of the thesis: loops run through just these points, around patches of neighbouring columns
   * and all holes, whatever Radius, GrowthStrategy, KeepHoles and the smallest hole are. With Topological8 the
   * loops are the same, and Boundary is that of the points beside.
   */
  vtkHorizonChoice3Macro(BoundaryType, BoundaryTypes, Exterior, Topological4, Topological8);

  /**
   * Largest hop of outlines along each axis: Radius - 1 missing columns are bridged. Larger values give fewer patches
   * and coarser outlines. Unit: columns. Range: 1 to 32. Default: 1.
   *
   * This is k of the thesis.
   */
  vtkHorizonNumberMacro(Radius, int);

  /**
   * How outlines run with a Radius above 1. Distance: around every detail. Clockwise: straight across narrow bays.
   * Default: Clockwise.
   *
   * Thesis, Alg. 3.1 and 3.2. Clockwise takes the first hop of a clockwise sweep.
   */
  vtkHorizonChoice2Macro(GrowthStrategy, GrowthStrategies, Distance, Clockwise);

  /**
   * Keep holes open, with an outline. Off: the mesh closes them. Default: off.
   *
   * A hole is what the hops of the chosen rule leave open inside a patch, with at least one column strictly inside.
   */
  vtkHorizonFlagMacro(KeepHoles);

  /**
   * Holes with fewer columns strictly inside are closed. Unit: columns. Range: at least 1. Default: 1.
   *
   * Columns of islands in the hole count.
   */
  vtkHorizonNumberMacro(SmallestHoleSize, int);

  /**
   * Holes with a smaller area are closed, too; 0: no limit. Unit: square units of the world. Range: at least 0.
   * Default: 0.
   *
   * The area is that of the columns strictly inside.
   */
  vtkHorizonNumberMacro(SmallestHoleArea, double);

  /**
   * Patches with fewer points are dropped. Unit: points. Range: at least 1. Default: 1.
   */
  vtkHorizonNumberMacro(MinimumPatchSize, int);

  /**
   * Split the horizon at faults (field data FaultedLinks). Off: later stages ignore them, too. See "Faults" in
   * HorizonExteriorBoundary.md. Default: on.
   *
   * Off: the output has no FaultedLinks.
   */
  vtkHorizonFlagMacro(TearAtFaults);

protected:
  vtkHorizonExteriorBoundary() = default;
  ~vtkHorizonExteriorBoundary() override = default;

  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonExteriorBoundary(const vtkHorizonExteriorBoundary&) = delete;
  void operator=(const vtkHorizonExteriorBoundary&) = delete;

  int BoundaryType = Exterior;
  int Radius = 1;
  int GrowthStrategy = Clockwise;
  bool KeepHoles = false;
  int SmallestHoleSize = 1;
  double SmallestHoleArea = 0.0;
  int MinimumPatchSize = 1;
  bool TearAtFaults = true;
};

#endif
