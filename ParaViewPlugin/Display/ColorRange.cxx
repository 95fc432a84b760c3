// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColorRange.h"

#include "ShownAxis.h"
#include "ViewContents.h"

#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace SeismicHorizons
{
namespace
{
constexpr const char* OwnRange = "SeismicHorizons.Range";

std::string DescribeRange(vtkSMProxy* table)
{
  double ends[2] = { 0.0, 0.0 };
  vtkSMTransferFunctionProxy::GetRange(table, ends);
  return std::to_string(ends[0]) + " " + std::to_string(ends[1]);
}

/// The range may have changed after SetRange.
bool HasOwnRange(vtkSMProxy* table)
{
  return table->HasAnnotation(OwnRange) && DescribeRange(table) == table->GetAnnotation(OwnRange);
}

bool IsFor(vtkPVXMLElement* hint, vtkPVDataInformation* data)
{
  const char* const kind = hint->GetAttribute("data");
  double mostPoints = std::numeric_limits<double>::infinity();
  hint->GetScalarAttribute("most_points", &mostPoints);
  return (!kind || (data->DataSetTypeIsA(kind) && !data->IsCompositeDataSet())) &&
    double(data->GetNumberOfPoints()) <= mostPoints;
}

bool FindHeights(vtkPVDataInformation* data, ColorRange& range)
{
  const VerticalAxis axis = ReadVerticalAxis(data);
  const double* const bounds = data->GetBounds();
  range.Array = axis.Name;
  range.Association = vtkDataObject::POINT;
  range.IsDownwards = axis.IsDownwards;
  range.IsOfData = false; // Images and volumes do not have these heights as an array.
  range.Ends =
    axis.IsDownwards ? std::array<double, 2>{ -bounds[5], -bounds[4] } : std::array<double, 2>{ bounds[4], bounds[5] };
  vtkPVArrayInformation* const array = data->GetArrayInformation(axis.Name.c_str(), vtkDataObject::POINT);
  if (array && array->GetDataType() == VTK_STRING)
  {
    return false; // The user's, of the same name.
  }
  if (array && array->GetNumberOfComponents() == 1)
  {
    array->GetComponentRange(0, range.Ends.data());
  }
  return !axis.Name.empty() && range.Ends[0] < range.Ends[1];
}

/// Limits a range from zero by a figure of the data, which has a component per unit.
void Cut(ColorRange& range, vtkPVDataInformation* data, const char* figure, int unit)
{
  vtkPVArrayInformation* const array = data->GetArrayInformation(figure, vtkDataObject::FIELD);
  double figures[2] = { 0.0, 0.0 };
  if (array && unit < array->GetNumberOfComponents())
  {
    array->GetComponentRange(unit, figures); // The maximum over all directions.
  }
  if (figures[1] > 0.0 && figures[1] < range.Ends[1])
  {
    range.Ends = { 0.0, figures[1] };
    range.IsCut = true;
  }
}

/// Adds the unit of an array without one in its name, and uses enough digits to distinguish the ends, unless the user has
/// set a title or a format.
void LabelLegend(vtkSMProxy* legend, const ColorRange& shown)
{
  const std::array<double, 2>& range = shown.Ends;
  if (legend && !shown.Unit.empty() && vtkSMPropertyHelper(legend, "Title").GetAsString() == shown.Array)
  {
    vtkSMPropertyHelper(legend, "Title").Set((shown.Array + " (" + shown.Unit + ")").c_str());
  }
  vtkSMProperty* const format = legend ? legend->GetProperty("RangeLabelFormat") : nullptr;
  if (!format)
  {
    return;
  }
  // Formats are for std::format or, in older versions, printf.
  const std::string present = vtkSMPropertyHelper(format).GetAsString();
  const std::string start = !present.empty() && present[0] == '{' ? "{:" : "%", end = start == "%" ? "" : "}";
  const std::string digits = range[1] - range[0] >= 10.0 ? ".0f" : range[1] - range[0] >= 0.1 ? ".2f" : ".3g";
  const std::array<std::string, 3> own = { start + ".0f" + end, start + ".2f" + end, start + ".3g" + end };
  if (format->IsValueDefault() || std::find(own.begin(), own.end(), present) != own.end())
  {
    vtkSMPropertyHelper(format).Set((start + digits + end).c_str());
    legend->UpdateVTKObjects();
  }
}

/// The range of the array of colours itself, as outputs of ParaView's filters have it.
bool FindOwnRange(vtkSMProxy* representation, ColorRange& range)
{
  const vtkSMPropertyHelper colors(representation, "ColorArrayName");
  const char* const name = colors.GetInputArrayNameToProcess();
  vtkPVArrayInformation* const array =
    name ? FindShownData(representation)->GetArrayInformation(name, colors.GetInputArrayAssociation()) : nullptr;
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return false;
  }
  range.Array = name;
  array->GetComponentRange(0, range.Ends.data());
  return range.Ends[0] <= range.Ends[1];
}

/// Requires a hint that sets another range than the data.
bool FindRange(vtkSMProxy* representation, ColorRange& range)
{
  const vtkSMPropertyHelper input(representation, "Input");
  auto* const producer = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  const int port = static_cast<int>(input.GetOutputPort());
  const char* const array = vtkSMPropertyHelper(representation, "ColorArrayName").GetInputArrayNameToProcess();
  const std::vector<vtkPVXMLElement*> hints = ListHints(producer, port);
  return array &&
    std::any_of(hints.begin(), hints.end(),
      [&](vtkPVXMLElement* hint)
      { return FindRange(hint, producer, port, range) && range.Array == array && !range.IsOfData; });
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkPVXMLElement*> ListHints(vtkSMSourceProxy* producer, int port)
{
  std::vector<vtkPVXMLElement*> found;
  vtkPVXMLElement* const hints = producer->GetHints();
  for (unsigned int n = 0; hints && n < hints->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* const hint = hints->GetNestedElement(n);
    int forPort = port;
    hint->GetScalarAttribute("port", &forPort);
    if (std::strcmp(hint->GetName(), "FirstSight") == 0 && forPort == port &&
      IsFor(hint, producer->GetDataInformation(static_cast<unsigned int>(port))))
    {
      found.push_back(hint);
    }
  }
  return found;
}

//----------------------------------------------------------------------------------------------------------------------
bool FindRange(vtkPVXMLElement* hint, vtkSMSourceProxy* producer, int port, ColorRange& range)
{
  vtkPVDataInformation* const data = producer->GetDataInformation(static_cast<unsigned int>(port));
  const std::string name = hint->GetAttributeOrEmpty("array");
  if (name.empty() || name == "heights")
  {
    return !name.empty() && FindHeights(data, range);
  }
  range.Array = name;
  range.Association = std::strcmp(hint->GetAttributeOrDefault("association", "points"), "cells") == 0
    ? vtkDataObject::CELL
    : vtkDataObject::POINT;
  vtkPVArrayInformation* const array = data->GetArrayInformation(name.c_str(), range.Association);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return false;
  }
  const std::string kind = hint->GetAttributeOrDefault("range", "data");
  if (kind == "categories") // The array may be of text, or have a single value.
  {
    range.Array = hint->GetAttributeOrDefault("shown_as", name.c_str());
    return true;
  }
  array->GetComponentRange(0, range.Ends.data());
  const VerticalAxis axis = ReadVerticalAxis(data);
  const ShownArray shown = ShowInUnit(name, axis);
  range.Array = hint->GetAttributeOrDefault("shown_as", shown.Name.c_str());
  range.Ends = { shown.Factor * range.Ends[0], shown.Factor * range.Ends[1] };
  const bool hasSeveral = range.Ends[0] < range.Ends[1];
  range.IsOfData = kind == "data" && shown.Name == name;
  if (kind == "centred")
  {
    const std::vector<double> strong = ReadField(data, hint->GetAttributeOrEmpty("ends_at"), 1);
    double reach = std::max(std::fabs(range.Ends[0]), std::fabs(range.Ends[1]));
    if (!strong.empty() && strong[0] > 0.0)
    {
      reach = std::min(reach, strong[0]);
    }
    range.Ends = { -reach, reach };
    return reach > 0.0; // A single value differs from zero.
  }
  else if (kind == "fraction")
  {
    range.Ends = { 0.0, 1.0 };
    return true;
  }
  else if (kind != "data")
  {
    const int unit = vtkSMPropertyHelper(producer, hint->GetAttributeOrEmpty("unit"), true).GetAsInt();
    Cut(range, data, kind.c_str(), unit);
    range.Unit = unit == 0 ? "lattice units" : axis.Unit.empty() || axis.IsTime ? "world units" : axis.Unit;
  }
  return hasSeveral;
}

//----------------------------------------------------------------------------------------------------------------------
void SetRange(vtkSMProxy* table, const std::array<double, 2>& ends)
{
  vtkSMPropertyHelper(table, "AutomaticRescaleRangeMode").Set(vtkSMTransferFunctionManager::NEVER);
  vtkSMTransferFunctionProxy::RescaleTransferFunction(table, ends[0], ends[1]);
  table->UpdateVTKObjects();
  table->SetAnnotation(OwnRange, DescribeRange(table).c_str());
}

//----------------------------------------------------------------------------------------------------------------------
void ExtendRange(vtkSMProxy* table, const ColorRange& range)
{
  double ends[2];
  if (HasOwnRange(table) && vtkSMTransferFunctionProxy::GetRange(table, ends))
  {
    SetRange(table, { std::min(ends[0], range.Ends[0]), std::max(ends[1], range.Ends[1]) });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void RefreshRanges(vtkSMProxy* view)
{
  std::map<vtkSMProxy*, ColorRange> ranges;
  for (vtkSMProxy* const representation : ListRepresentations(view))
  {
    vtkSMProxy* const table = vtkSMPropertyHelper(representation, "LookupTable", true).GetAsProxy();
    ColorRange range;
    if (FindShownData(representation) && table && HasOwnRange(table) &&
      (FindRange(representation, range) || FindOwnRange(representation, range)))
    {
      std::array<double, 2>& ends = ranges.insert({ table, range }).first->second.Ends;
      ends = { std::min(ends[0], range.Ends[0]), std::max(ends[1], range.Ends[1]) };
    }
  }
  for (const auto& [table, range] : ranges)
  {
    SetRange(table, range.Ends);
    LabelLegend(vtkSMTransferFunctionProxy::FindScalarBarRepresentation(table, view), range);
  }
}
}
