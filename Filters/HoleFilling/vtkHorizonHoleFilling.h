// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonHoleFilling
 * @brief   fills holes of a horizon with a smooth continuation of the surrounding surface
 *
 * Input: a horizon without an outline, or a composite dataset of horizons, with at most one point per column. Output:
 * the same points and arrays, bitwise unchanged, then a new point in each column of the filled holes; a vertex cell per
 * point. A hole is a group of empty columns, connected by edges, that a patch encloses, as in
 * vtkHorizonExteriorBoundary with a radius of 1. A patch inside a hole is part of its rim.
 *
 * Point arrays:
 *  - Filled (unsigned char): 1 at new points, 2 at those outside (ExtrapolationDistance), else 0;
 *  - PointCount (vtkIdType): 0 at new points, so that averages exclude them;
 *  - VerticalIndex, RealZ: those of the new surface; other floating-point arrays: by a membrane, or nan (Attributes);
 *    all else, which are labels: that of the nearest point of the rim;
 *  - PatchId and Boundary are removed.
 *
 * Field data, one vtkIdType each: NumberOfFilledHoles, NumberOfFilledPoints, and NumberOfOpenHoles; with Automatic also
 * the chosen RimSmoothing (double) and RimWidth (vtkIdType).
 *
 * Each hole is filled independently, and so is each side of faulted links (FaultedLinks, Documentation/DataModel.md).
 * Plate: a thin plate over the hole and a ring of known columns (Briggs 1974), then a membrane that carries the
 * residual at the rim inwards. Membrane: each new point is the mean of its four neighbours. Small holes are solved
 * directly, large ones by multigrid, in linear time. Memory beyond input and output is 24 bytes per point, and about
 * 1000 per column of the largest hole.
 *
 * Errors: two points in one column, points off the lattice or between columns, no lattice in the field data, a
 * parameter out of range, or faulted links off the lattice.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonDespiking
 */

#ifndef vtkHorizonHoleFilling_h
#define vtkHorizonHoleFilling_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonHoleFilling : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonHoleFilling* New();
  vtkTypeMacro(vtkHorizonHoleFilling, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Holes of more columns stay open. Unit: columns. Range: at least 1. Default: 2500.
   */
  vtkHorizonNumberMacro(LargestHoleSize, vtkIdType);

  /**
   * Holes with a larger area stay open, too; 0: no limit. Unit: square units of the world. Range: at least 0. Default:
   * 0.
   *
   * The area is that of the columns of the hole.
   */
  vtkHorizonNumberMacro(LargestHoleArea, double);

  /**
   * Plate: continues slope and curvature of the rim. Membrane: stays between the heights of the rim. Automatic: a
   * plate with RimSmoothing and RimWidth chosen by roughness. Default: Automatic.
   */
  vtkHorizonChoice3Macro(Method, Methods, Plate, Membrane, Automatic);

  /**
   * Smoothing of rim noise by Plate; known points never move. 0: none, for clean data. 1: for autotracked picks. 16:
   * for noise above half a vertical index. Range: 0 to 1e6. Default: 1.
   *
   * The inverse of the strength of the plate's springs; 0, and all below a millionth, makes it pass through all
   * heights.
   */
  vtkHorizonNumberMacro(RimSmoothing, double);

  /**
   * Width of the rim that Plate continues; more for noisy data. Unit: columns. Range: 1 to 64. Default: 3.
   *
   * Below 2 it has no slope from a rim that is straight.
   */
  vtkHorizonNumberMacro(RimWidth, int);

  /**
   * Floating-point attributes at new points. FromRim: interpolated from the rim. NotANumber: nan. Default: FromRim.
   *
   * FromRim carries them inwards by a membrane, where values that are not finite count as unknown.
   */
  vtkHorizonChoice2Macro(Attributes, AttributeChoices, FromRim, NotANumber);

  /**
   * Columns up to this far outside the horizon, within the survey, are also filled (2 in array Filled). Unit: columns.
   * Range: 0 to 10000. Default: 0.
   *
   * The survey is that of LatticeDimensions: a distance of its size fills it. Holes have the limits above.
   */
  vtkHorizonNumberMacro(ExtrapolationDistance, int);

  /// Holes filled in all horizons.
  vtkGetMacro(NumberOfFilledHoles, vtkIdType);

  /// Points added in all horizons.
  vtkGetMacro(NumberOfFilledPoints, vtkIdType);

  /// Holes too large to fill, in all horizons.
  vtkGetMacro(NumberOfOpenHoles, vtkIdType);

protected:
  vtkHorizonHoleFilling() = default;
  ~vtkHorizonHoleFilling() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonHoleFilling(const vtkHorizonHoleFilling&) = delete;
  void operator=(const vtkHorizonHoleFilling&) = delete;

  vtkIdType LargestHoleSize = 2500;
  double LargestHoleArea = 0.0;
  int Method = Automatic;
  double RimSmoothing = 1.0;
  int RimWidth = 3;
  int Attributes = FromRim;
  int ExtrapolationDistance = 0;
  vtkIdType NumberOfFilledHoles = 0;
  vtkIdType NumberOfFilledPoints = 0;
  vtkIdType NumberOfOpenHoles = 0;
};

#endif
