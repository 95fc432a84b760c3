// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickBlock.h"

#include "Common/Horizon/Types.h"
#include "Readers/GOCADTSurf/TSurfParser.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Objects before may lack the property.
void AddProperty(const TSurfProperty& property, std::size_t first, PickTable& picks)
{
  for (std::size_t component = 0; component < property.Size; ++component)
  {
    const std::string name = property.Name + (property.Size > 1 ? " " + std::to_string(component + 1) : "");
    auto found = std::find_if(picks.Attributes.begin(), picks.Attributes.end(),
      [&name](const PickAttribute& attribute) { return attribute.Name == name; });
    if (found == picks.Attributes.end())
    {
      picks.Attributes.push_back({ name, {} });
      found = picks.Attributes.end() - 1;
    }
    found->Values.resize(first, NoValue);
    for (std::size_t n = component; n < property.Values.size(); n += property.Size)
    {
      found->Values.push_back(property.Values[n]);
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
PickTable ReadVSets(std::istream& stream, const NullValues& nulls, const Monitor& monitor)
{
  PickTable picks;
  const std::vector<TSurf> sets = LoadTSurfs(
    stream, [](std::size_t) { return true; }, monitor, TSurfBufferSize, "vset");
  const VerticalPositive positive = sets.front().Positive;
  picks.Survey = sets.front().Survey;
  picks.Survey.IsUpright = positive == VerticalPositive::Elevation;
  for (const TSurf& set : sets)
  {
    const double sign = set.Positive == positive ? 1.0 : -1.0; // z is as that of the first object.
    for (const TSurfProperty& property : set.Properties)
    {
      AddProperty(property, picks.Size(), picks);
    }
    for (const auto& [x, y, z] : set.Vertices)
    {
      picks.X.push_back(x);
      picks.Y.push_back(y);
      picks.Z.push_back(nulls.IsNullNumber(z) ? NoValue : sign * z);
      picks.Horizon.push_back(int(picks.Names.size()));
    }
    picks.Names.push_back(set.Name);
  }
  for (PickAttribute& attribute : picks.Attributes)
  {
    attribute.Values.resize(picks.Size(), NoValue);
  }
  return picks;
}
}
