// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonText.h"

#include "Common/Base/Errors.h"
#include "PickPrinter.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace SeismicHorizons
{
namespace
{
void AddNew(std::vector<std::string>& names, const std::vector<PickAttribute>& attributes)
{
  for (const PickAttribute& attribute : attributes)
  {
    const bool isPlace = attribute.Name == LineX || attribute.Name == LineY;
    if (!isPlace && std::find(names.begin(), names.end(), attribute.Name) == names.end())
    {
      names.push_back(attribute.Name);
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void PrintHorizonText(const std::vector<NamedHorizon>& horizons, const HorizonTextOptions& options,
  std::ostream& stream, const Monitor& monitor)
{
  PrintedColumns columns;
  columns.HasNames = horizons.size() > 1;
  columns.HasLines = true;
  const auto part = [&horizons](std::size_t number, const Monitor& step)
  {
    const auto size = double(horizons.size());
    return step.Step(double(number) / size, double(number + 1) / size);
  };
  const int sign = SignOfTable(horizons.front().Data, options.Sense); // The header says one direction.
  bool isSameUnit = true;
  std::vector<HorizonColumns> sampled;
  for (const NamedHorizon& horizon : horizons)
  {
    const Monitor step = part(sampled.size(), monitor.Step(0.0, 0.5));
    PrefixErrors(horizon.Name, [&]() { sampled.push_back(SampleHorizon(horizon.Data, sign, step)); });
    isSameUnit = isSameUnit && sampled.back().Survey.VerticalUnit == sampled.front().Survey.VerticalUnit;
    sampled.back().Name = horizon.Name;
    columns.HasLines = columns.HasLines && sampled.back().Lattice.Lines;
    if (options.WithAttributes)
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
}
