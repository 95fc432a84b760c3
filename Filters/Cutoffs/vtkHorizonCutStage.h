// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonCutStage
 * @brief   base class of stages for horizons and the faults that cut them
 *
 * Input 0: the points of horizons, as composite datasets or several connections. Input 1: faults, as sticks (lines) or
 * triangles with the cell data FaultName; a closed line with the name of a fault is its tip loop. Without it, the
 * faults are those that the field data FaultedLinks of the horizons cut. Its properties are on HorizonCutoffs.md.
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
   * Optional sticks or surfaces of faults, in the coordinates of the horizons. Range: lines, triangles. Default: none.
   *
   * Input 1.
   */
  void SetFaultsConnection(vtkAlgorithmOutput* faults) { this->SetInputConnection(1, faults); }
  void RemoveFaults() { this->SetInputConnection(1, nullptr); }
  ///@}

  /**
   * Dip, towards the downthrown side, of faults known from one horizon only. 0: from the gap between picks; without
   * one, dip and heave are unknown. Unit: degrees. Range: 5 to 90, or 0. Default: 0.
   */
  vtkHorizonNumberMacro(Dip, double);

  /**
   * Picks closer to a fault, or within two standard deviations of noise where it dips gently, are ignored. Unit:
   * columns. Range: at least 0. Default: 0.5.
   */
  vtkHorizonNumberMacro(DropDistance, double);

  /**
   * Picks beside a fault are ignored if they deviate by more standard deviations of noise from those farther away. 0:
   * all are used. See "Method" in HorizonCutoffs.md. Range: at least 0. Default: 4.
   */
  vtkHorizonNumberMacro(DropNoise, double);

  /**
   * Largest vertical error of simplified cutoffs, or of a sealed model at its picks. -1: automatic, six times the
   * noise of the horizon, or of the roughest in a sealed model. Unit: HeightUnit. Range: at least 0 (above 0 in a
   * sealed model), or -1. Default: -1.
   */
  vtkHorizonNumberMacro(MaximumError, double);

  /**
   * Unit of MaximumError. Steps: vertical index. World: unit of z. Default: Steps.
   */
  vtkHorizonChoice2Macro(HeightUnit, HeightUnits, Steps, World);

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
  int HeightUnit = Steps;
};

#endif
