// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonTriangulation
 * @brief   makes the constrained Delaunay triangulation of a horizon within its outlines
 *
 * Input: the output of vtkHorizonExteriorBoundary or of any simplification after it; with ConvexHull any horizon.
 *
 * Output 0: the same points and arrays, the boundary loops as polylines, and triangles that face +z in the world. New
 * cell data, on the map in lattice units, nan for polylines:
 *  - Compactness (float): 4 sqrt(3) area / (sum of squared sides) (thesis eq. 5.9), from 0 to 1;
 *  - Quality (float): 2 sqrt(3) area / (longest side x half the perimeter) (thesis eq. 5.10), from 0 to 1.
 *
 * New field data, one value each:
 *  - TriangleCount, BoundaryEdgeCount (vtkIdType): boundary edges with surface on one side;
 *  - NonDelaunayEdgeCount (vtkIdType): boundary edges without an empty circle through their ends;
 *  - SmallestAngle (double): in degrees.
 *
 * Output 1, with MaximumNumberOfTriangles: the search cells of the last triangle, as squares in order, with the cell
 * data Dilatation (int): 0 on the perpendicular bisector, n on its n-th dilation, else -1.
 *
 * Every boundary edge is an edge of the mesh, but those of spurs have no triangles. Every point inside is a vertex; no
 * triangle lies outside; every other edge is locally Delaunay, seen from above in lattice units. Holes without loops
 * are closed. With ConvexHull, MaximumBoundaryAngle and MaximumBoundaryEdgeLength remove triangles from the outside
 * inwards (OutsideTriangles.cxx).
 *
 * Triangles grow inwards from the boundary; the third point for an edge is searched in a grid of cells (thesis chapter
 * 5). Full lattices need no search. All decisions are exact, and ties between points on one circle are settled by their
 * places alone (Predicates.h): the result depends neither on the order of the points nor on the strategy. Time is near
 * linear; memory beyond input and output is about 60 bytes per point on full lattices, and up to 150.
 *
 * Errors: no boundary loops, loops that cross, are not closed or leave their patch, points in one place, on a boundary
 * edge or outside the boundary, a parameter out of range, no PatchId, or no lattice in the field data.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonRoughSimplification vtkDelaunay2D
 */

#ifndef vtkHorizonTriangulation_h
#define vtkHorizonTriangulation_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonTriangulation : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonTriangulation* New();
  vtkTypeMacro(vtkHorizonTriangulation, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Search for third points; the mesh is the same. VoxelTraversal: along the perpendicular bisector of an edge.
   * Compactness: in the square box around it. Default: VoxelTraversal.
   *
   * Thesis 5.3.6 and 5.4.
   */
  vtkHorizonChoice2Macro(SearchStrategy, SearchStrategyType, VoxelTraversal, Compactness);

  /**
   * Mesh the convex hull of all points, ignoring outlines. Default: off.
   *
   * The polylines of the output are then the hull, or what the limits below leave of it.
   */
  vtkHorizonFlagMacro(ConvexHull);

  /**
   * With ConvexHull, outer triangles are removed if the angle opposite their boundary edge is larger; 180: none. See
   * "Without outlines" in HorizonTriangulation.md. Unit: degrees in map view. Range: 0 to 180. Default: 180.
   *
   * Thesis 5.3.8. The longest edge goes first; a triangle stays when it would leave a point without one, or let the
   * boundary pass a point twice. A bay whose sides spread by some angle opens about below 90 plus half of it: below 90
   * with parallel sides, the narrower the later.
   */
  vtkHorizonNumberMacro(MaximumBoundaryAngle, double);

  /**
   * With ConvexHull, triangles are also removed if their boundary edge is longer; 0: none. Unit: columns. Range: at
   * least 0. Default: 0.
   */
  vtkHorizonNumberMacro(MaximumBoundaryEdgeLength, double);

  /**
   * For inspection: each patch stops after this many triangles, and the second output shows the last search. 0: all.
   * Unit: triangles. Range: at least 0. Default: 0.
   *
   * Full lattices are then searched, too.
   */
  vtkHorizonNumberMacro(MaximumNumberOfTriangles, int);

  /**
   * Close cracks at faults with steep triangles (1 in array Fault). Not with ConvexHull or MaximumNumberOfTriangles.
   * See "Closed meshes" in HorizonFaults.md. Default: off.
   *
   * These triangles come last in the new cell data array Fault, 0 elsewhere, and share the vertices of the crack. No
   * other figure counts them; the new FaultTriangleCount (vtkIdType) has their number.
   */
  vtkHorizonFlagMacro(CloseFaults);

protected:
  vtkHorizonTriangulation();
  ~vtkHorizonTriangulation() override = default;

  bool TakesMeshes() override { return true; }

  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

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
