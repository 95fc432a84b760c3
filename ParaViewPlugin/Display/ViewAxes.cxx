// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewAxes.h"

#include "Common/Horizon/DataModel.h"
#include "ShownAxis.h"
#include "ViewContents.h"

#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
vtkSMProxy* FindAxes(vtkSMProxy* view)
{
  return vtkSMPropertyHelper(view, "AxesGrid", true).GetAsProxy();
}

constexpr const char* TitleMargin = "\n      ";

std::string AxisTitle(const std::string& name)
{
  // ParaView puts titles at the middle number, without a setting.
  return TitleMargin + name + "      \n";
}

/// Returns -1 if the vertical axis counts -z.
double FindSense(vtkSMProxy* axes)
{
  return vtkSMPropertyHelper(axes, "DataScale").GetAsDouble(2) < 0.0 ? -1.0 : 1.0;
}

// ---- Vertical exaggeration ------------------------------------------------------------------------------------------

constexpr const char* ExaggerationAnnotation = "SeismicHorizons.VerticalExaggeration";
constexpr double FlatShare = 0.1; // Fractions of the width.
constexpr double SteepShare = 0.5; // As of vertical indices, which are no lengths.
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

/// The result is 0.5, 1, 2, 5, 10, 20, 50 and so on, at most `number`.
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

// ---- Survey axes ----------------------------------------------------------------------------------------------------

// A view's axes can show a model that a matrix maps to the world. This model has line numbers as x and y, and unchanged
// z.

constexpr const char* AxesAnnotation = "SeismicHorizons.SurveyAxes";

struct Lines
{
  std::string Name;
  double First = 0.0;
  double Step = 1.0;
  double Count = 0.0; // an integer of at least 1
  std::array<double, 2> Spacing = {}; // World x and y between lines.

  std::array<double, 2> PerNumber() const { return { this->Spacing[0] / this->Step, this->Spacing[1] / this->Step }; }
};

struct Survey
{
  std::array<Lines, 2> Directions; // Right-handed as seen from +z; otherwise axes would hide behind the data.
  std::array<double, 2> Origin = {}; // world x and y of the first lines
};

double Cross(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

bool ReadSurvey(vtkPVDataInformation* data, Survey& survey)
{
  const std::vector<double> toWorld = ReadField(data, "LatticeToWorld", 16);
  const std::vector<double> dimensions = ReadField(data, "LatticeDimensions", 3);
  if (toWorld.empty() || dimensions.empty() || !(dimensions[0] >= 1.0 && dimensions[1] >= 1.0))
  {
    return false;
  }
  const std::vector<double> numbers = ReadField(data, "LineNumbers", 4);
  const bool areKnown =
    !numbers.empty() && std::isfinite(numbers[0] + numbers[2]) && std::fabs(numbers[1] * numbers[3]) > 0.0;
  Lines columns = areKnown ? Lines{ "Crossline", numbers[2], numbers[3] } : Lines{ "Column" };
  Lines rows = areKnown ? Lines{ "Inline", numbers[0], numbers[1] } : Lines{ "Row" };
  columns.Count = dimensions[0];
  rows.Count = dimensions[1];
  columns.Spacing = { toWorld[0], toWorld[4] };
  rows.Spacing = { toWorld[1], toWorld[5] };
  survey.Origin = { toWorld[3], toWorld[7] };
  survey.Directions = { columns, rows };
  const double area = Cross(columns.PerNumber(), rows.PerNumber());
  if (area < 0.0)
  {
    std::swap(survey.Directions[0], survey.Directions[1]);
  }
  return area != 0.0 && std::isfinite(area);
}

/// The matrix is row-major.
std::vector<double> ToWorld(const Survey& survey, double verticalExaggeration)
{
  const std::array<double, 2> x = survey.Directions[0].PerNumber();
  const std::array<double, 2> y = survey.Directions[1].PerNumber();
  std::vector<double> matrix(16, 0.0);
  for (std::size_t row : { 0, 1 })
  {
    matrix[4 * row] = x[row];
    matrix[4 * row + 1] = y[row];
    matrix[4 * row + 3] =
      survey.Origin[row] - x[row] * survey.Directions[0].First - y[row] * survey.Directions[1].First;
  }
  matrix[10] = verticalExaggeration;
  matrix[15] = 1.0;
  return matrix;
}

/// Returns line numbers around a world box, clipped to the survey, and z, or -z.
std::vector<double> FindBounds(const Survey& survey, const vtkBoundingBox& box, double sense)
{
  const std::array<double, 2> x = survey.Directions[0].Spacing;
  const std::array<double, 2> y = survey.Directions[1].Spacing;
  vtkBoundingBox lines; // Lines count from 0.
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::array<double, 2> place = { box.GetBound(corner % 2) - survey.Origin[0],
      box.GetBound(2 + corner / 2) - survey.Origin[1] };
    lines.AddPoint(Cross(place, y) / Cross(x, y), Cross(x, place) / Cross(x, y), 0.0);
  }
  std::vector<double> bounds;
  for (std::size_t n : { 0, 1 })
  {
    const Lines& direction = survey.Directions[n];
    const double last = direction.Count - 1.0;
    const double low = std::clamp(lines.GetBound(int(2 * n)), 0.0, last);
    const double high = std::clamp(lines.GetBound(int(2 * n + 1)), 0.0, last);
    const auto ends = std::minmax({ direction.First + direction.Step * low, direction.First + direction.Step * high });
    bounds.insert(bounds.end(), { ends.first, ends.second });
  }
  const auto heights = std::minmax({ sense * box.GetBound(4), sense * box.GetBound(5) });
  bounds.insert(bounds.end(), { heights.first, heights.second });
  return bounds;
}

