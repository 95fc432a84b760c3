// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonContours
 * @brief   contours a horizon, as long lines with labels
 *
 * Input: the points of a horizon, or its mesh; composite datasets of them. Output: a polyline per contour, closed where
 * it ends at its first point, at multiples of the interval. Points are drawn as a surface between neighbouring columns,
 * which is open at missing points and at faults (FaultedLinks). Triangles that close faults have no contours. Cell data:
 *  - Level (double): depth or time, or height where z increases upwards, in the unit of z
 *  - IndexContour (unsigned char): 1 for every fifth level, else 0
 *  - Label (text): the level, for maps.
 *
 * Field data: ContourInterval (double), NumberOfContours (vtkIdType).
 *
 * Contours follow the surface as it is, noise included: those of a mesh within an error are smoother. A point at a level
 * counts as above it.
 *
 * Errors: an interval that gives more than 10,000 levels, polygons other than triangles, and for points as of
 * vtkHorizonExteriorBoundary.
 *
 * @sa vtkFaultLinesWriter, which writes the lines; vtkContourFilter
 */

#ifndef vtkHorizonContours_h
#define vtkHorizonContours_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonContours : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonContours* New();
  vtkTypeMacro(vtkHorizonContours, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Contour interval; levels are its multiples. 0: a round one for about twelve levels per horizon. Unit: that of z.
   * Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(Interval, double);

protected:
  vtkHorizonContours() = default;
  ~vtkHorizonContours() override = default;

  bool TakesMeshes() override { return true; }
  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonContours(const vtkHorizonContours&) = delete;
  void operator=(const vtkHorizonContours&) = delete;

  double Interval = 0.0;
};

#endif
