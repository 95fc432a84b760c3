// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonExteriorBoundary
 * @brief   the closed outline of each patch of a horizon
 *
 * Input: a horizon, or a composite dataset of them; at most one point in a column of the lattice.
 * Output: the same points with all their arrays, a vertex cell for each, and for each patch one closed polyline over
 * its points (first point repeated at the end), clockwise seen from +z on the lattice, from the point of least x, then
 * least y. New point arrays:
 *  - PatchId (int): the number of the point's patch, from 0; also the number of the patch's loop;
 *  - Boundary (unsigned char): 0 inside, 1 on the loop.
 *
 * A patch is what hangs together when each point reaches the eight columns around its own. A patch inside the loop of
 * another one (an island in a hole) has no loop: its points belong to the outer patch. Holes have no loops either. A
 * spur of one column's width is walked out and back, and a single point has the loop from itself to itself.
 *
 * The method is that of the thesis (3.3, Def. 3.4, Alg. 3.1 and 3.2 with k = 1), which then is the border following of
 * Suzuki and Abe (1985), with a stopping test that does not cut off patches that touch themselves at their first point.
 * Linear in the points and in the columns of their bounding box; beyond input and output 20 bytes per point and 4 per
 * column.
 *
 * Errors: two points in one column, a point between columns or off the lattice, no lattice in the field data.
 *
 * @sa vtkHorizonBoundarySimplification
 */

#ifndef vtkHorizonExteriorBoundary_h
#define vtkHorizonExteriorBoundary_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonExteriorBoundary : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonExteriorBoundary* New();
  vtkTypeMacro(vtkHorizonExteriorBoundary, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHorizonExteriorBoundary() = default;
  ~vtkHorizonExteriorBoundary() override = default;

  void ProcessHorizon(vtkPolyData* input, vtkPolyData* output, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonExteriorBoundary(const vtkHorizonExteriorBoundary&) = delete;
  void operator=(const vtkHorizonExteriorBoundary&) = delete;
};

#endif