struct AxesSettings
{
  bool AreShown = false;
  bool AreOfModel = false;
  std::string XTitle = "X Axis";
  std::string YTitle = "Y Axis";
  std::vector<double> Matrix;
  std::vector<double> Bounds;

  void Apply(vtkSMProxy* axes) const
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", axes);
    vtkSMPropertyHelper(axes, "Visibility").Set(this->AreShown ? 1 : 0);
    vtkSMPropertyHelper(axes, "UseModelTransform").Set(this->AreOfModel ? 1 : 0);
    vtkSMPropertyHelper(axes, "XTitle").Set(this->XTitle.c_str());
    vtkSMPropertyHelper(axes, "YTitle").Set(this->YTitle.c_str());
    for (const auto& [name, values] :
      { std::pair("ModelTransformMatrix", this->Matrix), std::pair("ModelBounds", this->Bounds) })
    {
      if (!values.empty())
      {
        vtkSMPropertyHelper(axes, name).Set(values.data(), static_cast<unsigned int>(values.size()));
      }
    }
    axes->UpdateVTKObjects();
  }
};

/// The vertical axis agrees with the legend then. Returns whether it did not before.
bool CountDownwards(vtkSMProxy* axes, bool isDownwards)
{
  if ((FindSense(axes) < 0.0) == isDownwards)
  {
    return false;
  }
  vtkSMPropertyHelper scale(axes, "DataScale");
  scale.Set(2, -scale.GetAsDouble(2));
  // Turned upside down, the front of the box is its back.
  vtkSMPropertyHelper(axes, "CullFrontface").Set(isDownwards ? 0 : 1);
  vtkSMPropertyHelper(axes, "CullBackface").Set(isDownwards ? 1 : 0);
  return true;
}

bool FindSurvey(vtkSMProxy* view, Survey& survey, vtkBoundingBox& box)
{
  bool isFound = false;
  for (vtkSMProxy* const representation : ListRepresentations(view))
  {
    if (vtkPVDataInformation* const data = FindShownData(representation))
    {
      isFound = isFound || ReadSurvey(data, survey);
      box.AddBounds(data->GetBounds());
    }
  }
  return isFound && box.IsValid();
}
}

//----------------------------------------------------------------------------------------------------------------------
double GetVerticalExaggeration(vtkSMProxy* view)
{
  // Without the annotation the user may have scaled the axes for a unit.
  vtkSMProxy* const axes = view->HasAnnotation(ExaggerationAnnotation) ? FindAxes(view) : nullptr;
  return axes ? std::fabs(vtkSMPropertyHelper(axes, "DataScale").GetAsDouble(2)) : 1.0;
}

