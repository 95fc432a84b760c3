// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGOCADTSurfWriter.h"

#include "HorizonTSurf.h"

#include "vtkObjectFactory.h"

#include <string>

using namespace SeismicHorizons;

namespace
{
std::string TextOrEmpty(const char* text)
{
  return text ? text : "";
}
}

vtkStandardNewMacro(vtkGOCADTSurfWriter);

//----------------------------------------------------------------------------------------------------------------------
vtkGOCADTSurfWriter::~vtkGOCADTSurfWriter()
{
  this->SetVerticalUnit(nullptr);
  this->SetHorizontalUnit(nullptr);
  this->SetCoordinateSystemName(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkGOCADTSurfWriter::PrintHorizons(
  const std::vector<WrittenHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  TSurfOptions options;
  options.Positive = static_cast<SeismicHorizons::VerticalPositive>(this->VerticalPositive);
  options.Survey.VerticalUnit = TextOrEmpty(this->VerticalUnit);
  options.Survey.HorizontalUnit = TextOrEmpty(this->HorizontalUnit);
  options.Survey.CoordinateSystem = TextOrEmpty(this->CoordinateSystemName);
  options.Arrays = static_cast<WrittenArrays>(this->WriteAttributes);
  options.WithBorders = this->WriteBorders;
  PrintTSurfs(ToPlain(horizons), options, stream, monitor);
}
