// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ContourInterval.h"

#include "Common/Horizon/ContourInterval.h"
#include "Common/Horizon/DataModel.h"
#include "HorizonSheet.h"
#include "ShownAxis.h"
#include "ViewContents.h"

#include "vtkCollection.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionProxy.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr const char* Contours = "contours ";
constexpr const char* Columns = "one of "; // and how many columns along a side

struct Legend
{
  std::set<double> Intervals;
  std::string Unit;
  std::string Of; ///< What contours are of, unless colours are of the same.
  int Step = 1;
};

double GetInterval(vtkSMProxy* representation)
{
  return vtkSMPropertyHelper(representation, "ContourInterval", true).GetAsDouble();
}

/// Returns 0 where no surface is drawn.
int FindStep(vtkSMProxy* representation)
{
  auto* const shown = vtkSMRepresentationProxy::SafeDownCast(representation);
  vtkPVArrayInformation* const steps =
    shown ? shown->GetRepresentedDataInformation()->GetArrayInformation(SheetStep, vtkDataObject::FIELD) : nullptr;
  double range[2] = { 0.0, 0.0 };
  if (steps)
  {
    steps->GetComponentRange(0, range);
  }
  return int(range[1]);
}

std::string Describe(const Legend& legend)
{
  std::ostringstream text;
  for (const double interval : legend.Intervals)
  {
    text << (interval == *legend.Intervals.begin() ? Contours + legend.Of + "every " : " and ") << interval;
  }
  text << (legend.Intervals.empty() || legend.Unit.empty() ? "" : " " + legend.Unit);
  if (legend.Step > 1)
  {
    text << (legend.Intervals.empty() ? "" : ", ") << Columns << legend.Step << " columns and rows shown";
  }
  return text.str();
}
}

//----------------------------------------------------------------------------------------------------------------------
double SuggestContourInterval(vtkSMProxy* representation, vtkPVDataInformation* data)
{
  // Points have a vertex each; meshes have more cells, or fewer.
  if (!data->GetArrayInformation(PointArray::Column, vtkDataObject::POINT) ||
    data->GetNumberOfCells() != data->GetNumberOfPoints())
  {
    return 0.0;
  }
  const double horizons = std::max(1.0, double(data->GetNumberOfLeaves())); // One lies below the other.
  const double range = (data->GetBounds()[5] - data->GetBounds()[4]) / std::sqrt(horizons);
  if (!(range > 0.0 && std::isfinite(range)))
  {
    return 0.0;
  }
  constexpr double fewest = 2.0, most = 60.0; // The shape cannot be seen with fewer contours, or more.
  const std::string axis = ReadVerticalAxis(data).Name;
  vtkNew<vtkCollection> others;
  representation->GetSessionProxyManager()->GetProxies("representations", others);
  for (int n = 0; n < others->GetNumberOfItems(); ++n)
  {
    auto* const other = vtkSMProxy::SafeDownCast(others->GetItemAsObject(n));
    vtkPVDataInformation* const shown = other != representation ? FindShownData(other) : nullptr;
    const double interval = shown ? GetInterval(other) : 0.0;
    if (interval > 0.0 && range / interval >= fewest && range / interval <= most &&
      ReadVerticalAxis(shown).Name == axis)
    {
      return interval;
    }
  }
  return ChooseContourInterval(range);
}

//----------------------------------------------------------------------------------------------------------------------
void DescribeContours(vtkSMProxy* view)
{
  std::map<vtkSMProxy*, Legend> legends;
  for (vtkSMProxy* const representation : ListRepresentations(view))
  {
    vtkSMProxy* const table = vtkSMPropertyHelper(representation, "LookupTable", true).GetAsProxy();
    vtkPVDataInformation* const data = FindShownData(representation);
    vtkSMProxy* const legend =
      table && data ? vtkSMTransferFunctionProxy::FindScalarBarRepresentation(table, view) : nullptr;
    if (!legend)
    {
      continue;
    }
    Legend& description = legends[legend];
    const int step = FindStep(representation);
    if (step > 0 && GetInterval(representation) > 0.0)
    {
      description.Intervals.insert(GetInterval(representation));
      const VerticalAxis axis = ReadVerticalAxis(data);
      const char* const colored = vtkSMPropertyHelper(representation, "ColorArrayName").GetInputArrayNameToProcess();
      description.Unit = axis.Unit;
      description.Of = colored && axis.Name != colored ? "of " + axis.Name.substr(0, axis.Name.find(" (")) + " " : "";
    }
    description.Step = std::max(description.Step, step);
  }
  for (const auto& [legend, description] : legends)
  {
    vtkSMPropertyHelper title(legend, "ComponentTitle");
    const std::string old = title.GetAsString(), text = Describe(description);
    if (old != text && (old.empty() || old.rfind(Contours, 0) == 0 || old.rfind(Columns, 0) == 0))
    {
      title.Set(text.c_str());
      legend->UpdateVTKObjects();
    }
  }
}
}