//----------------------------------------------------------------------------------------------------------------------
void SetVerticalExaggeration(vtkSMProxy* view, double factor)
{
  view->SetAnnotation(ExaggerationAnnotation, "1");
  for (vtkSMProxy* const representation : ListRepresentations(view))
  {
    SetScale(representation, "Scale", factor);
  }
  if (vtkSMProxy* const axes = FindAxes(view))
  {
    SetScale(axes, "DataScale", factor * FindSense(axes));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ExaggerateRepresentation(vtkSMProxy* representation, vtkSMProxy* view)
{
  if (view->HasAnnotation(ExaggerationAnnotation))
  {
    SetScale(representation, "Scale", GetVerticalExaggeration(view));
  }
}

//----------------------------------------------------------------------------------------------------------------------
double SuggestVerticalExaggeration(vtkSMProxy* view)
{
  vtkBoundingBox box;
  bool areHorizons = true; // Sections may be as high as they are.
  for (vtkSMProxy* const representation : ListRepresentations(view))
  {
    vtkPVDataInformation* const data = FindShownData(representation);
    if (data && representation->GetProperty("Scale"))
    {
      box.AddBounds(data->GetBounds());
      areHorizons = areHorizons && data->GetArrayInformation(PointArray::Column, vtkDataObject::POINT);
    }
  }
  if (!box.IsValid())
  {
    return 1.0;
  }
  const double width = std::max(box.GetLength(0), box.GetLength(1));
  const double height = box.GetLength(2);
  const double factor = height > 0.0 && width > 0.0 ? GoodShare * width / height : 1.0;
  const bool isFlat = height < FlatShare * width, isSteep = areHorizons && height > SteepShare * width;
  return isFlat || isSteep ? RoundDown(factor) : 1.0;
}

//----------------------------------------------------------------------------------------------------------------------
bool HasSurveyAxes(vtkSMProxy* view)
{
  // Undo may have hidden the axes.
  vtkSMProxy* const axes = view->HasAnnotation(AxesAnnotation) ? FindAxes(view) : nullptr;
  return axes && vtkSMPropertyHelper(axes, "Visibility").GetAsInt() == 1 &&
    vtkSMPropertyHelper(axes, "UseModelTransform").GetAsInt() == 1;
}

//----------------------------------------------------------------------------------------------------------------------
std::string ShowSurveyAxes(vtkSMProxy* view)
{
  Survey survey;
  vtkBoundingBox box;
  if (!FindSurvey(view, survey, box))
  {
    return "nothing is shown that has a lattice; expected horizons or a cube";
  }
  AxesSettings settings;
  settings.AreShown = true;
  settings.AreOfModel = true;
  settings.XTitle = AxisTitle(survey.Directions[0].Name);
  settings.YTitle = AxisTitle(survey.Directions[1].Name);
  vtkSMProxy* const axes = FindAxes(view);
  settings.Matrix = ToWorld(survey, GetVerticalExaggeration(view) * FindSense(axes));
  settings.Bounds = FindBounds(survey, box, FindSense(axes));
  settings.Apply(axes);
  view->SetAnnotation(AxesAnnotation, "1");
  return std::string();
}

//----------------------------------------------------------------------------------------------------------------------
void RefreshSurveyAxes(vtkSMProxy* view)
{
  if (HasSurveyAxes(view))
  {
    ShowSurveyAxes(view); // If nothing is visible the last axes remain.
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HideSurveyAxes(vtkSMProxy* view)
{
  AxesSettings().Apply(FindAxes(view));
  view->RemoveAnnotation(AxesAnnotation);
}

//----------------------------------------------------------------------------------------------------------------------
void NameVerticalAxis(vtkSMProxy* view)
{
  std::set<std::string> names, units;
  bool isDownwards = true;
  for (vtkSMProxy* const representation : ListRepresentations(view))
  {
    vtkPVDataInformation* const data = FindShownData(representation);
    const VerticalAxis axis = data ? ReadVerticalAxis(data) : VerticalAxis();
    if (!axis.Name.empty())
    {
      names.insert(axis.Name);
      units.insert(axis.Unit);
      isDownwards = axis.IsDownwards;
    }
  }
  const bool isOfOne = names.size() == 1;
  const bool areOfUnit = units.size() == 1 && !units.begin()->empty();
  const std::string title = isOfOne ? AxisTitle(*names.begin())
    : areOfUnit                     ? AxisTitle("Z (" + *units.begin() + ")")
                                    : "Z Axis";
  vtkSMProxy* const axes = FindAxes(view);
  if (!axes)
  {
    return;
  }
  const std::string present = vtkSMPropertyHelper(axes, "ZTitle").GetAsString();
  if (present == "Z Axis" || present.rfind(TitleMargin, 0) == 0) // Otherwise the user has named it.
  {
    vtkSMPropertyHelper(axes, "ZTitle").Set(title.c_str());
  }
  const bool isTurned = CountDownwards(axes, isOfOne && isDownwards);
  axes->UpdateVTKObjects();
  if (isTurned)
  {
    RefreshSurveyAxes(view);
  }
}
}
