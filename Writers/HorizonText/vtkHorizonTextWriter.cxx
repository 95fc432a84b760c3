// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonTextWriter.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "PickPrinter.h"
#include "Writers/HorizonSampling.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace SeismicHorizons;

namespace
{
void AddNew(std::vector<std::string>& names, const std::vector<PickAttribute>& attributes)
{
  for (const PickAttribute& attribute : attributes)
  {
    if (std::find(names.begin(), names.end(), attribute.Name) == names.end())
    {
      names.push_back(attribute.Name);
    }
  }
}
}

vtkStandardNewMacro(vtkHorizonTextWriter);

//----------------------------------------------------------------------------------------------------------------------
/// The header names the attributes of all horizons, so that all are sampled before the first is printed.
void vtkHorizonTextWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  PrintedColumns columns;
  columns.HasNames = horizons.size() > 1;
  columns.HasLines = true;
  const auto part = [&horizons](std::size_t number, const Monitor& step)
  {
    const auto size = static_cast<double>(horizons.size());
    return step.Step(static_cast<double>(number) / size, static_cast<double>(number + 1) / size);
  };
  const int sign = this->VerticalSign(horizons.front().Data); // The header says one direction.
  bool isSameUnit = true;
  std::vector<HorizonColumns> sampled;
  for (const NamedHorizon& horizon : horizons)
  {
    const Monitor step = part(sampled.size(), monitor.Step(0.0, 0.5));
    PrefixErrors(horizon.Name, [&]() { sampled.push_back(SampleHorizon(horizon.Data, sign, step)); });
    isSameUnit = isSameUnit && sampled.back().Survey.VerticalUnit == sampled.front().Survey.VerticalUnit;
    sampled.back().Name = horizon.Name;
    columns.HasLines = columns.HasLines && sampled.back().Lattice.Lines;
    if (this->WriteAttributes)
    {
      AddNew(columns.Attributes, sampled.back().Attributes);
    }
  }
  columns.Survey = isSameUnit ? sampled.front().Survey : SurveyDescription();
  columns.Survey.IsUpright = sign > 0;
  PrintPickHeader(stream, columns);
  for (std::size_t number = 0; number < sampled.size(); ++number)
  {
    PrintPicks(stream, sampled[number], columns, part(number, monitor.Step(0.5, 1.0)));
  }
}
