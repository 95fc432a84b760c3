// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonStage
 * @brief   base class of all stages
 *
 * Inputs are horizons (vtkPolyData, see Documentation/DataModel.md), or composite datasets of them (vtkDataObjectTree).
 * A vtkUnstructuredGrid of vertices, lines and polygons, as of Threshold, is accepted, too. Its properties are on
 * HorizonExteriorBoundary.md.
 *
 * @sa vtkHorizonAlgorithm vtkHorizonSurfaceDistance
 */

#ifndef vtkHorizonStage_h
#define vtkHorizonStage_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro
#include "vtkSmartPointer.h" // for a member

class vtkMultiProcessController;

class VTKSEISMICHORIZONS_EXPORT vtkHorizonStage : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkHorizonStage, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Handling of horizons that cannot be processed. Stop: an error, no output. LeaveOut: a warning, an empty horizon.
   * Default: Stop.
   */
  vtkHorizonChoice2Macro(InvalidHorizons, InvalidHorizonsActions, Stop, LeaveOut);

  ///@{
  /**
   * Processes that share this stage, each with its horizons; null: this process alone. Default: the global controller.
   *
   * All of them must update when there is one piece per process (UpdatePiece(rank, processes, 0), as in ParaView).
   * With any other number of pieces, this process works alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkHorizonStage();
  ~vtkHorizonStage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkHorizonStage(const vtkHorizonStage&) = delete;
  void operator=(const vtkHorizonStage&) = delete;

  int InvalidHorizons = Stop;
  vtkSmartPointer<vtkMultiProcessController> Controller;
};

#endif
