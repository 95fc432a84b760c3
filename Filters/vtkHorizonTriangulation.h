// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonTriangulation
 * @brief   makes the constrained Delaunay triangulation of a horizon within its outlines
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
 * their order, with the cell data Dilatation (int): 0 on the perpendicular bisector, n on its n-th dilation, -1 in
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

  /// Values of SearchStrategy.
  enum SearchStrategyType
  {
    VoxelTraversal = 0,
    Compactness = 1
  };

  ///@{
  /**
   * How the third point of a triangle is searched; the mesh is the same. VoxelTraversal: along the perpendicular
   * bisector of the edge (thesis 5.3.6). Compactness: among all points in the square box of the edge (5.4). Default:
   * VoxelTraversal.
   */
  vtkSetClampMacro(SearchStrategy, int, VoxelTraversal, Compactness);
  vtkGetMacro(SearchStrategy, int);
  void SetSearchStrategyToVoxelTraversal() { this->SetSearchStrategy(VoxelTraversal); }
  void SetSearchStrategyToCompactness() { this->SetSearchStrategy(Compactness); }
  ///@}

  ///@{
  /**
   * Whether the convex hull of all points is meshed, with or without outlines. Default: off.
   *
   * The polylines of the output are then the hull, or what the limits below leave of it.
   */
  vtkSetMacro(ConvexHull, bool);
  vtkGetMacro(ConvexHull, bool);
  vtkBooleanMacro(ConvexHull, bool);
  ///@}

  ///@{
  /**
   * With ConvexHull, triangles are removed from the outside inwards if the angle opposite their boundary edge is
   * larger; 180 removes none. See "Without outlines" in HorizonTriangulation.md. Unit: degrees on the map. Range: 0 to
   * 180. Default: 180.
   *
   * Thesis 5.3.8. The longest edge goes first; a triangle stays when it would leave a point without one, or let the
   * boundary pass a point twice. A bay whose sides spread by some angle opens about below 90 plus half of it: below 90
   * with parallel sides, the narrower the later.
   */
  vtkSetMacro(MaximumBoundaryAngle, double);
  vtkGetMacro(MaximumBoundaryAngle, double);
  ///@}

  ///@{
  /**
   * With ConvexHull, triangles are also removed if their boundary edge is longer; 0 removes none. Unit: columns. Range:
   * at least 0. Default: 0.
   */
  vtkSetMacro(MaximumBoundaryEdgeLength, double);
  vtkGetMacro(MaximumBoundaryEdgeLength, double);
  ///@}

  ///@{
  /**
   * For inspection: each patch stops after this many triangles, and the second output shows the last search. 0 makes
   * all triangles. Unit: triangles. Range: at least 0. Default: 0.
   *
   * Full lattices are searched as well then.
   */
  vtkSetMacro(MaximumNumberOfTriangles, int);
  vtkGetMacro(MaximumNumberOfTriangles, int);
  ///@}

  ///@{
  /**
   * Whether steep triangles, with 1 in the array Fault, close the cracks at faults. Not with ConvexHull or
   * MaximumNumberOfTriangles. See "Closed meshes" in HorizonFaults.md. Default: off.
   *
   * These triangles come last in the new cell data array Fault, 0 elsewhere, and share the vertices of the crack. No
   * other figure counts them; the new FaultTriangleCount (vtkIdType) has their number.
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
