// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMHorizonDisplayHelper.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionProxy.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace
{
bool IsNamed(vtkPVXMLElement* element, const char* name)
{
  return std::strcmp(element->GetName(), name) == 0;
}

/// Whether a hint is for data of this kind and size.
bool IsFor(vtkPVXMLElement* hint, vtkPVDataInformation* data)
{
  const char* const kind = hint->GetAttribute("data");
  double mostPoints = std::numeric_limits<double>::infinity();
  hint->GetScalarAttribute("most_points", &mostPoints);
  return (!kind || (data->DataSetTypeIsA(kind) && !data->IsCompositeDataSet())) &&
    double(data->GetNumberOfPoints()) <= mostPoints;
}

/// The hints of a producer for one of its ports, and the data that are there.
std::vector<vtkPVXMLElement*> ListHints(vtkSMSourceProxy* producer, int port, vtkPVDataInformation* data)
{
  std::vector<vtkPVXMLElement*> found;
  vtkPVXMLElement* const hints = producer->GetHints();
  for (unsigned int n = 0; hints && n < hints->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* const hint = hints->GetNestedElement(n);
    int forPort = port;
    hint->GetScalarAttribute("port", &forPort);
    if (IsNamed(hint, "FirstSight") && forPort == port && IsFor(hint, data))
    {
      found.push_back(hint);
    }
  }
  return found;
}

/// Gives a property the value of an attribute, unless somebody has set it before.
void SetSize(vtkSMProxy* proxy, const char* property, vtkPVXMLElement* hint, const char* attribute, vtkMTimeType start)
{
  double value = 0.0;
  if (hint->GetScalarAttribute(attribute, &value) && proxy->GetProperty(property)->GetMTime() <= start)
  {
    vtkSMPropertyHelper(proxy, property).Set(value);
  }
}

/// An array as a hint names it.
struct ColorArray
{
  std::string Name;
  int Association = vtkDataObject::POINT;
  double Range[2] = { 0.0, 0.0 };
};

/// Whether the array that a hint names is in the data, with more than one value.
bool FindArray(vtkPVXMLElement* hint, vtkPVDataInformation* data, ColorArray& array)
{
  const char* const name = hint->GetAttribute("array");
  if (!name)
  {
    return false;
  }
  array.Name = name;
  array.Association = std::strcmp(hint->GetAttributeOrDefault("association", "points"), "cells") == 0
    ? vtkDataObject::CELL
    : vtkDataObject::POINT;
  vtkPVArrayInformation* const found = data->GetArrayInformation(name, array.Association);
  if (!found || found->GetNumberOfComponents() != 1)
  {
    return false;
  }
  found->GetComponentRange(0, array.Range);
  return array.Range[0] < array.Range[1];
}

vtkPVXMLElement* FindColorMap(vtkPVXMLElement* xml, const char* name)
{
  for (unsigned int n = 0; n < xml->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* const map = xml->GetNestedElement(n);
    if (IsNamed(map, "ColorMap") && std::strcmp(map->GetAttributeOrEmpty("name"), name) == 0)
    {
      return map;
    }
  }
  return nullptr;
}

/// What stands for each category: a value, and the text of the legend.
using Categories = std::vector<std::string>;

/// The annotations of a colour map; without them, the whole numbers of a range.
Categories ListCategories(vtkPVXMLElement* map, const double range[2])
{
  Categories categories;
  for (unsigned int n = 0; n < map->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* const entry = map->GetNestedElement(n);
    if (IsNamed(entry, "Annotation"))
    {
      categories.insert(categories.end(), { entry->GetAttributeOrEmpty("v"), entry->GetAttributeOrEmpty("t") });
    }
  }
  if (categories.empty())
  {
    for (long long value = std::llround(range[0]); value <= std::llround(range[1]); ++value)
    {
      categories.insert(categories.end(), 2, std::to_string(value));
    }
  }
  return categories;
}

/// The colours of a map that is for categories, as red, green and blue of one after the other.
std::vector<double> ListColors(vtkPVXMLElement* map)
{
  std::vector<double> colors;
  for (unsigned int n = 0; n < map->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* const point = map->GetNestedElement(n);
    for (const char* const channel : { "r", "g", "b" })
    {
      double value = 0.0;
      if (IsNamed(point, "Point") && point->GetScalarAttribute(channel, &value))
      {
        colors.push_back(value);
      }
    }
  }
  return colors;
}

void ApplyCategories(vtkSMProxy* table, vtkPVXMLElement* map, const double range[2])
{
  const std::vector<double> colors = ListColors(map);
  if (range[1] - range[0] + 1.0 > double(colors.size() / 3))
  {
    return; // too many of them to tell apart
  }
  const Categories categories = ListCategories(map, range);
  vtkSMPropertyHelper(table, "IndexedLookup").Set(1);
  vtkSMPropertyHelper annotations(table, "Annotations");
  annotations.SetNumberOfElements(static_cast<unsigned int>(categories.size()));
  for (std::size_t n = 0; n < categories.size(); ++n)
  {
    annotations.Set(static_cast<unsigned int>(n), categories[n].c_str());
  }
  vtkSMPropertyHelper(table, "IndexedColors").Set(colors.data(), static_cast<unsigned int>(colors.size()));
  table->UpdateVTKObjects();
}

/// Whether colours are categories that were applied before, and data with more of them have come.
bool LacksCategories(vtkSMProxy* table, vtkPVXMLElement* map, const double range[2])
{
  return vtkSMPropertyHelper(table, "IndexedLookup").GetAsInt() == 1 &&
    vtkSMPropertyHelper(table, "IndexedColors").GetDoubleArray() == ListColors(map) &&
    vtkSMPropertyHelper(table, "Annotations").GetNumberOfElements() < ListCategories(map, range).size();
}

void ApplyColors(vtkSMProxy* table, vtkPVXMLElement* map, const double range[2])
{
  if (std::strcmp(map->GetAttributeOrDefault("indexedLookup", "false"), "true") == 0)
  {
    ApplyCategories(table, map, range);
    return;
  }
  vtkSMTransferFunctionProxy::ApplyColorMap(table, map);
  // Colours that part from a middle have it at zero.
  const bool isCentred = std::strcmp(map->GetAttributeOrEmpty("centred"), "true") == 0;
  const double reach = std::fmax(std::fabs(range[0]), std::fabs(range[1]));
  vtkSMTransferFunctionProxy::RescaleTransferFunction(
    table, isCentred ? -reach : range[0], isCentred ? reach : range[1]);
}

/// Whether the colours of an array have been made already, or are in the user's settings.
bool HasColors(const std::string& array, vtkSMSessionProxyManager* proxies)
{
  const std::string end = "." + array + ".PVLookupTable";
  const unsigned int count = proxies->GetNumberOfProxies("lookup_tables");
  for (unsigned int n = 0; n < count; ++n)
  {
    const std::string name = std::string(".") + proxies->GetProxyName("lookup_tables", n);
    if (name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
    {
      return true;
    }
  }
  return vtkSMSettings::GetInstance()->HasSetting((".array_lookup_tables." + array).c_str());
}

/// Makes a volume clear at the least value, and equally opaque at all from the next whole number on.
void SetOpacity(vtkSMProxy* representation, double opacity, const double range[2])
{
  vtkSMProxy* const function = vtkSMPropertyHelper(representation, "ScalarOpacityFunction").GetAsProxy();
  if (function)
  {
    // Each point: a value, the opacity there, and what is in ParaView's words its midpoint and sharpness.
    const std::vector<double> points = { range[0], 0.0, 0.5, 0.0, range[0] + 0.5, 0.0, 0.5, 0.0, range[0] + 1.0,
      opacity, 0.5, 0.0, std::fmax(range[1], range[0] + 2.0), opacity, 0.5, 0.0 };
    vtkSMPropertyHelper(function, "Points").Set(points.data(), static_cast<unsigned int>(points.size()));
    function->UpdateVTKObjects();
  }
}

/// Colours a representation by an array, in colours of a map where nobody has given the array others.
void ColorBy(vtkSMProxy* representation, const ColorArray& array, vtkPVXMLElement* hint, vtkPVXMLElement* map)
{
  const bool isNew = !HasColors(array.Name, representation->GetSessionProxyManager());
  if (auto* const colored = vtkSMPVRepresentationProxy::SafeDownCast(representation))
  {
    colored->SetScalarColoring(array.Name.c_str(), array.Association);
  }
  vtkSMProxy* const table = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
  if (map && table && (isNew || LacksCategories(table, map, array.Range)))
  {
    ApplyColors(table, map, array.Range);
  }
  double opacity = 0.0;
  if (isNew && hint->GetScalarAttribute("opacity", &opacity))
  {
    SetOpacity(representation, opacity, array.Range);
  }
}
}

vtkStandardNewMacro(vtkSMHorizonDisplayHelper);

//------------------------------------------------------------------------------
vtkSMHorizonDisplayHelper::vtkSMHorizonDisplayHelper() = default;

//------------------------------------------------------------------------------
vtkSMHorizonDisplayHelper::~vtkSMHorizonDisplayHelper() = default;

//------------------------------------------------------------------------------
void vtkSMHorizonDisplayHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkSMHorizonDisplayHelper::Register()
{
  vtkClientServerInterpreterInitializer::GetInitializer()->RegisterCallback(
    [](vtkClientServerInterpreter* interpreter)
    {
      interpreter->AddNewInstanceFunction(
        "vtkSMHorizonDisplayHelper", [](void*) -> vtkObjectBase* { return vtkSMHorizonDisplayHelper::New(); });
    });
}

//------------------------------------------------------------------------------
void vtkSMHorizonDisplayHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp)
{
  const vtkSMPropertyHelper input(proxy, "Input");
  auto* const producer = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!producer)
  {
    return;
  }
  const int port = static_cast<int>(input.GetOutputPort());
  vtkPVDataInformation* const data = producer->GetDataInformation(port);
  bool isColored = false;
  const char* representation = nullptr;
  for (vtkPVXMLElement* const hint : ListHints(producer, port, data))
  {
    representation = representation ? representation : hint->GetAttribute("representation");
    SetSize(proxy, "LineWidth", hint, "line_width", initializationTimeStamp);
    SetSize(proxy, "PointSize", hint, "point_size", initializationTimeStamp);
    ColorArray array;
    if (!isColored && FindArray(hint, data, array))
    {
      ColorBy(proxy, array, hint, FindColorMap(xml, hint->GetAttributeOrEmpty("colors")));
      isColored = true;
    }
  }
  if (representation && proxy->GetProperty("Representation")->GetMTime() <= initializationTimeStamp)
  {
    // After the colours, as ParaView gives those that it chooses to a volume.
    vtkSMRepresentationProxy::SetRepresentationType(proxy, representation);
    proxy->GetProperty("Representation")->Modified(); // else it would count as not set
  }
  proxy->UpdateVTKObjects();
}
