// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonStackStage
 * @brief   base class of filters that process all horizons of a stack together
 *
 * Input: the points of two or more horizons of one survey, as composite datasets or several connections. They are on
 * one lattice, or on lattices whose steps are whole multiples of the smallest one, such as every second line. With
 * several processes, each reads all horizons, and the first one has the result. Its properties are on
 * HorizonLayers.md.
 *
 * @sa vtkHorizonLayers vtkHorizonCrossings
 */

#ifndef vtkHorizonStackStage_h
#define vtkHorizonStackStage_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonStage.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <string> // for names

namespace SeismicHorizons
{
class HorizonStack;
class Monitor;
struct StackStageOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonStackStage : public vtkHorizonStage
{
public:
  vtkTypeMacro(vtkHorizonStackStage, vtkHorizonStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * ByHeight: by mean heights in common columns. AsGiven: as in the input, uppermost first, where heights give no
   * clear order. Default: ByHeight.
   */
  vtkHorizonChoice2Macro(Order, Orders, ByHeight, AsGiven);

  /**
   * Mean: crossing horizons move to their mean, which suits noise. UpperWins: the lower one moves, as if eroded.
   * LowerWins: the upper one moves, as in onlap. Stop: an error with number and depth. Default: Mean.
   */
  vtkHorizonChoice4Macro(Crossings, CrossingPolicies, Mean, UpperWins, LowerWins, Stop);

  /**
   * Crossings for each layer, from the uppermost down, such as "Mean LowerWins Mean"; empty: Crossings for all. Range:
   * as many words as layers, or none. Default: empty.
   */
  vtkHorizonTextMacro(CrossingsByLayer);

  /**
   * Thinner layers are absent: their horizons merge as Crossings says, with Stop at their mean. Unit: HeightUnit.
   * Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(MinimumThickness, double);

  /**
   * Unit of MinimumThickness, and of MaximumError in vtkHorizonLayers. Steps: smallest vertical index of all
   * horizons. World: unit of z. Default: Steps.
   */
  vtkHorizonChoice2Macro(HeightUnit, HeightUnits, Steps, World);

protected:
  vtkHorizonStackStage() = default;
  ~vtkHorizonStackStage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// `subject` names the horizon being read, for messages. Throws SeismicHorizons::InputError.
  SeismicHorizons::HorizonStack ReadStack(
    vtkInformationVector* inputs, std::string& subject, const SeismicHorizons::Monitor& monitor);
  SeismicHorizons::StackStageOptions MakeStackOptions() const;

private:
  vtkHorizonStackStage(const vtkHorizonStackStage&) = delete;
  void operator=(const vtkHorizonStackStage&) = delete;

  int Order = ByHeight;
  int Crossings = Mean;
  char* CrossingsByLayer = nullptr;
  double MinimumThickness = 0.0;
  int HeightUnit = Steps;
};

#endif
