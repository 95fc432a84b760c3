// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PluginStart.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSMPTools.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyLocator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <array>
#include <cstdlib>
#include <string>

namespace
{
/// Servers have no panels and read no state files.
void ObserveInClients(unsigned long event, vtkCommand* command)
{
  const int type = vtkProcessModule::GetProcessType();
  if (type != vtkProcessModule::PROCESS_CLIENT && type != vtkProcessModule::PROCESS_BATCH)
  {
    return;
  }
  vtkSMProxyManager* const proxies = vtkSMProxyManager::GetProxyManager();
  if (!proxies->HasObserver(event, command))
  {
    proxies->AddObserver(event, command);
  }
}

// ---- Results --------------------------------------------------------------------------------------------------------

void Refresh(vtkObject* stage, unsigned long, void*, void*)
{
  static_cast<vtkSMSourceProxy*>(stage)->UpdatePropertyInformation();
}

/// Whether a source tells something in its panel.
bool HasResults(vtkSMProxy* source)
{
  for (const char* const name : { "Results", "Description" })
  {
    vtkSMProperty* const property = source->GetProperty(name);
    if (property && property->GetInformationOnly())
    {
      return true;
    }
  }
  return false;
}

void Watch(vtkObject*, unsigned long, void* refresh, void* registered)
{
  const auto& entry = *static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(registered);
  auto* const source = vtkSMSourceProxy::SafeDownCast(entry.Proxy);
  auto* const command = static_cast<vtkCommand*>(refresh);
  if (source && HasResults(source) && !source->HasObserver(vtkCommand::UpdateDataEvent, command))
  {
    source->AddObserver(vtkCommand::UpdateDataEvent, command);
  }
}

// ---- Renamed properties ---------------------------------------------------------------------------------------------

struct Rename
{
  const char* Proxy;
  const char* Old;
  const char* New;
};

// State files of version 0.2 have these names.
constexpr std::array<Rename, 9> Renames = { {
  { "HorizonDespiking", "ThreadWidth", "SpurWidth" },
  { "SeismicReflectionExtraction", "Elevation", "ZFrom" },
  { "VerneySparseMatrixReader", "Elevation", "ZFrom" },
  { "ByContentVerneySparseMatrixReader", "Elevation", "ZFrom" },
  { "HorizonExteriorBoundary", "HoleBoundaries", "KeepHoles" },
  { "HorizonExteriorBoundary", "UseCuts", "TearAtFaults" },
  { "HorizonSurface", "HoleBoundaries", "KeepHoles" },
  { "HorizonSurface", "UseCuts", "TearAtFaults" },
  { "HorizonLayers", "UseCuts", "TearAtFaults" },
} };

vtkPVXMLElement* FindProperty(vtkPVXMLElement* proxy, const std::string& name)
{
  for (unsigned int n = 0; n < proxy->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* const element = proxy->GetNestedElement(n);
    if (std::string(element->GetName()) == "Property" && element->GetAttributeOrEmpty("name") == name)
    {
      return element;
    }
  }
  return nullptr;
}

/// All values are integers.
void ReadProxy(vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  for (const Rename& rename : Renames)
  {
    vtkPVXMLElement* const old = FindProperty(element, rename.Old);
    vtkPVXMLElement* const value = old ? old->FindNestedElementByName("Element") : nullptr;
    int number = 0;
    int id = 0;
    if (element->GetAttributeOrEmpty("type") != std::string(rename.Proxy) || FindProperty(element, rename.New) ||
      !value || !value->GetScalarAttribute("value", &number) || !element->GetScalarAttribute("id", &id))
    {
      continue;
    }
    if (vtkSMProxy* const proxy = locator->LocateProxy(id))
    {
      vtkSMPropertyHelper(proxy, rename.New).Set(number);
      proxy->UpdateVTKObjects();
      vtkGenericWarningMacro(<< rename.Proxy << ": property " << rename.Old
                             << " of a state file, expected its new name " << rename.New
                             << ", which has its value now");
    }
  }
}

void ReadElement(vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  if (std::string(element->GetName()) == "Proxy")
  {
    ReadProxy(element, locator);
  }
  for (unsigned int n = 0; n < element->GetNumberOfNestedElements(); ++n)
  {
    ReadElement(element->GetNestedElement(n), locator);
  }
}

void ReadState(vtkObject*, unsigned long, void*, void* loaded)
{
  const auto& state = *static_cast<vtkSMProxyManager::LoadStateInformation*>(loaded);
  if (state.RootElement && state.ProxyLocator)
  {
    ReadElement(state.RootElement, state.ProxyLocator);
  }
}
}

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

//----------------------------------------------------------------------------------------------------------------------
void KeepResultsFresh()
{
  static vtkNew<vtkCallbackCommand> refresh;
  static vtkNew<vtkCallbackCommand> watch;
  refresh->SetCallback(Refresh);
  watch->SetCallback(Watch);
  watch->SetClientData(refresh);
  ObserveInClients(vtkCommand::RegisterEvent, watch);
}

//----------------------------------------------------------------------------------------------------------------------
void ReadRenamedProperties()
{
  static vtkNew<vtkCallbackCommand> read;
  read->SetCallback(ReadState);
  ObserveInClients(vtkCommand::LoadStateEvent, read);
}
