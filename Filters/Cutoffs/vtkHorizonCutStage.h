// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonCutStage
 * @brief   what stages of horizons and the faults that cut them have in common
 *
 * Input 0: the points of horizons, as composite datasets or several connections.
 * Input 1: faults, as sticks (lines) or triangles with the cell data FaultName; closed lines of the name of a fault are
 * its tip loop. Without it, the faults are those that the field data FaultedLinks of the horizons cut. Its properties are
 * on HorizonCutoffs.md.
 *
 * @sa vtkHorizonCutoffs vtkHorizonSealedModel
 */

#ifndef vtkHorizonCutStage_h
#define vtkHorizonCutStage_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonStage.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <string> // for the results

namespace SeismicHorizons
{
struct CutInputs;
struct CutoffStageOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonCutStage : public vtkHorizonStage
{
public:
  vtkTypeMacro(vtkHorizonCutStage, vtkHorizonStage);
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
   * The largest vertical distance: of simplified cutoffs from the full ones, of horizons of a sealed model from their
   * picks. -1: automatic, six times the noise of the horizon, in a sealed model of the roughest one. Unit: HeightUnit. Range:
   * at least 0 (above 0 in a sealed model), or -1. Default: -1.
   */
  vtkHorizonNumberMacro(MaximumError, double);

  /**
   * The unit of MaximumError. Lattice: one vertical index. World: the unit of z. Default: Lattice.
   */
  vtkHorizonChoice2Macro(HeightUnit, HeightUnits, Lattice, World);

  /**
   * What the last update found.
   *
   * Lines of text. Empty before the first update, and after an error.
   */
  const char* GetResults() { return this->Results.c_str(); }

protected:
  vtkHorizonCutStage();
  ~vtkHorizonCutStage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Horizons that are left out give warnings. The subject of errors is the horizon at hand.
  SeismicHorizons::CutInputs ReadInputs(vtkInformationVector** inputVector, std::string& subject);
  SeismicHorizons::CutoffStageOptions MakeCutOptions() const;

  std::string Results;

private:
  vtkHorizonCutStage(const vtkHorizonCutStage&) = delete;
  void operator=(const vtkHorizonCutStage&) = delete;

  double Dip = 0.0;
  double DropDistance = 0.5;
  double DropNoise = 4.0;
  double MaximumError = -1.0;
  int HeightUnit = Lattice;
};

#endif
