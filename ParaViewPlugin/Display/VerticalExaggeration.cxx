// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VerticalExaggeration.h"

#include "ViewContents.h"

#include "vtkBoundingBox.h"
#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr const char* ExaggerationAnnotation = "SeismicHorizons.VerticalExaggeration";
constexpr double FlatShare = 0.1; // Fractions of the width.
constexpr double GoodShare = 0.25;

void SetScale(vtkSMProxy* proxy, const char* name, double factor)
{
  vtkSMProperty* const property = proxy->GetProperty(name);
  if (!property || vtkSMPropertyHelper(property).GetNumberOfElements() != 3 ||
    vtkSMPropertyHelper(property).GetAsDouble(2) == factor)
  {
    return;
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
  vtkSMPropertyHelper(property).Set(2, factor);
  proxy->UpdateVTKObjects();
}

/// The result is 1, 2, 5, 10, 20, 50 and so on, at most `number`, which is at least 1.
double RoundDown(double number)
{
  const double unit = std::pow(10.0, std::floor(std::log10(number)));
  for (const double digit : { 5.0, 2.0 })
  {
    if (digit * unit <= number)
    {
      return digit * unit;
    }
  }
  return unit;
}
}

double GetVerticalExaggeration(vtkSMProxy* view)
{
  // Without the annotation the user may have scaled the axes for a unit.
  vtkSMProxy* const axes = view->HasAnnotation(ExaggerationAnnotation) ? FindAxes(view) : nullptr;
  return axes ? vtkSMPropertyHelper(axes, "DataScale").GetAsDouble(2) : 1.0;
}

void SetVerticalExaggeration(vtkSMProxy* view, double factor)
{
  view->SetAnnotation(ExaggerationAnnotation, "1");
  for (vtkSMProxy* const representation : ListRepresentations(view))
  {
    SetScale(representation, "Scale", factor);
  }
  if (vtkSMProxy* const axes = FindAxes(view))
  {
    SetScale(axes, "DataScale", factor);
  }
}

void ExaggerateRepresentation(vtkSMProxy* representation, vtkSMProxy* view)
{
  if (view->HasAnnotation(ExaggerationAnnotation))
  {
    SetScale(representation, "Scale", GetVerticalExaggeration(view));
  }
}

double SuggestVerticalExaggeration(vtkSMProxy* view)
{
  vtkBoundingBox box;
  for (vtkSMProxy* const representation : ListRepresentations(view))
  {
    vtkPVDataInformation* const data = FindShownData(representation);
    if (data && representation->GetProperty("Scale"))
    {
      box.AddBounds(data->GetBounds());
    }
  }
  if (!box.IsValid())
  {
    return 1.0;
  }
  const double width = std::max(box.GetLength(0), box.GetLength(1));
  const double height = box.GetLength(2);
  const bool isFlat = height > 0.0 && height < FlatShare * width;
  return isFlat ? RoundDown(GoodShare * width / height) : 1.0;
}
}
