// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonStage
 * @brief   what all stages have in common
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
   * What happens to a horizon that cannot be processed. Stop: an error, and no output. LeaveOut: a warning, and an
   * empty horizon. Default: Stop.
   */
  vtkHorizonChoice2Macro(InvalidHorizons, InvalidHorizonsActions, Stop, LeaveOut);

  ///@{
  /**
   * The processes that run this stage together, each on its horizons, when as many pieces are asked for as there are
   * processes (UpdatePiece(rank, processes, 0), as ParaView does): all of them have to update it then. Null, and any
   * other number of pieces: this process alone. Default: the global controller.
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
