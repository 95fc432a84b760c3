// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSealedModel
 * @brief   makes closed bodies of layers between faults, within an error
 *
 * Input 0: the points of horizons in depth on one lattice, as composite datasets or several connections.
 * Input 1: faults as of vtkHorizonCutoffs; without it, the faults that the horizons are cut by.
 *
 * The model is a box around the columns that all horizons have. Faults are continued beyond their sticks, up to the box or
 * the fault they end at, and horizons to the faults, without picks that do not agree (vtkHorizonCutoffs). What surfaces
 * share are the same points, so that bodies have no gaps: no triangle meets another one elsewhere. Outputs:
 *  - 0 Surfaces: all triangles. Cell data: SurfaceName; SurfaceType (unsigned char: 0 horizon, 1 fault, 2 wall, 3 top or
 *    base); BodyAbove and BodyBelow (int, -1 outside), the bodies on the side that the normal points to, and behind it:
 *    above horizons, in the hanging wall of faults; LayerAbove and LayerBelow (text). Point data: Guessed (unsigned char: 0
 *    near picks, 1 continued, 2 by another horizon). Field data by body: BodyName, BodyLayer, BodyBlock, BodyVolume
 *  - 1 Lines: where surfaces meet, with LineType ("cutoff", "branch", "trace", "outline", "pinch-out", "edge") and
 *    SurfaceName
 *  - 2 Bodies: a closed surface per body, facing outwards
 *  - 3 Figures: a row per body
 *  - 4 Areas: a row per fault and pair of layers that meet there
 *  - 5 Picks: a row per horizon, with what became of its picks.
 *
 * Picks that are used are within MaximumError. Cutoffs, and what is Guessed, are not bounded.
 *
 * Errors: as of vtkHorizonCutoffs, horizons in time, lattices without right angles, and surfaces that cannot be sealed.
 *
 * @sa vtkHorizonCutoffs vtkHorizonLayers vtkSealedModelWriter
 */

#ifndef vtkHorizonSealedModel_h
#define vtkHorizonSealedModel_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonStage.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <string> // for the results

namespace SeismicHorizons
{
struct SealedStageOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonSealedModel : public vtkHorizonStage
{
public:
  static vtkHorizonSealedModel* New();
  vtkTypeMacro(vtkHorizonSealedModel, vtkHorizonStage);
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
   * Which fault ends at which, as "F2 > F1; F3 > F1". Empty: a fault ends at those that it lies beside; of two that cross,
   * the smaller one ends, on each side. With an entry, faults that cross need one. Default: empty.
   */
  vtkHorizonTextMacro(Endings);

  /**
   * A fault that reaches less beyond another one ends there. Unit: columns. Range: at least 0. Default: 5.
   */
  vtkHorizonNumberMacro(EndDistance, double);

  /**
   * Names of horizons, with semicolons between them, that faults end at from below, unless more than a tenth of the fault is
   * above. Default: empty.
   */
  vtkHorizonTextMacro(Unconformities);

  /**
   * The dip of faults that are known from one horizon only, as of vtkHorizonCutoffs. Unit: degrees. Range: 5 to 90, or 0.
   * Default: 0.
   */
  vtkHorizonNumberMacro(Dip, double);

  /**
   * Picks nearer to a fault are not used. Unit: columns. Range: at least 0. Default: 0.5.
   */
  vtkHorizonNumberMacro(DropDistance, double);

  /**
   * Picks beside a fault that do not agree with those farther away are not used, as of vtkHorizonCutoffs. 0: all are used.
   * Range: at least 0. Default: 4.
   */
  vtkHorizonNumberMacro(DropNoise, double);

  /**
   * The largest vertical distance of picks from horizons. -1: automatic, six times the noise of the roughest horizon. Unit:
   * HeightUnit. Range: above 0, or -1. Default: -1.
   */
  vtkHorizonNumberMacro(MaximumError, double);

  /**
   * The unit of MaximumError. Lattice: one vertical index. World: the unit of z. Default: Lattice.
   */
  vtkHorizonChoice2Macro(HeightUnit, HeightUnits, Lattice, World);

  /**
   * What the last update found: bodies, and volumes by layer.
   *
   * Lines of text. Empty before the first update, and after an error.
   */
  const char* GetResults() { return this->Results.c_str(); }

protected:
  vtkHorizonSealedModel();
  ~vtkHorizonSealedModel() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonSealedModel(const vtkHorizonSealedModel&) = delete;
  void operator=(const vtkHorizonSealedModel&) = delete;

  SeismicHorizons::SealedStageOptions MakeOptions() const;

  char* Endings = nullptr;
  double EndDistance = 5.0;
  char* Unconformities = nullptr;
  double Dip = 0.0;
  double DropDistance = 0.5;
  double DropNoise = 4.0;
  double MaximumError = -1.0;
  int HeightUnit = Lattice;
  std::string Results;
};

#endif
