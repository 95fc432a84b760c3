// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ScatteredPicks.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
struct CoordinateRange
{
  double Least = std::numeric_limits<double>::infinity();
  double Greatest = -std::numeric_limits<double>::infinity();

  explicit CoordinateRange(const std::vector<double>& values)
  {
    for (const double value : values)
    {
      if (std::isfinite(value))
      {
        this->Least = std::min(this->Least, value);
        this->Greatest = std::max(this->Greatest, value);
      }
    }
  }
};
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons KeepPlaces(PickTable picks)
{
  if (!picks.HasPlaces())
  {
    throw InputError("LatticeSource NoLattice with only line numbers, expected x and y");
  }
  constexpr double columns = 1 << 30;
  const CoordinateRange x(picks.X);
  const CoordinateRange y(picks.Y);
  const double extent = std::max({ 0.0, x.Greatest - x.Least, y.Greatest - y.Least });
  const double step = extent > 0.0 ? extent / columns : 1.0;
  SurveyHorizons kept;
  kept.IsOnLattice = false;
  kept.Lattice.Origin = { x.Least, y.Least };
  kept.Lattice.ColumnStep = { step, 0.0 };
  kept.Lattice.RowStep = { 0.0, step };
  kept.Horizons.resize(picks.Names.size());
  for (std::size_t number = 0; number < kept.Horizons.size(); ++number)
  {
    kept.Horizons[number].SurfaceId = int(number) + 1;
    for (const PickAttribute& attribute : picks.Attributes)
    {
      kept.Horizons[number].Attributes.emplace_back(attribute.Name, HeapArray<double>());
    }
  }
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    LatticeHorizon& horizon = kept.Horizons[picks.Horizon.empty() ? 0 : std::size_t(picks.Horizon[pick])];
    if (!std::isfinite(picks.Z[pick]) || !std::isfinite(picks.X[pick]) || !std::isfinite(picks.Y[pick]))
    {
      ++horizon.DroppedNulls;
      continue;
    }
    horizon.Column.push_back(
      { int(std::lround((picks.X[pick] - x.Least) / step)), int(std::lround((picks.Y[pick] - y.Least) / step)) });
    horizon.RealZ.push_back(picks.Z[pick]);
    for (std::size_t n = 0; n < picks.Attributes.size(); ++n)
    {
      horizon.Attributes[n].second.push_back(picks.Attributes[n].Values[pick]);
    }
  }
  kept.Survey = std::move(picks.Survey);
  return kept;
}
}
