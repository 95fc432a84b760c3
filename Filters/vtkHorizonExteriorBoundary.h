// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonExteriorBoundary
 * @brief   the closed outline of each patch of a horizon
 *
 * Input: a horizon, or a composite dataset of them; at most one point in a column of the lattice.
 * Output: the same points with all their arrays, a vertex cell for each, and closed polylines over them (first point
 * repeated at the end): first one for each patch, clockwise seen from +z on the lattice, then, with HoleBoundaries, one
 * for each hole, counter-clockwise. Each begins at its point of least x, then least y. New point arrays:
 *  - PatchId (int): the number of the point's patch, from 0; also the number of the patch's loop;
 *  - Boundary (unsigned char): 0 inside, 1 on the loop of a patch, 2 on the loop of a hole (see BoundaryType).
 * New field data, one vtkIdType each: NumberOfPatches, NumberOfHoles, and DroppedSpeckPoints, the points of patches
 * that were too small. With cut links (UseCuts), what CloseFaults of the meshers needs (Documentation/DataModel.md):
 *  - CutMouths (int, 4 components): where cracks open to the outside or to gaps, as two columns;
 *  - CrackLoops (vtkIdType): the numbers of the loops that cracks run along all around.
 *
 * A patch is a connected part of the horizon: two points are neighbours when they are at most Radius columns apart
 * along each axis, and points that reach each other from neighbour to neighbour are of one patch. A patch inside the
 * loop of another one (an island in a hole without a loop) has no loop: its points belong to the outer patch. A spur of
 * one column's width is walked out and back, and a single point has the loop from itself to itself. Loops may touch
 * themselves and each other, but never cross.
 *
 * The method is that of the thesis (3.3, Def. 3.4, Alg. 3.1 and 3.2) as a walk around the faces of a plane graph of
 * hops, so that it ends, does not cross itself and encloses its patch for every radius and shape. With a radius of 1 it
 * is the border following of Suzuki and Abe (1985). Linear in the points and in the columns of their bounding box;
 * beyond input and output 16 bytes per point and 4 per column.
 *
 * Errors: two points in one column, a point between columns or off the lattice, no lattice in the field data, a radius
 * below 1 or above 32.
 *
 * @sa vtkHorizonBoundarySimplification
 */

#ifndef vtkHorizonExteriorBoundary_h
#define vtkHorizonExteriorBoundary_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <cstdint> // for std::int64_t

class VTKSEISMICHORIZONS_EXPORT vtkHorizonExteriorBoundary : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonExteriorBoundary* New();
  vtkTypeMacro(vtkHorizonExteriorBoundary, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Which boundary is looked for.
  enum BoundaryTypes
  {
    Exterior = 0,
    Topological4 = 1,
    Topological8 = 2
  };

  /// How an outline of a radius above 1 grows.
  enum GrowthStrategies
  {
    Distance = 0,
    Clockwise = 1
  };

  ///@{
  /**
   * What counts as boundary. Exterior: the loops that the other parameters describe. Topological4: every point with an
   * empty column on one of its four sides (thesis Def. 3.2); loops run through just these points, around patches of
   * neighbouring columns and all holes, whatever Radius, GrowthStrategy, HoleBoundaries and the smallest hole are.
   * Topological8: as well every point with an empty column at one of its corners; the loops are the same, and Boundary
   * is that of the points beside. Default: Exterior.
   */
  vtkSetClampMacro(BoundaryType, int, Exterior, Topological8);
  vtkGetMacro(BoundaryType, int);
  void SetBoundaryTypeToExterior() { this->SetBoundaryType(Exterior); }
  void SetBoundaryTypeToTopological4() { this->SetBoundaryType(Topological4); }
  void SetBoundaryTypeToTopological8() { this->SetBoundaryType(Topological8); }
  ///@}

  ///@{
  /**
   * How many columns a hop of a loop may lead along each axis (thesis: k), 1 to 32. Gaps of up to Radius - 1 empty
   * columns part no patch. Default: 1.
   */
  vtkSetMacro(Radius, int);
  vtkGetMacro(Radius, int);
  ///@}

  ///@{
  /**
   * The rule by which a loop goes on where Radius leaves a choice. Distance (thesis Alg. 3.1): it follows the border of
   * neighbouring columns, and bridges gaps there and back. Clockwise (Alg. 3.2): it takes the first hop of a clockwise
   * sweep, and so cuts bays short. With a Radius of 1 they are the same. Default: Clockwise.
   */
  vtkSetClampMacro(GrowthStrategy, int, Distance, Clockwise);
  vtkGetMacro(GrowthStrategy, int);
  void SetGrowthStrategyToDistance() { this->SetGrowthStrategy(Distance); }
  void SetGrowthStrategyToClockwise() { this->SetGrowthStrategy(Clockwise); }
  ///@}

  ///@{
  /**
   * Whether holes have loops, which the later stages keep open. A hole is what the hops of the chosen rule leave open
   * inside a patch, with at least one column strictly inside. Default: off.
   */
  vtkSetMacro(HoleBoundaries, bool);
  vtkGetMacro(HoleBoundaries, bool);
  vtkBooleanMacro(HoleBoundaries, bool);
  ///@}

  ///@{
  /**
   * Holes with fewer columns strictly inside their loop, those of islands included, have no loop. At least 1, which
   * keeps all holes. Default: 1.
   */
  vtkSetMacro(SmallestHoleSize, int);
  vtkGetMacro(SmallestHoleSize, int);
  ///@}

  ///@{
  /**
   * The same as an area: columns strictly inside times the area of a column, in square units of the world. Holes that
   * are below either limit have no loop. At least 0, which sets no limit. Default: 0.
   */
  vtkSetMacro(SmallestHoleArea, double);
  vtkGetMacro(SmallestHoleArea, double);
  ///@}

  ///@{
  /**
   * Patches of fewer points are dropped as specks, and their points leave the horizon. At least 1, which keeps all.
   * Default: 1.
   */
  vtkSetMacro(MinimumPatchSize, int);
  vtkGetMacro(MinimumPatchSize, int);
  ///@}

  ///@{
  /**
   * Whether the cut links that the horizon carries (field data CutLinks) part it: cracks are loops around both lips,
   * whatever HoleBoundaries and the smallest hole are, and the later stages leave them open. Off: the horizon is not
   * cut from here on, and the output has no CutLinks. Default: on.
   */
  vtkSetMacro(UseCuts, bool);
  vtkGetMacro(UseCuts, bool);
  vtkBooleanMacro(UseCuts, bool);
  ///@}

protected:
  vtkHorizonExteriorBoundary() = default;
  ~vtkHorizonExteriorBoundary() override = default;

  void ProcessHorizon(vtkPolyData* input, const Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonExteriorBoundary(const vtkHorizonExteriorBoundary&) = delete;
  void operator=(const vtkHorizonExteriorBoundary&) = delete;

  /// The larger of the two limits, in columns.
  std::int64_t FindSmallestHoleSize(double columnArea) const;

  int BoundaryType = Exterior;
  int Radius = 1;
  int GrowthStrategy = Clockwise;
  bool HoleBoundaries = false;
  int SmallestHoleSize = 1;
  double SmallestHoleArea = 0.0;
  int MinimumPatchSize = 1;
  bool UseCuts = true;
};

#endif
