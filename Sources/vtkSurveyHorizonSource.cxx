// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurveyHorizonSource.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/SurveyHorizons.h"
#include "Common/Survey/Units.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonDataSet.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

namespace
{
using namespace SeismicHorizons;

/// Counts z below 0 and all z. A single negative value, such as -999, is no elevation and counts as none.
std::array<std::int64_t, 2> CountNegative(const std::vector<LatticeHorizon>& horizons)
{
  std::array<std::int64_t, 2> counts = { 0, 0 };
  double first = 0.0;
  bool isSingle = true;
  for (const LatticeHorizon& horizon : horizons)
  {
    counts[1] += std::int64_t(horizon.RealZ.size());
    for (const double z : horizon.RealZ)
    {
      counts[0] += z < 0.0 ? 1 : 0;
      first = first == 0.0 && z < 0.0 ? z : first;
      isSingle = isSingle && (z >= 0.0 || z == first);
    }
  }
  return { isSingle ? 0 : counts[0], counts[1] };
}

void AddConflictFields(const ConflictCount& conflicts, vtkFieldData* data)
{
  AddValue<vtkIdTypeArray>(data, FieldArray::DroppedRepeats, static_cast<vtkIdType>(conflicts.Repeats));
  AddValue<vtkDoubleArray>(data, FieldArray::LargestConflict, conflicts.Largest);
}

void RequireAnyPoints(const std::vector<LatticeHorizon>& horizons, const std::string& prefix)
{
  std::int64_t nulls = 0;
  for (const LatticeHorizon& horizon : horizons)
  {
    nulls += horizon.DroppedNulls;
    if (!horizon.RealZ.empty())
    {
      return;
    }
  }
  throw InputError(
    prefix + "no points, expected those of a horizon at least: all " + std::to_string(nulls) + " are without z");
}

std::string DescribeFrame(const LatticeFrame& frame, const std::vector<VerticalSampling>& samplings)
{
  const SurveyLattice& lattice = frame.Lattice;
  std::ostringstream text;
  text.precision(10);
  text << lattice.Columns[0] << " x " << lattice.Columns[1] << " columns from " << ToText(lattice.Origin)
       << " in steps of " << ToText(lattice.ColumnStep) << " and " << ToText(lattice.RowStep);
  if (lattice.Lines)
  {
    text << "\ncrosslines from " << lattice.Lines->FirstCrossline << " in steps of " << lattice.Lines->CrosslineStep
         << ", inlines from " << lattice.Lines->FirstInline << " in steps of " << lattice.Lines->InlineStep;
  }
  text.precision(3);
  text << "\npoints at most " << *frame.LatticeDeviation << " of a step off their columns";
  text.precision(10);
  if (samplings.empty())
  {
    return text.str();
  }
  const auto [least, most] = std::minmax_element(samplings.begin(), samplings.end(),
    [](const VerticalSampling& one, const VerticalSampling& other) { return one.Step < other.Step; });
  text << "\nvertical indices in steps of " << least->Step;
  if (most->Step > least->Step)
  {
    text << " to " << most->Step;
  }
  text << " " << (frame.Survey.VerticalUnit.empty() ? "(unit unknown)" : frame.Survey.VerticalUnit) << " to "
       << (frame.Direction == VerticalDirection::Down ? "smaller" : "larger") << " world z"
       << (most->Step > least->Step ? ", as suits each horizon" : "");
  return text.str();
}
}

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
  for (const std::string& warning : survey.Warnings)
  {
    vtkWarningMacro(<< this->ErrorPrefix() << warning);
  }
  RequireAnyPoints(survey.Horizons, this->ErrorPrefix());
  LatticeFrame frame;
  frame.Survey = survey.Survey;
  OverrideSurvey(frame.Survey, this->VerticalUnit, this->VerticalDomain, this->HorizontalUnit, this->CoordinateSystem);
  frame.Lattice = survey.Lattice;
  frame.LatticeDeviation = survey.LargestDistance;
  const std::vector<VerticalSampling> samplings =
    FindVerticalSamplings(survey.Horizons, this->VerticalStep, monitor.Step(0.8, 0.85));
  using Direction = SeismicHorizons::VerticalDirection;
  const bool isUp = this->IsUpright(survey.Survey);
  frame.Direction = isUp ? Direction::Up : Direction::Down;
  const auto [negative, all] = CountNegative(survey.Horizons);
  if (this->VerticalDirection == Automatic && !isUp && negative > 0)
  {
    vtkWarningMacro(<< this->ErrorPrefix() << negative << " of " << all
                    << " z are negative, so that these may be elevations or depths; they are taken to increase "
                       "downwards, which VerticalDirection Up turns, and Down confirms");
  }
  std::vector<vtkSmartPointer<vtkDataObject>> horizons;
  for (const int number : numbers)
  {
    frame.Sampling = samplings[number];
    const vtkSmartPointer<vtkPolyData> points = MakeHorizonPoints(std::move(survey.Horizons[number]), frame);
    if (!survey.Conflicts.empty())
    {
      AddConflictFields(survey.Conflicts[number], points->GetFieldData());
    }
    horizons.push_back(points);
    monitor.Progress(0.85 + 0.15 * static_cast<double>(horizons.size()) / static_cast<double>(numbers.size()));
  }
  const std::string format = this->DescribeFormat();
  this->Description = format + (format.empty() ? "" : "\n") + DescribeFrame(frame, samplings) + "\nz increases " +
    (isUp ? "upwards" : "downwards") +
    (this->VerticalDirection == Automatic
        ? ", " + survey.Sense + "; VerticalDirection " + (isUp ? "Down" : "Up") + " turns it"
        : ", as VerticalDirection says");
  return horizons;
}
