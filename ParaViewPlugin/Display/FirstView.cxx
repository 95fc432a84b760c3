// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FirstView.h"

#include "Common/Horizon/DataModel.h"
#include "ViewAxes.h"
#include "ViewContents.h"

#include "vtkCamera.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
using ViewDirection = std::array<double, 3>;

constexpr const char* OwnCamera = "SeismicHorizons.Camera";
constexpr ViewDirection Oblique = { 0.35, -0.75, 0.56 }; // Direction to the eye.

bool IsOfSurvey(vtkPVDataInformation* data)
{
  return !ReadField(data, FieldArray::LatticeDimensions, 3).empty();
}

bool Has(vtkSMProxy* proxy, const char* property, const std::string& text)
{
  return proxy->GetProperty(property) && vtkSMPropertyHelper(proxy, property).GetAsString() == text;
}

/// Returns 0 for a line along i, 1 along j, else -1.
int FindLine(const std::vector<double>& dimensions, vtkSMProxy* representation)
{
  if (dimensions[0] == 1.0 || dimensions[1] == 1.0)
  {
    return dimensions[0] > 1.0 ? 0 : 1;
  }
  if (!Has(representation, "Representation", "Slice"))
  {
    return -1;
  }
  return Has(representation, "SliceMode", "XZ Plane") ? 0 : Has(representation, "SliceMode", "YZ Plane") ? 1 : -1;
}

/// Looks at a line from its side, at a survey from above, and at a section of a cube from between.
ViewDirection FindDirection(
  const std::vector<double>& dimensions, const std::vector<double>& toWorld, vtkSMProxy* representation)
{
  const int along = FindLine(dimensions, representation);
  const std::array<double, 2> line = along < 0
    ? std::array<double, 2>()
    : std::array<double, 2>{ toWorld[std::size_t(along)], toWorld[std::size_t(4 + along)] };
  const double length = std::hypot(line[0], line[1]);
  if (!(length > 0.0))
  {
    return Oblique;
  }
  // Looks from the south, or from the east of a line that runs north, so that it starts on the left.
  const double side = line[0] > 0.0 || (line[0] == 0.0 && line[1] > 0.0) ? 1.0 : -1.0;
  const std::array<double, 2> right = { side * line[0] / length, side * line[1] / length };
  const bool isOfCube = std::min(dimensions[0], dimensions[1]) > 1.0;
  const double turn = isOfCube ? 0.35 : 0.0;
  return { right[1] + turn * right[0], -right[0] + turn * right[1], turn };
}

std::string DescribeCamera(vtkSMProxy* view)
{
  auto* const rendered = vtkSMRenderViewProxy::SafeDownCast(view);
  vtkCamera* const camera = rendered ? rendered->GetActiveCamera() : nullptr;
  std::string text;
  for (const double* const place : camera
      ? std::vector<const double*>{ camera->GetPosition(), camera->GetFocalPoint(), camera->GetViewUp() }
      : std::vector<const double*>())
  {
    text += std::to_string(place[0]) + " " + std::to_string(place[1]) + " " + std::to_string(place[2]) + " ";
  }
  return text;
}

void LookFrom(vtkSMProxy* view, const ViewDirection& direction)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", view);
  const ViewDirection focus = { 0.0, 0.0, 0.0 };
  const ViewDirection up = { 0.0, 0.0, 1.0 };
  vtkSMPropertyHelper(view, "CameraPosition").Set(direction.data(), 3);
  vtkSMPropertyHelper(view, "CameraFocalPoint").Set(focus.data(), 3);
  vtkSMPropertyHelper(view, "CameraViewUp").Set(up.data(), 3);
  view->UpdateVTKObjects();
}

bool IsCameraMoved(vtkSMProxy* view)
{
  return !view->HasAnnotation(OwnCamera) || DescribeCamera(view) != view->GetAnnotation(OwnCamera);
}
}

//----------------------------------------------------------------------------------------------------------------------
bool ShowsOthers(vtkSMProxy* view, vtkSMProxy* representation)
{
  vtkSMProxy* const producer = representation ? FindProducer(representation) : nullptr;
  const std::vector<vtkSMProxy*> all = ListRepresentations(view);
  return std::any_of(all.begin(), all.end(),
    [representation, producer](vtkSMProxy* other)
    {
      const bool isOwn = other == representation || (producer && FindProducer(other) == producer);
      vtkPVDataInformation* const data = isOwn ? nullptr : FindShownData(other);
      // The map or the points from which a horizon was made were seen from above.
      const bool isRaw = data && producer && !IsOfSurvey(data) && LeadsTo(FindProducer(other), producer);
      return data && !isRaw;
    });
}

//----------------------------------------------------------------------------------------------------------------------
bool SetFirstView(vtkSMProxy* view, vtkSMProxy* representation)
{
  vtkPVDataInformation* const data = FindShownData(representation);
  if (!data)
  {
    return false;
  }
  const std::vector<double> dimensions = ReadField(data, FieldArray::LatticeDimensions, 3);
  const std::vector<double> toWorld = ReadField(data, FieldArray::LatticeToWorld, 16);
  if (dimensions.empty() || toWorld.empty())
  {
    return false;
  }
  LookFrom(view, FindDirection(dimensions, toWorld, representation));
  SetVerticalExaggeration(view, SuggestVerticalExaggeration(view));
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
bool IsFirst(vtkSMProxy* view, vtkSMProxy* representation)
{
  const std::vector<vtkSMProxy*> all = ListRepresentations(view);
  const bool isAnyShown = std::any_of(all.begin(), all.end(),
    [representation](vtkSMProxy* other)
    { return FindProducer(other) != FindProducer(representation) && FindShownData(other); });
  return !ShowsOthers(view, representation) && !(isAnyShown && IsCameraMoved(view));
}

//----------------------------------------------------------------------------------------------------------------------
bool MayFollow(vtkSMProxy* view, vtkSMProxy* representation)
{
  vtkPVDataInformation* const data = FindShownData(representation);
  return data && IsOfSurvey(data) && FindProducer(representation)->GetNumberOfProducers() == 0 && !IsCameraMoved(view);
}

//----------------------------------------------------------------------------------------------------------------------
void MarkCamera(vtkSMProxy* view)
{
  view->SetAnnotation(OwnCamera, DescribeCamera(view).c_str());
}
}
