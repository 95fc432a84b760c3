// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPickHorizonSource.h"

#include "Common/Base/Monitor.h"
#include "Common/Survey/PickPlacement.h"
#include "Common/Survey/PickWarnings.h"
#include "Common/Survey/ScatteredPicks.h"
#include "Common/Survey/VerticalSense.h"
#include "Common/Text/FileErrors.h"
#include "Filters/Algorithms/Gridding/Gridding.h"

#include "vtkHorizonFileSeries.h"

#include "vtkTimeStamp.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

using namespace SeismicHorizons;

namespace
{
CornerPoint MakeCorner(const double (&corner)[4])
{
  return { corner[0], corner[1], corner[2], corner[3] };
}
}

// ---- The class ------------------------------------------------------------------------------------------------------
struct vtkPickHorizonSource::SheetList
{
  vtkTimeStamp Time;
  std::vector<int> Numbers; // horizon of each sheet
  std::vector<std::int64_t> Sizes;
  std::optional<SurveyHorizons> Placed; // until they are used
};

//----------------------------------------------------------------------------------------------------------------------
vtkPickHorizonSource::vtkPickHorizonSource() = default;

//----------------------------------------------------------------------------------------------------------------------
vtkPickHorizonSource::~vtkPickHorizonSource() = default;

//----------------------------------------------------------------------------------------------------------------------
PlacementOptions vtkPickHorizonSource::MakeOptions(const SurveyDescription& survey)
{
  PlacementOptions options;
  using Source = SeismicHorizons::LatticeSource;
  options.Source = this->LatticeSource == NoLattice ? Source::OriginAndSteps : Source(this->LatticeSource);
  options.Corners = { MakeCorner(this->FirstCorner), MakeCorner(this->SecondCorner), MakeCorner(this->ThirdCorner) };
  options.Origin = Eigen::Vector2d(this->Origin);
  options.ColumnStep = Eigen::Vector2d(this->ColumnStep);
  options.RowStep = Eigen::Vector2d(this->RowStep);
  options.Tolerance = this->LatticeTolerance;
  options.LeaveOutStrays = this->StrayPicks == LeaveOut;
  options.Policy = static_cast<SeismicHorizons::DuplicatePolicy>(this->DuplicatePolicy);
  using Direction = SeismicHorizons::VerticalDirection;
  options.Direction = this->IsUpright(survey) ? Direction::Up : Direction::Down;
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkPickHorizonSource::CheckParameters()
{
  this->Superclass::CheckParameters();
  CheckPlacement(this->MakeOptions({}));
  if (this->Gridding != NoGridding && this->DuplicatePolicy == Sheets)
  {
    throw InputError("DuplicatePolicy Sheets with Gridding, expected one z for each column");
  }
  if (this->Gridding != NoGridding && this->LatticeSource == NoLattice)
  {
    throw InputError("LatticeSource NoLattice with Gridding, expected FromPoints or OriginAndSteps");
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Sheets are known only after points are on columns.
std::vector<std::string> vtkPickHorizonSource::ListHorizons(const Monitor& monitor)
{
  const std::vector<std::string> names = this->ListNames(monitor.Step(0.0, 0.5));
  if (this->DuplicatePolicy != Sheets)
  {
    this->ListedSheets.reset();
    return names;
  }
  // Choosing horizons does not change sheets.
  const vtkMTimeType changed = std::max(this->vtkAlgorithm::GetMTime(), this->GetPickTime());
  if (!this->ListedSheets || this->ListedSheets->Time.GetMTime() < changed)
  {
    this->ListedSheets.reset();
    this->CheckParameters(); // Wrong parameters must not look like errors of the file.
    auto list = std::make_unique<SheetList>();
    list->Placed = this->PlaceAll(monitor.Step(0.5, 1.0));
    for (const LatticeHorizon& sheet : list->Placed->Horizons)
    {
      list->Numbers.push_back(sheet.SurfaceId - 1);
      list->Sizes.push_back(std::int64_t(sheet.RealZ.size()));
    }
    list->Time.Modified();
    this->ListedSheets = std::move(list);
  }
  std::vector<std::string> ofSheets;
  for (const int number : this->ListedSheets->Numbers)
  {
    assert(std::size_t(number) < names.size());
    ofSheets.push_back(names[number]);
  }
  return ofSheets;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int64_t> vtkPickHorizonSource::CountHorizonPoints()
{
  return this->ListedSheets ? this->ListedSheets->Sizes : this->CountPicks();
}

//----------------------------------------------------------------------------------------------------------------------
/// The points behind the list are used once: kept, they would double the memory of the output.
SurveyHorizons vtkPickHorizonSource::ReadSurvey(const Monitor& monitor)
{
  if (this->ListedSheets && this->ListedSheets->Placed)
  {
    return *std::exchange(this->ListedSheets->Placed, std::nullopt);
  }
  return this->PlaceAll(monitor);
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons vtkPickHorizonSource::Place(PickTable picks, const Monitor& monitor)
{
  std::string sense = FindSense(picks.Survey, picks.Z);
  GriddingOptions options;
  options.Method = this->Gridding == Plate ? GriddingMethod::Plate : GriddingMethod::Nearest;
  options.Radius = this->GriddingRadius;
  options.Smoothing = this->GriddingSmoothing;
  options.Placement = this->MakeOptions(picks.Survey);
  SurveyHorizons placed = this->LatticeSource == NoLattice ? KeepPlaces(std::move(picks))
    : this->Gridding == NoGridding                         ? PlacePicks(std::move(picks), options.Placement, monitor)
                                                           : GridPicks(std::move(picks), options, monitor);
  placed.Sense = std::move(sense);
  return placed;
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons vtkPickHorizonSource::PlaceAll(const Monitor& monitor)
{
  PickTable picks = this->ReadPicks(monitor.Step(0.0, 0.6));
  const auto place = [&]() { return this->Place(std::move(picks), monitor.Step(0.6, 1.0)); };
  FileSeries* const files = this->GetFiles();
  SurveyHorizons placed = files ? PrefixFileErrors(files->GetCurrent(), place) : place();
  if (placed.IsOnLattice)
  {
    placed.Warnings = FindWarnings(placed, SeismicHorizons::DuplicatePolicy(this->DuplicatePolicy));
  }
  return placed;
}
