// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonCutoffs
 * @brief   finds where horizons meet faults, with throw, heave, fault polygons and juxtaposition
 *
 * Input 0: the points of horizons, as composite datasets or several connections, of one vertical domain and unit.
 * Input 1: faults, as sticks (lines) or triangles with the cell data FaultName; closed lines of the name of a fault are
 * its tip loop. Without it, the faults are those that the field data FaultedLinks of the horizons cut.
 *
 * A fault is a smooth plate through its sticks. Picks on each side of it are continued to it; those of the wrong side do
 * not agree with the others of their own, and are dropped. Outputs, of which the first two have a block per horizon:
 *  - 0 Cutoffs: two lines per fault and piece along it. Cell data: FaultLine, FaultName, and FaultStick ("footwall" or "hanging
 *    wall"). Point data (double): Throw, Heave, Spread (the standard deviation of the height by noise), Along (distance
 *    along strike), and Guessed (unsigned char: 0 within two columns of picks, 1 extrapolated, 2 interpolated)
 *  - 1 Polygons: closed lines around the heave, with FaultName
 *  - 2 Faults: the plates as triangles, with FaultName
 *  - 3 Juxtaposition: the faults as cells by the layers that meet there. Point data: Along. Cell data: FaultName,
 *    Juxtaposition, Footwall and HangingWall (text), and IsSame (unsigned char)
 *  - 4 Diagrams: the same in the plane of distance along strike and height, side by side (Allan diagrams)
 *  - 5 Figures: a row per horizon and fault that cuts it
 *  - 6 Areas: a row per fault and pair of layers.
 *
 * Throw is the height of the footwall above the hanging wall, heave the distance of cutoffs on the map across strike:
 * both are negative at reverse faults.
 *
 * Errors: no faults, none that cuts a horizon, a level fault, horizons of different domains or units, and for points as
 * of vtkHorizonExteriorBoundary.
 *
 * @sa vtkHorizonFaults vtkFaultLinesReader vtkFaultLinesWriter vtkHorizonLayers
 */

#ifndef vtkHorizonCutoffs_h
#define vtkHorizonCutoffs_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonStage.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <string> // for the results

namespace SeismicHorizons
{
struct CutoffStageOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonCutoffs : public vtkHorizonStage
{
public:
  static vtkHorizonCutoffs* New();
  vtkTypeMacro(vtkHorizonCutoffs, vtkHorizonStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sticks or surfaces of faults, in the coordinates of the horizons; optional. Range: lines, triangles. Default: none.
   *
   * Input 1.
   */
  void SetFaultsConnection(vtkAlgorithmOutput* faults) { this->SetInputConnection(1, faults); }
  void RemoveFaults() { this->SetInputConnection(1, nullptr); }
  ///@}

  /**
   * The dip of faults that are known from one horizon only, towards its lower side. 0: from the gap of picks along them;
   * where picks are on both sides it is unknown, and so is the heave. Unit: degrees. Range: 5 to 90, or 0. Default: 0.
   */
  vtkHorizonNumberMacro(Dip, double);

  /**
   * Picks nearer to a fault are not used, as they may be on the wrong side; where faults dip gently, nor those that two
   * deviations of their noise would put there. Unit: columns. Range: at least 0. Default: 0.5.
   */
  vtkHorizonNumberMacro(DropDistance, double);

  /**
   * Picks within six columns of a fault are not used if they are off the surface of those farther away by more than this
   * many standard deviations of their noise, unless the horizon bends slowly. 0: all are used. Range: at least 0.
   * Default: 4.
   */
  vtkHorizonNumberMacro(DropNoise, double);

  /**
   * How far horizons are continued to a fault, and interpolated along it. Unit: columns. Range: at least 1. Default: 20.
   */
  vtkHorizonNumberMacro(LargestGap, double);

  /**
   * A horizon that a fault cuts over less is uncut there. Unit: columns. Range: at least 2. Default: 5.
   */
  vtkHorizonNumberMacro(SmallestLength, double);

  /**
   * The largest vertical distance of simplified cutoffs from the full ones. -1: automatic, six times the noise of the
   * horizon. Unit: HeightUnit. Range: at least 0, or -1. Default: -1.
   */
  vtkHorizonNumberMacro(MaximumError, double);

  /**
   * The unit of MaximumError. Lattice: one vertical index. World: the unit of z. Default: Lattice.
   */
  vtkHorizonChoice2Macro(HeightUnit, HeightUnits, Lattice, World);

  /**
   * What the last update found: throw, heave, and what was dropped and guessed, by fault and horizon.
   *
   * Lines of text. Empty before the first update, and after an error.
   */
  const char* GetResults() { return this->Results.c_str(); }

protected:
  vtkHorizonCutoffs();
  ~vtkHorizonCutoffs() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonCutoffs(const vtkHorizonCutoffs&) = delete;
  void operator=(const vtkHorizonCutoffs&) = delete;

  SeismicHorizons::CutoffStageOptions MakeOptions() const;

  double Dip = 0.0;
  double DropDistance = 0.5;
  double DropNoise = 4.0;
  double LargestGap = 20.0;
  double SmallestLength = 5.0;
  double MaximumError = -1.0;
  int HeightUnit = Lattice;
  std::string Results;
};

#endif
