// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonTriangulation
 * @brief   the constrained Delaunay triangulation of a horizon inside its outlines
 *
 * Input: what vtkHorizonExteriorBoundary or any simplification after it gives. Output: the same points with all their
 * arrays, the boundary loops as polylines, and triangles, all facing +z in the world.
 *
 * Every boundary edge is an edge of the mesh (those of spurs, which have surface on neither side, belong to no
 * triangle); every point inside is a vertex; no triangle lies outside; every other edge is locally Delaunay, seen from
 * above in lattice units. Holes without loops close.
 *
 * Triangles grow inwards from the boundary; the third point for an edge is searched in a grid of cells around it
 * (thesis chapter 5). All decisions are exact: places are taken as integers, columns being cut into up to 2^20 parts
 * (Lattice.h), and ties between points on one circle, of which a lattice is full, are settled by one rule that looks
 * at the places alone (Predicates.h). So the result is unique: the order of the points does not matter.
 *
 * Near linear in the points; about 150 bytes per point beyond input and output.
 *
 * Errors: no boundary loops, loops that cross or are not closed or leave their patch, points in one place, on a
 * boundary edge or outside the boundary, no PatchId, no lattice in the field data.
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

protected:
  vtkHorizonTriangulation() = default;
  ~vtkHorizonTriangulation() override = default;

  void ProcessHorizon(vtkPolyData* input, vtkPolyData* output, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonTriangulation(const vtkHorizonTriangulation&) = delete;
  void operator=(const vtkHorizonTriangulation&) = delete;
};

#endif
