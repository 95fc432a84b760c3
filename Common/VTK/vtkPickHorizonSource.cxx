// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPickHorizonSource.h"

#include "Common/Errors.h"
#include "Common/Monitor.h"
#include "Common/Survey/PickPlacement.h"

#include <array>

using namespace SeismicHorizons;

namespace
{
CornerPoint MakeCorner(const double (&corner)[4])
{
  return { corner[0], corner[1], corner[2], corner[3] };
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkPickHorizonSource::vtkPickHorizonSource() = default;

//----------------------------------------------------------------------------------------------------------------------
vtkPickHorizonSource::~vtkPickHorizonSource() = default;

//----------------------------------------------------------------------------------------------------------------------
PlacementOptions vtkPickHorizonSource::MakeOptions()
{
  PlacementOptions options;
  options.Source = static_cast<SeismicHorizons::LatticeSource>(this->LatticeSource);
  options.Corners = { MakeCorner(this->FirstCorner), MakeCorner(this->SecondCorner), MakeCorner(this->ThirdCorner) };
  options.Origin = Eigen::Vector2d(this->Origin);
  options.ColumnStep = Eigen::Vector2d(this->ColumnStep);
  options.RowStep = Eigen::Vector2d(this->RowStep);
  options.Tolerance = this->LatticeTolerance;
  options.Policy = static_cast<SeismicHorizons::DuplicatePolicy>(this->DuplicatePolicy);
  using Direction = SeismicHorizons::VerticalDirection;
  options.Direction = this->GetVerticalDirection() == Up ? Direction::Up : Direction::Down;
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkPickHorizonSource::CheckParameters()
{
  this->Superclass::CheckParameters();
  CheckPlacement(this->MakeOptions());
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons vtkPickHorizonSource::ReadSurvey(const Monitor& monitor)
{
  PickTable picks = this->ReadPicks(monitor.Step(0.0, 0.6));
  try
  {
    return PlacePicks(std::move(picks), this->MakeOptions(), monitor.Step(0.6, 1.0));
  }
  catch (const InputError& error)
  {
    throw InputError(this->ErrorPrefix() + error.what());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void vtkPickHorizonSource::PrintSelf(ostream& os, vtkIndent indent)
{
  constexpr std::array<const char*, 3> sources = { "FromPoints", "CornerPoints", "OriginAndSteps" };
  constexpr std::array<const char*, 3> policies = { "StrongestAmplitude", "Topmost", "Lowest" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LatticeSource: " << sources[static_cast<std::size_t>(this->LatticeSource)] << '\n';
  os << indent << "FirstCorner: " << ToText(Eigen::Vector4d(this->FirstCorner)) << '\n';
  os << indent << "SecondCorner: " << ToText(Eigen::Vector4d(this->SecondCorner)) << '\n';
  os << indent << "ThirdCorner: " << ToText(Eigen::Vector4d(this->ThirdCorner)) << '\n';
  os << indent << "Origin: " << ToText(Eigen::Vector2d(this->Origin)) << '\n';
  os << indent << "ColumnStep: " << ToText(Eigen::Vector2d(this->ColumnStep)) << '\n';
  os << indent << "RowStep: " << ToText(Eigen::Vector2d(this->RowStep)) << '\n';
  os << indent << "LatticeTolerance: " << this->LatticeTolerance << '\n';
  os << indent << "DuplicatePolicy: " << policies[static_cast<std::size_t>(this->DuplicatePolicy)] << '\n';
}
