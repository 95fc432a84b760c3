// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSurfaceJoin
 * @brief   joins the meshes of the parts of a horizon into one
 *
 * For horizons larger than memory. Inputs, in any order: the meshes that vtkHorizonSurface gives for the parts that a
 * horizon was cut into at some rows of its lattice (SeamRows), which neighbouring parts share. All were made with the
 * same parameters, the radius included. Output: one mesh, as vtkHorizonSurface gives it for the whole.
 *
 * Vertices on a seam become one, edges along it are those of two triangles, with no gap and no overlap, and patches and
 * holes that the seam cut are whole again. The largest error of the parts is that of the mesh. It differs from the mesh
 * of a horizon that was not cut only near the seams, see Documentation/HorizonSurfaceJoin.md.
 *
 * Field data, beside those of the parts (largest values, sums and means of these):
 *  - NumberOfParts (int);
 *  - SeamPoints (vtkIdType): how many vertices are on seams, and not on outlines.
 *
 * Near linear in the vertices, of which there are few beside the points of the horizon.
 *
 * Errors: a mesh that is no part; parts that leave a gap, or of different parameters or horizons.
 *
 * @sa vtkHorizonSurface
 */

#ifndef vtkHorizonSurfaceJoin_h
#define vtkHorizonSurfaceJoin_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonSurfaceJoin : public vtkPolyDataAlgorithm
{
public:
  static vtkHorizonSurfaceJoin* New();
  vtkTypeMacro(vtkHorizonSurfaceJoin, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Patches of fewer points are dropped. Unit: points. Range: at least 1. Default: 1.
   */
  vtkSetMacro(MinimumPatchSize, int);
  vtkGetMacro(MinimumPatchSize, int);
  ///@}

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
