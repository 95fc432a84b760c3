// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Processors.h"

#include "vtkMultiProcessController.h"
#include "vtkSMPTools.h"

#include <cstdlib>
#include <string>

//----------------------------------------------------------------------------------------------------------------------
void UseAllProcessors()
{
  const bool isChosen = std::getenv("VTK_SMP_BACKEND_IN_USE") || std::string(vtkSMPTools::GetBackend()) != "Sequential";
  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  const bool isOneOfSeveral = controller && controller->GetNumberOfProcesses() > 1;
  if (!isChosen && !isOneOfSeveral)
  {
    vtkSMPTools::SetBackend("STDThread");
  }
}
