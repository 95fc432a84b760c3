// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurveyHorizonSource.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Survey/HorizonDataSet.h"
#include "Common/Survey/SurveyFrame.h"
#include "Common/Survey/Units.h"
#include "Common/VTK/HorizonConversion.h"

#include "vtkPolyData.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

using namespace SeismicHorizons;

//----------------------------------------------------------------------------------------------------------------------
vtkSurveyHorizonSource::vtkSurveyHorizonSource() = default;

//----------------------------------------------------------------------------------------------------------------------
vtkSurveyHorizonSource::~vtkSurveyHorizonSource()
{
  this->SetVerticalUnit(nullptr);
  this->SetVerticalDomain(nullptr);
  this->SetHorizontalUnit(nullptr);
  this->SetCoordinateSystem(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkSurveyHorizonSource::CheckParameters()
{
  this->Superclass::CheckParameters();
  FindVerticalSamplings({}, this->VerticalStep);
}

//----------------------------------------------------------------------------------------------------------------------
bool vtkSurveyHorizonSource::IsUpright(const SurveyDescription& survey) const
{
  return this->VerticalDirection == Automatic ? survey.IsUpright : this->VerticalDirection == Up;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataObject>> vtkSurveyHorizonSource::MakeHorizons(
  const std::vector<int>& numbers, const Monitor& monitor)
{
  SurveyHorizons survey = this->ReadSurvey(monitor.Step(0.0, 0.8));
  const std::string replaced = OverrideSurvey(
    survey.Survey, this->VerticalUnit, this->VerticalDomain, this->HorizontalUnit, this->CoordinateSystem);
  if (!replaced.empty())
  {
    survey.Warnings.push_back(replaced);
  }
  for (const std::string& warning : survey.Warnings)
  {
    vtkWarningMacro(<< this->ErrorPrefix() << warning);
  }
  RequireAnyPoints(survey.Horizons, this->ErrorPrefix());
  using Direction = SeismicHorizons::VerticalDirection;
  const auto direction = this->VerticalDirection == Automatic
    ? std::nullopt
    : std::optional<Direction>(this->VerticalDirection == Up ? Direction::Up : Direction::Down);
  const FramedSurvey framed = FrameSurvey(survey, this->VerticalStep, direction, monitor.Step(0.8, 0.85));
  for (const std::string& warning : framed.Warnings)
  {
    vtkWarningMacro(<< this->ErrorPrefix() << warning);
  }
  std::vector<vtkSmartPointer<vtkDataObject>> horizons;
  for (const int number : numbers)
  {
    horizons.push_back(ToVTK(TakeHorizonPoints(survey, framed, std::size_t(number))));
    monitor.Progress(0.85 + 0.15 * static_cast<double>(horizons.size()) / static_cast<double>(numbers.size()));
  }
  const std::string format = this->DescribeFormat();
  this->Description = format + (format.empty() ? "" : "\n") + framed.Description;
  return horizons;
}
