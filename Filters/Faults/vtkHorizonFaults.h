// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonFaults
 * @brief   detects faults in a horizon, or uses fault lines that you supply
 *
 * Input 0: a horizon, or a composite dataset of horizons, with at most one point per column. Input 1, optional: fault
 * traces, polygons or sticks, as lines or polygons of vtkPolyData in world coordinates. Heights of traces and polygons
 * are ignored.
 *
 * Output 0: the horizon with its points, arrays and cells, without points inside fault polygons (Polygons). New field
 * data, which replaces existing cuts; a link joins two neighbouring columns of the lattice:
 *  - FaultedLinks (3 int): i, j and side of each faulted link; side 0 is the link to column (i + 1, j), 1 that to (i, j
 *    + 1). Sorted by j, i and side, each once. Columns may be missing;
 *  - FaultThrow (double): throw, whole ramps included: vertical index beyond the link minus that before it; nan if
 *    unknown;
 *  - FaultLine (int): the fault line of the link;
 *  - FaultNames (text): the name of each line; "fault 1" and so on if it has none;
 *  - FaultNoise (double): standard deviation of height differences due to noise alone, in vertical indices;
 *  - SmallestFaultThrow (double): the throw that a fault must reach somewhere, in vertical indices;
 *  - BlankedPoints (vtkIdType): points inside polygons that were left out, if lines are given.
 *
 * Output 1: the fault lines as polylines. Point data: Throw (double), the vertical index to the left of the line less
 * that to its right, mostly positive. Cell data: FaultLine (int), FaultName (text).
 *
 * Output 2: with Sticks the surfaces of faults, triangles between neighbouring sticks; empty for all horizons but the
 * first. Cell data: FaultName (text); "sticks 1" and so on if they have none.
 *
 * Detect finds links whose height difference, less the median within three columns, is large compared with the noise
 * and SmallestThrow. Groups of such links are kept if they are long enough, as trees without short branches. Missing
 * columns (LargestGap), ramps (LargestRamp) and holes (JoinThroughHoles) are bridged. See
 * Documentation/HorizonFaults.md.
 *
 * Time is linear; the result is the same for any number of threads. Memory beyond input and output is 16 bytes per
 * column of the bounding box and 16 per point.
 *
 * Errors: two points in one column, points off the lattice or between columns, no lattice in the field data, a
 * parameter out of range, a line with a point that is not finite, or polygons around all points. A warning if no given
 * line passes the horizon.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonHoleFilling
 */

#ifndef vtkHorizonFaults_h
#define vtkHorizonFaults_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <memory>

namespace SeismicHorizons
{
class GivenFaults;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonFaults : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonFaults* New();
  vtkTypeMacro(vtkHorizonFaults, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Extend the surfaces of Sticks at both ends by the last stick spacing. Default: off.
   */
  vtkHorizonFlagMacro(ExtendSticks);

  /**
   * Fault polygons among Traces. Blank: points inside are dropped. Cut: they stay, as islands. Leave: no effect.
   * Default: Blank.
   */
  vtkHorizonChoice3Macro(Polygons, PolygonUses, Blank, Cut, Leave);

  /**
   * Detect faults from the heights. Off: cut along supplied lines only. Default: on.
   */
  vtkHorizonFlagMacro(Detect);

  /**
   * Throw that a fault must reach somewhere; it is followed down to half of this. 0: eight times the noise of each
   * horizon. Unit: ThrowUnit. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(SmallestThrow, double);

  /**
   * Standard deviation of noise in height differences between neighbouring columns. 0: measured per horizon. Unit:
   * ThrowUnit. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(Noise, double);

  /**
   * Unit of SmallestThrow and Noise. Steps: vertical index (voxel). World: unit of z. Default: Steps.
   */
  vtkHorizonChoice2Macro(ThrowUnit, ThrowUnits, Steps, World);

  /**
   * Smallest extent of a fault along i or j. Unit: columns. Range: at least 0. Default: 20.
   */
  vtkHorizonNumberMacro(SmallestExtent, int);

  /**
   * Branches with fewer faulted links are dropped. Unit: links. Range: at least 0. Default: 10.
   */
  vtkHorizonNumberMacro(SmallestBranch, int);

  /**
   * Most missing columns in a row that a fault may cross. Unit: columns. Range: at least 0. Default: 5.
   */
  vtkHorizonNumberMacro(LargestGap, int);

  /**
   * Widest ramp to treat as a fault, cut in the middle. 0: steps only. Unit: columns. Range: 0 to 10. Default: 7.
   */
  vtkHorizonNumberMacro(LargestRamp, int);

  /**
   * Join fault lines across a hole if they point to each other and have similar throws. Default: on.
   */
  vtkHorizonFlagMacro(JoinThroughHoles);

  /**
   * Largest standard deviation of noise in height differences of any horizon, in vertical indices.
   */
  vtkGetMacro(MeasuredNoise, double);

  /// Fault lines in all horizons.
  vtkGetMacro(NumberOfFaultLines, vtkIdType);

  /// Links cut in all horizons.
  vtkGetMacro(NumberOfFaultedLinks, vtkIdType);

  /**
   * Traces: fault traces or polygons, in map view. Sticks: lines down faults; the surface between them, the third
   * output, cuts the horizon. Default: Traces.
   *
   * Sticks of one fault share a name in the cell array FaultName; without the array FaultStick, names may also be "A
   * 1", "A 2", all different.
   */
  vtkHorizonChoice2Macro(LineType, LineTypes, Traces, Sticks);

  ///@{
  /**
   * Optional fault traces, polygons or sticks in the coordinates of the horizon, as from vtkFaultLinesReader. Unit:
   * world units. Range: lines, polygons. Default: none.
   *
   * Input 1.
   */
  void SetFaultLinesConnection(vtkAlgorithmOutput* lines) { this->SetInputConnection(1, lines); }
  void RemoveFaultLines() { this->SetInputConnection(1, nullptr); }
  ///@}

protected:
  vtkHorizonFaults();
  ~vtkHorizonFaults() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonFaults(const vtkHorizonFaults&) = delete;
  void operator=(const vtkHorizonFaults&) = delete;

  int LineType = Traces;
  bool ExtendSticks = false;
  int Polygons = Blank;
  bool Detect = true;
  double SmallestThrow = 0.0;
  double Noise = 0.0;
  int ThrowUnit = Steps;
  int SmallestExtent = 20;
  int SmallestBranch = 10;
  int LargestGap = 5;
  int LargestRamp = 7;
  bool JoinThroughHoles = true;
  double MeasuredNoise = 0.0;
  vtkIdType NumberOfFaultLines = 0;
  vtkIdType NumberOfFaultedLinks = 0;
  std::shared_ptr<SeismicHorizons::GivenFaults> Given; // of this run
};

#endif
