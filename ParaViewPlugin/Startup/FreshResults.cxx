// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FreshResults.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <cstring>

namespace
{
void Refresh(vtkObject* stage, unsigned long, void*, void*)
{
  static_cast<vtkSMSourceProxy*>(stage)->UpdatePropertyInformation();
}

void Watch(vtkObject*, unsigned long, void* refresh, void* registered)
{
  const auto& entry = *static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(registered);
  auto* const source = vtkSMSourceProxy::SafeDownCast(entry.Proxy);
  auto* const command = static_cast<vtkCommand*>(refresh);
  if (source && source->GetVTKClassName() && std::strncmp(source->GetVTKClassName(), "vtkHorizon", 10) == 0 &&
    !source->HasObserver(vtkCommand::UpdateDataEvent, command))
  {
    source->AddObserver(vtkCommand::UpdateDataEvent, command);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void KeepResultsFresh()
{
  if (vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_CLIENT &&
    vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_BATCH)
  {
    return; // Servers have no panels.
  }
  static vtkNew<vtkCallbackCommand> refresh;
  static vtkNew<vtkCallbackCommand> watch;
  refresh->SetCallback(Refresh);
  watch->SetCallback(Watch);
  watch->SetClientData(refresh);
  vtkSMProxyManager* const proxies = vtkSMProxyManager::GetProxyManager();
  if (!proxies->HasObserver(vtkCommand::RegisterEvent, watch))
  {
    proxies->AddObserver(vtkCommand::RegisterEvent, watch);
  }
}
