// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonCutoffs
 * @brief   finds where horizons meet faults, with throw, heave, fault polygons and juxtaposition
 *
 * Inputs are those of vtkHorizonCutStage, horizons of one vertical domain and unit.
 *
 * A fault is a smooth plate through its sticks. Picks on each side are continued to it; picks on the wrong side
 * disagree with the rest, and are dropped. Outputs, of which the first two have a block per horizon:
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

#include "vtkHorizonCutStage.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonCutoffs : public vtkHorizonCutStage
{
public:
  static vtkHorizonCutoffs* New();
  vtkTypeMacro(vtkHorizonCutoffs, vtkHorizonCutStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How far horizons are continued to a fault, and interpolated along it. Unit: columns. Range: at least 1. Default:
   * 20.
   */
  vtkHorizonNumberMacro(LargestGap, double);

  /**
   * Shorter cuts of a horizon by a fault are ignored. Unit: columns. Range: at least 2. Default: 5.
   */
  vtkHorizonNumberMacro(SmallestLength, double);

protected:
  vtkHorizonCutoffs();
  ~vtkHorizonCutoffs() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonCutoffs(const vtkHorizonCutoffs&) = delete;
  void operator=(const vtkHorizonCutoffs&) = delete;

  double LargestGap = 20.0;
  double SmallestLength = 5.0;
};

#endif
