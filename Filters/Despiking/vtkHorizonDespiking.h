// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonDespiking
 * @brief   removes or flags spikes and narrow spurs of a horizon
 *
 * Input: a horizon without an outline, or a composite dataset of horizons, with at most one point per column. Output:
 * with Remove the points that are neither spikes nor on spurs, with Flag all points; a vertex cell per point, and all
 * arrays but PatchId and Boundary. The second output has the spikes and the points on spurs alone. There, and with Flag,
 * is the point array
 *  - Spike (unsigned char): 0 for other points, 1 for a spike, 2 on a spur.
 *
 * Field data: NumberOfSpikes, NumberOfSpurPoints (vtkIdType), and SpikeThreshold (double), in vertical indices.
 *
 * The height of a spike differs by more than Threshold from the median of the points around it, each continued along
 * the dip to the column of the point. Points at straight faults are not spikes, since the median follows the larger
 * side. A point is on a spur if no full square of SpurWidth + 1 columns covers it (a morphological opening).
 *
 * Time is linear in the points and in the square of NeighborhoodRadius.
 *
 * Errors: two points in one column, points off the lattice or between columns, no lattice in the field data, or a
 * parameter out of range. A warning if more than 2 % of the points are spikes.
 *
 * @sa vtkHorizonHoleFilling, which fills what was removed
 */

#ifndef vtkHorizonDespiking_h
#define vtkHorizonDespiking_h

#include "vtkHorizonAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonDespiking : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonDespiking* New();
  vtkTypeMacro(vtkHorizonDespiking, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Remove: spikes and spurs are dropped. Flag: they stay, with 1 for spikes, 2 for spurs in array Spike. Default:
   * Remove.
   */
  vtkHorizonChoice2Macro(Action, Actions, Remove, Flag);

  /**
   * Points farther above or below the surface through their neighbours are spikes. 0: four times the noise of each
   * horizon. Unit: ThresholdUnit. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(Threshold, double);

  /**
   * Unit of Threshold. Steps: vertical index (voxel). World: unit of z. Default: Steps.
   */
  vtkHorizonChoice2Macro(ThresholdUnit, ThresholdUnits, Steps, World);

  /**
   * Reach of the neighbourhood along each axis; 2: 5 by 5 columns. Unit: columns. Range: 1 to 16. Default: 2.
   */
  vtkHorizonNumberMacro(NeighborhoodRadius, int);

  /**
   * Widest strips and spurs to remove; 0: none. Unit: columns. Range: 0 to 64. Default: 0.
   */
  vtkHorizonNumberMacro(SpurWidth, int);

  /// Spikes in all horizons.
  vtkGetMacro(NumberOfSpikes, vtkIdType);

  /// Points on spurs in all horizons.
  vtkGetMacro(NumberOfSpurPoints, vtkIdType);

protected:
  vtkHorizonDespiking();
  ~vtkHorizonDespiking() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonDespiking(const vtkHorizonDespiking&) = delete;
  void operator=(const vtkHorizonDespiking&) = delete;

  int Action = Remove;
  double Threshold = 0.0;
  int ThresholdUnit = Steps;
  int NeighborhoodRadius = 2;
  int SpurWidth = 0;
  vtkIdType NumberOfSpikes = 0;
  vtkIdType NumberOfSpurPoints = 0;
};

#endif
