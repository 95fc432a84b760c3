// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSealedModel
 * @brief   makes closed bodies of the layers between faults, within an error
 *
 * Inputs are those of vtkHorizonCutStage, horizons in depth on one lattice.
 *
 * The model is a box around the columns that all horizons have, or within the outline of picks. Faults are continued
 * beyond their sticks, up to its walls or the fault they end at, and horizons to the faults, without picks that do not
 * agree (vtkHorizonCutoffs). Surfaces share the points where they meet, so that bodies have no gaps; triangles meet
 * nowhere else. Outputs:
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

#include "vtkHorizonCutStage.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

namespace SeismicHorizons
{
struct SealedStageOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonSealedModel : public vtkHorizonCutStage
{
public:
  static vtkHorizonSealedModel* New();
  vtkTypeMacro(vtkHorizonSealedModel, vtkHorizonCutStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Which fault ends at which, as "F2 > F1; F3 > F1", for all that cross. Empty: faults end at those beside them; of
   * two that cross, the smaller ends, on each side. Default: empty.
   */
  vtkHorizonTextMacro(Endings);

  /**
   * A fault that extends less beyond another ends there. Unit: columns. Range: at least 0. Default: 5.
   */
  vtkHorizonNumberMacro(EndDistance, double);

  /**
   * Names of horizons, separated by semicolons, at which faults end from below, unless over a tenth of the fault is
   * above. Default: empty.
   */
  vtkHorizonTextMacro(Unconformities);

  /**
   * Sticks: faults die out half a stick spacing beyond their sticks, or at their tip loop, unless what they end at is
   * within EndDistance. Through: they continue to walls and other faults. See "What is bounded and what is not" in
   * HorizonSealedModel.md. Default: Sticks.
   */
  vtkHorizonChoice2Macro(Tips, TipKinds, Sticks, Through);

  /**
   * Box: walls around the columns that all horizons have. Picks: around all picks in this box, with few corners.
   * Default: Box.
   */
  vtkHorizonChoice2Macro(Outline, Outlines, Box, Picks);

protected:
  vtkHorizonSealedModel();
  ~vtkHorizonSealedModel() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonSealedModel(const vtkHorizonSealedModel&) = delete;
  void operator=(const vtkHorizonSealedModel&) = delete;

  SeismicHorizons::SealedStageOptions MakeOptions() const;

  char* Endings = nullptr;
  double EndDistance = 5.0;
  char* Unconformities = nullptr;
  int Tips = Sticks;
  int Outline = Box;
};

#endif
