// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenamedProperties.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyLocator.h"
#include "vtkSMProxyManager.h"

#include <array>
#include <string>

namespace
{
struct Rename
{
  const char* Proxy;
  const char* Old;
  const char* New;
};

// Names of version 0.2, to be removed with the deprecated setters.
constexpr std::array<Rename, 4> Renames = { {
  { "HorizonDespiking", "ThreadWidth", "SpurWidth" },
  { "SeismicReflectionExtraction", "Elevation", "ZFrom" },
  { "VerneySparseMatrixReader", "Elevation", "ZFrom" },
  { "ByContentVerneySparseMatrixReader", "Elevation", "ZFrom" },
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
void ReadRenamedProperties()
{
  if (vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_CLIENT &&
    vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_BATCH)
  {
    return; // Servers read no state files.
  }
  static vtkNew<vtkCallbackCommand> read;
  read->SetCallback(ReadState);
  vtkSMProxyManager* const proxies = vtkSMProxyManager::GetProxyManager();
  if (!proxies->HasObserver(vtkCommand::LoadStateEvent, read))
  {
    proxies->AddObserver(vtkCommand::LoadStateEvent, read);
  }
}
