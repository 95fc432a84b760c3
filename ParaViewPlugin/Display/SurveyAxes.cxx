// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurveyAxes.h"

#include "ViewContents.h"

#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr const char* Annotation = "SeismicHorizons.SurveyAxes";

/// One axis of a view: the number at a place x is (x - Position) / Scale.
struct Axis
{
  std::string Title;
  double Scale = 1.0;
  double Position = 0.0;
};

/// Lines that are counted along an axis: the number of the first one, and the step from each to the next.
struct Lines
{
  std::string Name;
  double First = 0.0;
  double Step = 1.0;

  /// Where the first line is at `start`, and one is `spacing` away from the next.
  Axis Along(double start, double spacing) const
  {
    const double scale = spacing / this->Step;
    return { this->Name, scale, start - this->First * scale };
  }
};

/// The values of a field data array with one tuple; none where it is not there, or has others in other blocks.
std::vector<double> ReadField(vtkPVDataInformation* data, const char* name, int count)
{
  vtkPVArrayInformation* const array = data->GetArrayInformation(name, vtkDataObject::FIELD);
  std::vector<double> values;
  for (int n = 0; array && array->GetNumberOfComponents() == count && n < count; ++n)
  {
    double range[2];
    array->GetComponentRange(n, range);
    if (range[0] != range[1])
    {
      return {};
    }
    values.push_back(range[0]);
  }
  return values;
}

/// The data of the first output shown that has a lattice, or null.
vtkPVDataInformation* FindSurvey(vtkSMProxy* view)
{
  for (vtkSMProxy* const representation : ListRepresentations(view))
  {
    vtkPVDataInformation* const data = FindShownData(representation);
    if (data && !ReadField(data, "LatticeToWorld", 16).empty())
    {
      return data;
    }
  }
  return nullptr;
}

void SetAxes(vtkSMProxy* view, const Axis& x, const Axis& y, bool areShown)
{
  vtkSMProxy* const axes = FindAxes(view);
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", axes);
  vtkSMPropertyHelper(axes, "Visibility").Set(areShown ? 1 : 0);
  vtkSMPropertyHelper(axes, "XTitle").Set(x.Title.c_str());
  vtkSMPropertyHelper(axes, "YTitle").Set(y.Title.c_str());
  vtkSMPropertyHelper scale(axes, "DataScale");
  scale.Set(0, x.Scale);
  scale.Set(1, y.Scale);
  vtkSMPropertyHelper position(axes, "DataPosition");
  position.Set(0, x.Position);
  position.Set(1, y.Position);
  axes->UpdateVTKObjects();
}
}

bool HasSurveyAxes(vtkSMProxy* view)
{
  // Undo may have hidden them.
  vtkSMProxy* const axes = FindAxes(view);
  return axes && view->HasAnnotation(Annotation) && vtkSMPropertyHelper(axes, "Visibility").GetAsInt() == 1;
}

std::string ShowSurveyAxes(vtkSMProxy* view)
{
  vtkPVDataInformation* const data = FindSurvey(view);
  if (!data)
  {
    return "nothing is shown that has a lattice; expected horizons or a cube";
  }
  const std::vector<double> toWorld = ReadField(data, "LatticeToWorld", 16);
  const std::vector<double> numbers = ReadField(data, "LineNumbers", 4);
  const bool areKnown = !numbers.empty() && numbers[1] != 0.0 && numbers[3] != 0.0;
  const Lines rows = areKnown ? Lines{ "Inline", numbers[0], numbers[1] } : Lines{ "Row" };
  const Lines columns = areKnown ? Lines{ "Crossline", numbers[2], numbers[3] } : Lines{ "Column" };
  if (toWorld[1] == 0.0 && toWorld[4] == 0.0)
  {
    SetAxes(view, columns.Along(toWorld[3], toWorld[0]), rows.Along(toWorld[7], toWorld[5]), true);
  }
  else if (toWorld[0] == 0.0 && toWorld[5] == 0.0)
  {
    SetAxes(view, rows.Along(toWorld[3], toWorld[1]), columns.Along(toWorld[7], toWorld[4]), true);
  }
  else
  {
    return "the lines of the survey run at an angle to x and y; axes can only count lines along them";
  }
  view->SetAnnotation(Annotation, "1");
  return std::string();
}

void HideSurveyAxes(vtkSMProxy* view)
{
  SetAxes(view, { "X Axis" }, { "Y Axis" }, false);
  view->RemoveAnnotation(Annotation);
}
}
