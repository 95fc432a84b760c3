// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonTriangulation
 * @brief   the constrained Delaunay triangulation of a horizon inside its outlines
 *
 * Input: what vtkHorizonExteriorBoundary or any simplification after it gives; with ConvexHull any horizon.
 *
 * Output 0: the same points with all their arrays, the boundary loops as polylines, and triangles, all facing +z in the
 * world. New cell data, nan for the polylines; in plan, in lattice units:
 *  - Compactness (float): 4 sqrt(3) area / (sum of squared sides) of a triangle (thesis eq. 5.9), from 0 to 1
 *  - Quality (float): 2 sqrt(3) area / (longest side x half the perimeter) (thesis eq. 5.10), from 0 to 1
 * New field data, one value each:
 *  - TriangleCount, BoundaryEdgeCount (vtkIdType): boundary edges with surface on one side
 *  - NonDelaunayEdgeCount (vtkIdType): boundary edges that are there because they are boundary: every circle through
 *    their ends holds a point
 *  - SmallestAngle (double): in degrees
 *
 * Output 1, with MaximumNumberOfTriangles: the voxels that the search for the last triangle looked into, as squares, in
 * their order, with the cell data Dilatation (int): 0 on the perpendicular bisector, n on its n-th dilatation, -1 in
 * the box of the edge for the strategy Compactness, in squares around it, or in the circle of a candidate. Empty
 * otherwise.
 *
 * Every boundary edge is an edge of the mesh (those of spurs, which have surface on neither side, belong to no
 * triangle); every point inside is a vertex; no triangle lies outside; every other edge is locally Delaunay, seen from
 * above in lattice units. Holes without loops close.
 *
 * Where the lattice is full, triangles are made without a search. In the rest they grow from the boundary inwards; the
 * third point for an edge is searched in a grid of voxels around it (thesis chapter 5). All
 * decisions are exact: places are taken as integers, columns being cut into up to 2^20 parts (Lattice.h), and ties
 * between points on one circle, of which a lattice is full, are settled by one rule that looks at the places alone
 * (Predicates.h). So the result is unique: neither the order of the points nor the strategy matters.
 *
 * Near linear in the points; about 60 bytes per point beyond input and output on full lattices, 150 where all points
 * have to be searched for.
 *
 * A horizon without outlines is meshed within its convex hull (ConvexHull), from which MaximumBoundaryAngle and
 * MaximumBoundaryEdgeLength then take off the triangles that lie outside (OutsideTriangles.h).
 *
 * Errors: no boundary loops, loops that cross or are not closed or leave their patch, points in one place, on a
 * boundary edge or outside the boundary, an angle or edge length out of range, no PatchId, no lattice in the field
 * data.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonRoughSimplification vtkDelaunay2D
 */

#ifndef vtkHorizonTriangulation_h
#define vtkHorizonTriangulation_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonTriangulation : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonTriangulation* New();
  vtkTypeMacro(vtkHorizonTriangulation, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How the third point of a triangle is looked for.
  enum SearchStrategyType
  {
    VoxelTraversal = 0,
    Compactness = 1
  };

  ///@{
  /**
   * How the first candidate for the third point of a triangle is found: VoxelTraversal, along the perpendicular
   * bisector of the edge and its dilatations (thesis 5.3.6), or Compactness, as the point in the square box of the edge
   * that makes the most compact triangle (5.4). Both give the same mesh. Default: VoxelTraversal.
   */
  vtkSetClampMacro(SearchStrategy, int, VoxelTraversal, Compactness);
  vtkGetMacro(SearchStrategy, int);
  void SetSearchStrategyToVoxelTraversal() { this->SetSearchStrategy(VoxelTraversal); }
  void SetSearchStrategyToCompactness() { this->SetSearchStrategy(Compactness); }
  ///@}

  ///@{
  /**
   * Mesh the convex hull of all points of a horizon, whatever its patches and loops are, and whether it has any; the
   * polylines of the output are then the hull, or what the limits below leave of it. Default: off.
   */
  vtkSetMacro(ConvexHull, bool);
  vtkGetMacro(ConvexHull, bool);
  vtkBooleanMacro(ConvexHull, bool);
  ///@}

  ///@{
  /**
   * With ConvexHull: take off a triangle when the angle that faces its edge on the boundary is larger than this (thesis
   * 5.3.8), and so on inwards, the longest edge first. A triangle stays when it would leave a point without one, or let
   * the boundary pass a point twice: the mesh keeps all points and stays in one piece. In degrees in plan, from 0 to
   * 180, which takes off nothing. A bay whose sides spread by some angle opens about below 90 plus half of it: below 90
   * with parallel sides, the narrower the later. Not applied with MaximumNumberOfTriangles. Default: 180.
   */
  vtkSetMacro(MaximumBoundaryAngle, double);
  vtkGetMacro(MaximumBoundaryAngle, double);
  ///@}

  ///@{
  /**
   * With ConvexHull: take off triangles in the same way when their edge on the boundary is longer than this. In lattice
   * units in plan, at least 0, and 0 takes off nothing; 1.5 leaves of a full lattice what its outline holds.
   * Triangles that exceed either limit are taken off. Not applied with MaximumNumberOfTriangles. Default: 0.
   */
  vtkSetMacro(MaximumBoundaryEdgeLength, double);
  vtkGetMacro(MaximumBoundaryEdgeLength, double);
  ///@}

  ///@{
  /**
   * For inspection: stop each patch after so many triangles, and show in output 1 how the last one was found. Full
   * lattices are searched as well then. At least 0, and 0 makes all triangles. Default: 0.
   */
  vtkSetMacro(MaximumNumberOfTriangles, int);
  vtkGetMacro(MaximumNumberOfTriangles, int);
  ///@}

  ///@{
  /**
   * Whether cracks of cut links (vtkHorizonFaults) are closed by triangles between their lips. These come last, with 1
   * in the new cell data array Fault, 0 of all other cells, and share the vertices of the lips; all else is as without
   * them, and no other figure counts them: the new FaultTriangleCount (vtkIdType) tells how many there are. Gaps of
   * missing points stay open. Not applied with ConvexHull or MaximumNumberOfTriangles. Default: off.
   */
  vtkSetMacro(CloseFaults, bool);
  vtkGetMacro(CloseFaults, bool);
  vtkBooleanMacro(CloseFaults, bool);
  ///@}

protected:
  vtkHorizonTriangulation();
  ~vtkHorizonTriangulation() override = default;

  void ProcessHorizon(vtkPolyData* input, const Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonTriangulation(const vtkHorizonTriangulation&) = delete;
  void operator=(const vtkHorizonTriangulation&) = delete;

  int SearchStrategy = VoxelTraversal;
  bool ConvexHull = false;
  double MaximumBoundaryAngle = 180.0;
  double MaximumBoundaryEdgeLength = 0.0;
  int MaximumNumberOfTriangles = 0;
  bool CloseFaults = false;
};

#endif
