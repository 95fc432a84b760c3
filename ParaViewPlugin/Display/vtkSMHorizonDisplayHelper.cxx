// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMHorizonDisplayHelper.h"

#include "ColorRange.h"
#include "ContourInterval.h"

#include "vtkAbstractArray.h"
#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVProminentValuesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMCoreUtilities.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace
{
using SeismicHorizons::ColorRange;

// In VTK 9.6 lines drawn as tubes are hidden by the surrounding surface, and visible through it from behind.
constexpr const char* Tubes = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0) ? "" : "tubes";
constexpr const char* OwnColors = "SeismicHorizons.Colors"; // Separate colour maps that have those of the hints.
constexpr const char* Empty = "SeismicHorizons.Empty"; // Such representations had no data when first shown.
constexpr std::array<double, 3> AboveColor = { 0.95, 0.0, 0.75 }; // No map has this colour.
constexpr std::array<double, 3> EdgeColor = { 0.32, 0.36, 0.40 }; // ParaView's dark blue hides small triangles.

bool IsNamed(vtkPVXMLElement* element, const char* name)
{
  return std::strcmp(element->GetName(), name) == 0;
}

void SetSize(vtkSMProxy* proxy, const char* property, vtkPVXMLElement* hint, const char* attribute, vtkMTimeType start)
{
  double value = 0.0;
  if (hint->GetScalarAttribute(attribute, &value) && proxy->GetProperty(property)->GetMTime() <= start)
  {
    vtkSMPropertyHelper(proxy, property).Set(value);
  }
}

/// Reduces the size of many points, which would cover each other.
void SetPointSize(vtkSMProxy* proxy, vtkPVXMLElement* hint, vtkPVDataInformation* data, vtkMTimeType start)
{
  SetSize(proxy, "PointSize", hint, "point_size", start);
  double largest = 0.0, least = 0.0;
  if (hint->GetScalarAttribute("point_size", &largest) && hint->GetScalarAttribute("least_point_size", &least) &&
    vtkSMPropertyHelper(proxy, "PointSize").GetAsDouble() == largest)
  {
    constexpr double across = 500.0; // Pixels along one side of a view that the points may cover.
    const double size = std::floor(across / std::sqrt(double(data->GetNumberOfPoints())));
    vtkSMPropertyHelper(proxy, "PointSize").Set(std::min(largest, std::max(least, size)));
  }
}

void SetContours(vtkSMProxy* proxy, vtkPVDataInformation* data, vtkMTimeType start)
{
  vtkSMProperty* const interval = proxy->GetProperty("ContourInterval");
  if (interval && interval->GetMTime() <= start && interval->IsValueDefault())
  {
    vtkSMPropertyHelper(interval).Set(SeismicHorizons::SuggestContourInterval(proxy, data));
  }
}

