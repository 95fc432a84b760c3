// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSurfaceJoin
 * @brief   joins the meshes of the parts of a horizon into one
 *
 * For horizons larger than memory. Inputs, in any order: meshes of vtkHorizonSurface for the parts of a horizon, which
 * share rows of its lattice (SeamRows) and were made with the same parameters, the radius included. Output: one mesh,
 * as of vtkHorizonSurface for the whole.
 *
 * Vertices on a seam are merged, and patches and holes that the seam cut are rejoined. The error of the mesh is the
 * largest error of the parts. The result differs from a mesh in one piece only near the seams; see
 * Documentation/HorizonSurfaceJoin.md.
 *
 * New field data, besides largest values, sums and means of those of the parts:
 *  - NumberOfParts (int);
 *  - SeamPoints (vtkIdType): vertices on seams that are not on outlines.
 *
 * Errors: a mesh that is not a part, missing parts, or parts of different parameters or horizons.
 *
 * @sa vtkHorizonSurface
 */

#ifndef vtkHorizonSurfaceJoin_h
#define vtkHorizonSurfaceJoin_h

#include "vtkHorizonProperty.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonSurfaceJoin : public vtkPolyDataAlgorithm
{
public:
  static vtkHorizonSurfaceJoin* New();
  vtkTypeMacro(vtkHorizonSurfaceJoin, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Patches with fewer points are dropped. Unit: points. Range: at least 1. Default: 1.
   */
  vtkHorizonNumberMacro(MinimumPatchSize, int);

protected:
  vtkHorizonSurfaceJoin() = default;
  ~vtkHorizonSurfaceJoin() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonSurfaceJoin(const vtkHorizonSurfaceJoin&) = delete;
  void operator=(const vtkHorizonSurfaceJoin&) = delete;

  int MinimumPatchSize = 1;
};

#endif
