// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultLineHorizon.h"

#include "Common/Horizon/DataModel.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
bool AreNegative(const std::vector<SpacePoint>& places)
{
  return std::none_of(places.begin(), places.end(), [](const SpacePoint& place) { return place.Z > 0.0; }) &&
    std::any_of(places.begin(), places.end(), [](const SpacePoint& place) { return place.Z < 0.0; });
}

/// Lines have their points one after the other.
Cells MakeFaultCells(const FaultLineFile& file)
{
  Cells cells = { NewArray<std::int64_t>("", std::int64_t(file.Ends.size()) + 1),
    NewArray<std::int64_t>("", std::int64_t(file.Places.size())) };
  auto* const offsets = cells.Offsets.As<std::int64_t>();
  offsets[0] = 0;
  std::copy(file.Ends.begin(), file.Ends.end(), offsets + 1);
  auto* const points = cells.Points.As<std::int64_t>();
  std::iota(points, points + file.Places.size(), std::int64_t(0));
  return cells;
}
}

//----------------------------------------------------------------------------------------------------------------------
Horizon MakeFaultLines(const FaultLineFile& file, std::optional<VerticalDirection> direction)
{
  const bool isUp = direction ? *direction == VerticalDirection::Up : AreNegative(file.Places);
  const double upwards = isUp || file.IsUpright ? 1.0 : -1.0;
  Horizon lines;
  lines.Places = NewArray<double>("Points", std::int64_t(file.Places.size()), 3);
  auto* coordinate = lines.Places.As<double>();
  for (const SpacePoint& place : file.Places)
  {
    *coordinate++ = place.X;
    *coordinate++ = place.Y;
    *coordinate++ = upwards * place.Z;
  }
  lines.Lines = MakeFaultCells(file);
  if (std::any_of(file.Names.begin(), file.Names.end(), [](const std::string& name) { return !name.empty(); }))
  {
    lines.CellData.Add({ CellArray::FaultName, file.Names });
  }
  return lines;
}
}