void SetSection(vtkSMProxy* proxy, vtkPVDataInformation* data)
{
  const int* const extent = data->GetExtent();
  const int columns = extent[1] - extent[0], rows = extent[3] - extent[2];
  vtkSMPropertyHelper(proxy, "SliceMode").Set(columns >= rows ? "XZ Plane" : "YZ Plane");
  vtkSMPropertyHelper(proxy, "Slice").Set((columns >= rows ? rows : columns) / 2);
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

/// The values that data have, for maps that name none.
std::vector<std::string> ListCategories(vtkSMProxy* proxy, const ColorRange& range)
{
  constexpr double rarely = 1e-6, share = 1e-6;
  std::vector<std::string> categories;
  auto* const representation = vtkSMRepresentationProxy::SafeDownCast(proxy);
  if (representation)
  {
    representation->UpdateVTKObjects();
    representation->UpdatePipeline();
    vtkPVProminentValuesInformation* const found =
      representation->GetProminentValuesInformation(range.Array, range.Association, 1, rarely, share, true);
    const auto values = vtk::TakeSmartPointer(found ? found->GetProminentComponentValues(0) : nullptr);
    for (vtkIdType n = 0; values && n < values->GetNumberOfTuples(); ++n)
    {
      categories.push_back(values->GetVariantValue(n).ToString());
    }
  }
  std::sort(categories.begin(), categories.end());
  return categories;
}

void ApplyCategories(vtkSMProxy* representation, vtkSMProxy* table, vtkPVXMLElement* map, const ColorRange& range)
{
  std::vector<std::string> categories; // value and text of each
  std::vector<double> colors;
  for (unsigned int n = 0; n < map->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* const entry = map->GetNestedElement(n);
    if (IsNamed(entry, "Annotation"))
    {
      categories.insert(categories.end(), { entry->GetAttributeOrEmpty("v"), entry->GetAttributeOrEmpty("t") });
    }
    for (const char* const channel : { "r", "g", "b" })
    {
      double value = 0.0;
      if (IsNamed(entry, "Point") && entry->GetScalarAttribute(channel, &value))
      {
        colors.push_back(value);
      }
    }
  }
  if (categories.empty())
  {
    for (const std::string& value : ListCategories(representation, range))
    {
      categories.insert(categories.end(), { value, value });
    }
  }
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

void ApplyColors(vtkSMProxy* representation, vtkSMProxy* table, vtkPVXMLElement* map, const ColorRange& range)
{
  if (std::strcmp(map->GetAttributeOrDefault("indexedLookup", "false"), "true") == 0)
  {
    ApplyCategories(representation, table, map, range);
    return;
  }
  vtkSMTransferFunctionProxy::ApplyColorMap(table, map);
  if (range.IsDownwards)
  {
    vtkSMTransferFunctionProxy::InvertTransferFunction(table);
  }
  vtkSMPropertyHelper(table, "UseAboveRangeColor").Set(range.IsCut ? 1 : 0);
  vtkSMPropertyHelper(table, "AboveRangeColor").Set(AboveColor.data(), 3);
  table->UpdateVTKObjects();
  if (range.IsOfData)
  {
    vtkSMTransferFunctionProxy::RescaleTransferFunction(table, range.Ends[0], range.Ends[1]);
  }
  else
  {
    SeismicHorizons::SetRange(table, range.Ends);
  }
}

bool HasColors(const std::string& array, vtkSMSessionProxyManager* proxies)
{
  const std::string known = vtkSMCoreUtilities::SanitizeName(array.c_str());
  const std::string end = "." + known + ".PVLookupTable";
  const unsigned int count = proxies->GetNumberOfProxies("lookup_tables");
  for (unsigned int n = 0; n < count; ++n)
  {
    const std::string name = std::string(".") + proxies->GetProxyName("lookup_tables", n);
    if (name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
    {
      return true;
    }
  }
  return vtkSMSettings::GetInstance()->HasSetting((".array_lookup_tables." + known).c_str());
}

/// The least value is transparent; all values from the next integer on are equally opaque.
void SetOpacity(vtkSMProxy* representation, double opacity, const double range[2])
{
  vtkSMProxy* const function = vtkSMPropertyHelper(representation, "ScalarOpacityFunction").GetAsProxy();
  if (function)
  {
    // Points consist of value, opacity, midpoint and sharpness.
    const std::vector<double> points = { range[0], 0.0, 0.5, 0.0, range[0] + 0.5, 0.0, 0.5, 0.0, range[0] + 1.0,
      opacity, 0.5, 0.0, std::fmax(range[1], range[0] + 2.0), opacity, 0.5, 0.0 };
    vtkSMPropertyHelper(function, "Points").Set(points.data(), static_cast<unsigned int>(points.size()));
    function->UpdateVTKObjects();
  }
}

/// Colours that the user has given the array take precedence.
void ColorBy(vtkSMProxy* representation, const ColorRange& range, vtkPVXMLElement* hint, vtkPVXMLElement* map)
{
  // SetScalarColoring would also warn if only the representation has the array.
  vtkNew<vtkSMTransferFunctionManager> manager;
  vtkSMSessionProxyManager* const proxies = representation->GetSessionProxyManager();
  const bool isNew = !HasColors(range.Array, proxies);
  vtkSMProxy* const table = manager->GetColorTransferFunction(range.Array.c_str(), proxies);
  vtkSMPropertyHelper(representation, "ColorArrayName").SetInputArrayToProcess(range.Association, range.Array.c_str());
  vtkSMPropertyHelper(representation, "LookupTable").Set(table);
  vtkSMPropertyHelper(representation, "ScalarOpacityFunction", true)
    .Set(manager->GetOpacityTransferFunction(range.Array.c_str(), proxies));
  if (map && isNew)
  {
    ApplyColors(representation, table, map, range);
  }
  else if (!range.IsOfData)
  {
    SeismicHorizons::ExtendRange(table, range);
  }
  double opacity = 0.0;
  if (isNew && hint->GetScalarAttribute("opacity", &opacity))
  {
    SetOpacity(representation, opacity, range.Ends.data());
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
void vtkSMHorizonDisplayHelper::ColorSeparately(vtkSMProxy* representation)
{
  vtkSMProxy* const table = vtkSMPropertyHelper(representation, "LookupTable", true).GetAsProxy();
  vtkPVXMLElement* const hints = representation->GetHints();
  vtkPVXMLElement* const xml = hints ? hints->FindNestedElementByName("InitializationHelper") : nullptr;
  const vtkSMPropertyHelper input(representation, "Input", true);
  auto* const producer = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  const char* const name =
    table ? representation->GetSessionProxyManager()->GetProxyName("lookup_tables", table) : nullptr;
  if (!name || std::strncmp(name, "Separate_", 9) != 0 || !xml || !producer || table->HasAnnotation(OwnColors))
  {
    return;
  }
  table->SetAnnotation(OwnColors, "1"); // From now on the user may change them.
  const std::string array = vtkSMPropertyHelper(representation, "ColorArrayName").GetInputArrayNameToProcess();
  const int port = static_cast<int>(input.GetOutputPort());
  for (vtkPVXMLElement* const hint : SeismicHorizons::ListHints(producer, port))
  {
    ColorRange range;
    vtkPVXMLElement* const map = FindColorMap(xml, hint->GetAttributeOrEmpty("colors"));
    if (map && SeismicHorizons::FindRange(hint, producer, port, range) && range.Array == array)
    {
      ApplyColors(representation, table, map, range);
      return;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkSMHorizonDisplayHelper::ShowLate(vtkSMProxy* representation)
{
  if (!representation->HasAnnotation(Empty))
  {
    return false;
  }
  vtkPVXMLElement* const hints = representation->GetHints();
  vtkPVXMLElement* const xml = hints ? hints->FindNestedElementByName("InitializationHelper") : nullptr;
  if (xml)
  {
    vtkNew<vtkSMHorizonDisplayHelper> helper;
    helper->PostInitializeProxy(representation, xml, VTK_MTIME_MAX);
  }
  return xml && !representation->HasAnnotation(Empty);
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
  vtkPVDataInformation* const data = producer->GetDataInformation(static_cast<unsigned int>(port));
  if (data->GetNumberOfPoints() == 0)
  {
    proxy->SetAnnotation(Empty, "1");
    return;
  }
  proxy->RemoveAnnotation(Empty);
  SetContours(proxy, data, initializationTimeStamp);
  bool isColored = false;
  const char* representation = nullptr;
  for (vtkPVXMLElement* const hint : SeismicHorizons::ListHints(producer, port))
  {
    SetSize(proxy, "LineWidth", hint, "line_width", initializationTimeStamp);
    SetPointSize(proxy, hint, data, initializationTimeStamp);
    SetSize(proxy, "RenderLinesAsTubes", hint, Tubes, initializationTimeStamp);
    SetSize(proxy, "RenderPointsAsSpheres", hint, "spheres", initializationTimeStamp);
    SetSize(proxy, "Ambient", hint, "ambient", initializationTimeStamp);
    SetSize(proxy, "Diffuse", hint, "diffuse", initializationTimeStamp);
    ColorRange range;
    const bool hasArray = SeismicHorizons::FindRange(hint, producer, port, range);
    if (!representation && (hasArray || !hint->GetAttribute("array")))
    {
      representation = hint->GetAttribute("representation");
    }
    if (!isColored && hasArray)
    {
      ColorBy(proxy, range, hint, FindColorMap(xml, hint->GetAttributeOrEmpty("colors")));
      isColored = true;
    }
  }
  if (representation && proxy->GetProperty("Representation")->GetMTime() <= initializationTimeStamp)
  {
    // ParaView assigns its own colours to a volume, so that the type is set last.
    vtkSMRepresentationProxy::SetRepresentationType(proxy, representation);
    if (std::strcmp(representation, "Surface With Edges") == 0)
    {
      vtkSMPropertyHelper(proxy, "EdgeColor").Set(EdgeColor.data(), 3);
    }
    if (std::strcmp(representation, "Slice") == 0)
    {
      SetSection(proxy, data);
    }
    proxy->GetProperty("Representation")->Modified(); // Otherwise it would count as unset.
  }
  proxy->UpdateVTKObjects();
  if (auto* const shown = vtkSMRepresentationProxy::SafeDownCast(proxy))
  {
    shown->PostUpdateData(false); // Updates array information from before the data existed.
  }
}
