// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridPlacement.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Lattice.h"
#include "LatticeFrame.h"
#include "PickWarnings.h"
#include "VerticalSense.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
void CheckLattice(const SurveyLattice& lattice)
{
  const Eigen::Vector2d last =
    lattice.Origin + lattice.Columns[0] * lattice.ColumnStep + lattice.Columns[1] * lattice.RowStep;
  if (!lattice.Origin.allFinite() || !last.allFinite() || AreParallel(lattice.ColumnStep, lattice.RowStep))
  {
    throw InputError("nodes from " + ToText(lattice.Origin) + " in steps of " + ToText(lattice.ColumnStep) + " and " +
      ToText(lattice.RowStep) + ", expected finite coordinates, and steps that are not parallel");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons PlaceGrid(HorizonGrid grid, const NullValues& nulls)
{
  std::replace_if(
    grid.Z.begin(), grid.Z.end(), [&nulls](double z) { return nulls.IsNullNumber(z); }, NoValue);
  CheckLattice(grid.Lattice);
  std::string sense = FindSense(grid.Survey, grid.Z);
  LatticeHorizon horizon;
  std::vector<std::size_t> nodes;
  std::size_t node = 0;
  for (int j = 0; j < grid.Lattice.Columns[1]; ++j)
  {
    for (int i = 0; i < grid.Lattice.Columns[0]; ++i, ++node)
    {
      if (!std::isnan(grid.Z[node]))
      {
        nodes.push_back(node);
        horizon.Column.push_back({ i, j });
      }
    }
  }
  horizon.SurfaceId = 1;
  horizon.DroppedNulls = std::int64_t(grid.Z.size() - nodes.size());
  horizon.RealZ = Gather<HeapArray<double>>(std::exchange(grid.Z, {}), nodes);
  for (PickAttribute& attribute : grid.Attributes)
  {
    horizon.Attributes.emplace_back(
      attribute.Name, Gather<HeapArray<double>>(std::exchange(attribute.Values, {}), nodes));
  }
  SurveyHorizons survey;
  WarnOfNulls({ horizon.RealZ.begin(), horizon.RealZ.end() }, survey.Warnings);
  survey.Survey = grid.Survey;
  survey.Sense = std::move(sense);
  survey.Lattice = grid.Lattice;
  survey.Horizons.push_back(std::move(horizon));
  return survey;
}
}
