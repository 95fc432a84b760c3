// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSmoothing
 * @brief   the example of a stage: means of heights over squares of columns
 *
 * Input: a horizon before it has an outline, or a composite dataset of such; at most one point in a column. Output: the
 * same points in the same order, at the mean height of those around, with all arrays.
 *
 * Errors: two points in one column, no lattice in the field data, a negative Radius.
 */

#ifndef vtkHorizonSmoothing_h
#define vtkHorizonSmoothing_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkHorizonSmoothingModule.h" // for the export macro

class VTKHORIZONSMOOTHING_EXPORT vtkHorizonSmoothing : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonSmoothing* New();
  vtkTypeMacro(vtkHorizonSmoothing, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How far around a point the mean is taken, in columns along each axis. At least 0. Default: 2.
   */
  vtkHorizonNumberMacro(Radius, int);

protected:
  vtkHorizonSmoothing() = default;
  ~vtkHorizonSmoothing() override = default;

  void ProcessPolyData(
    vtkPolyData* input, const std::vector<vtkPolyData*>& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonSmoothing(const vtkHorizonSmoothing&) = delete;
  void operator=(const vtkHorizonSmoothing&) = delete;

  int Radius = 2;
};

#endif
