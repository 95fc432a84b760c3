// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGOCADTSurfWriter.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/VTK/HorizonName.h"
#include "HorizonTSurf.h"
#include "TSurfPrinter.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

using namespace SeismicHorizons;

namespace
{
constexpr const char* NoUnit = "none"; // GOCAD's word for properties without unit.

std::string FirstGiven(const char* parameter, const std::string& field, const std::string& otherwise)
{
  if (parameter && *parameter)
  {
    return parameter;
  }
  return field.empty() ? otherwise : field;
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
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  std::vector<std::string> names(horizons.size());
  std::transform(
    horizons.begin(), horizons.end(), names.begin(), [](const NamedHorizon& horizon) { return horizon.Name; });
  names = MakeDistinct(std::move(names));
  const auto size = static_cast<double>(horizons.size());
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    PrefixErrors(names[n],
      [&]()
      {
        const auto positive = static_cast<SeismicHorizons::VerticalPositive>(this->VerticalPositive);
        TSurf surface = MakeTSurf(horizons[n].Data, names[n], positive);
        if (this->WriteAttributes != NoArrays)
        {
          surface.Properties = ReadProperties(horizons[n].Data, this->WriteAttributes == AllArrays);
        }
        SurveyDescription& survey = surface.Survey;
        survey.VerticalUnit = FirstGiven(this->VerticalUnit, survey.VerticalUnit, NoUnit);
        survey.HorizontalUnit = FirstGiven(this->HorizontalUnit, survey.HorizontalUnit, NoUnit);
        survey.CoordinateSystem = FirstGiven(this->CoordinateSystemName, survey.CoordinateSystem, "Default");
        const Monitor step = monitor.Step(static_cast<double>(n) / size, static_cast<double>(n + 1) / size);
        PrintTSurf(surface, this->WriteBorders, stream, step);
      });
  }
}
