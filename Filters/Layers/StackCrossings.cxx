// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StackCrossings.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Algorithms/Layers/OrderedStack.h"
#include "Filters/Common/HorizonPoints.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<const char*, 4> PolicyNames = { "Mean", "UpperWins", "LowerWins", "Stop" };

/// The text has one policy per layer, from the top.
std::vector<CrossingPolicy> ParsePolicies(const std::string& text, std::size_t layers)
{
  std::vector<CrossingPolicy> policies;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    const auto found = std::find(PolicyNames.begin(), PolicyNames.end(), word);
    if (found == PolicyNames.end())
    {
      throw InputError("crossings \"" + word + "\", expected Mean, UpperWins, LowerWins or Stop");
    }
    policies.push_back(static_cast<CrossingPolicy>(found - PolicyNames.begin()));
  }
  if (!policies.empty() && policies.size() != layers)
  {
    throw InputError("crossings of " + std::to_string(policies.size()) + " layers, expected " + std::to_string(layers) +
      ", from the uppermost on");
  }
  return policies;
}

/// Repaired heights are world z.
Horizon MakeRepaired(const RepairedHorizons& repaired, std::size_t horizon, const HorizonStack& stack)
{
  const StackedHorizon& given = stack[horizon];
  const std::vector<double>& heights = repaired.Heights[horizon];
  Horizon output = given.Points.Horizon;
  output.Places = NewArray<double>("Points", std::int64_t(heights.size()), 3);
  auto* place = output.Places.As<double>();
  std::vector<double> moved(heights.size());
  std::vector<double> indices(heights.size());
  for (std::size_t point = 0; point < heights.size(); ++point)
  {
    Eigen::Vector3d world = given.Points.Horizon.Place(std::int64_t(point));
    moved[point] = heights[point] - world.z();
    world.z() = heights[point];
    place = std::copy_n(world.data(), 3, place);
    indices[point] = given.Points.Lattice.ToLattice(world).z();
  }
  ArrayTable& data = output.PointData;
  data.Remove(PointArray::RealZ);
  AddArray<double>(data, PointArray::VerticalIndex, indices);
  AddArray<double>(data, PointArray::Moved, moved);
  ActivateHeight(output);
  const RepairFigures& own = repaired.Repair.Horizons[horizon];
  AddValue<std::int64_t>(output.FieldData, FieldArray::MovedColumns, std::int64_t(own.Columns));
  AddValue<double>(output.FieldData, FieldArray::FarthestMove, own.Largest);
  return output;
}

/// Lists crossings of neighbours, and moved horizons.
std::string ReportRepair(const CrossingRepair& repair, const HorizonStack& stack)
{
  std::ostringstream text;
  for (std::size_t n = 0; n < repair.Interfaces.size(); ++n)
  {
    const RepairFigures& crossed = repair.Interfaces[n];
    text << stack[n].Name << " and " << stack[n + 1].Name << "\n  crossed in " << crossed.Columns << " columns";
    if (crossed.Columns > 0)
    {
      text << ", by up to " << crossed.Largest;
    }
    text << '\n';
  }
  for (std::size_t n = 0; n < repair.Horizons.size(); ++n)
  {
    const RepairFigures& moved = repair.Horizons[n];
    text << stack[n].Name << ": " << moved.Columns << " of " << stack[n].Placed.Columns.size() << " points moved";
    if (moved.Columns > 0)
    {
      text << ", by up to " << moved.Largest;
    }
    text << '\n';
  }
  return text.str();
}
}

//----------------------------------------------------------------------------------------------------------------------
double IndicesOf(const StackStageOptions& options, double height, const HorizonStack& stack)
{
  return height * IndicesPerUnit(options.Unit, {}, {}, stack.CommonLattice());
}

//----------------------------------------------------------------------------------------------------------------------
CrossingOptions MakeCrossings(const StackStageOptions& given, const HorizonStack& stack)
{
  CrossingOptions crossings;
  crossings.Names = stack.Names();
  crossings.HeightsGrowDownwards = stack.HeightsGrowDownwards();
  crossings.Policies = ParsePolicies(given.CrossingsByLayer, stack.Size() - 1);
  if (crossings.Policies.empty())
  {
    crossings.Policies = { given.Crossings };
  }
  CheckAtLeast("minimum thickness", given.MinimumThickness, 0.0, "");
  crossings.MinimumThickness = IndicesOf(given, given.MinimumThickness, stack);
  return crossings;
}

//----------------------------------------------------------------------------------------------------------------------
void OrderStack(const StackStageOptions& options, HorizonStack& stack)
{
  const CrossingOptions crossings = MakeCrossings(options, stack);
  if (options.ByHeight)
  {
    stack.Reorder(OrderByHeight(stack.Views(), crossings));
  }
}

//----------------------------------------------------------------------------------------------------------------------
CrossingStageResult RunCrossings(const HorizonStack& stack, const StackStageOptions& given, const Monitor& monitor)
{
  const HeightStack heights = stack.WorldHeights();
  std::vector<HorizonView> views = stack.Views();
  for (std::size_t n = 0; n < views.size(); ++n)
  {
    views[n].Heights = heights[n].data();
  }
  const std::string& unit = stack.GetSurvey().VerticalUnit;
  CrossingOptions options = MakeCrossings(given, stack);
  options.HeightsGrowDownwards = false;
  options.Unit = unit.empty() ? "in z" : unit;
  options.MinimumThickness =
    given.MinimumThickness * (given.Unit == HeightUnit::World ? 1.0 : WorldPerIndex(stack.CommonLattice()));
  const RepairedHorizons repaired = RepairHorizons(views, options, monitor.Step(0.4, 0.8));
  CrossingStageResult result;
  for (std::size_t horizon = 0; horizon < stack.Size(); ++horizon)
  {
    result.Horizons.push_back(MakeRepaired(repaired, horizon, stack));
    monitor.Progress(0.8 + 0.15 * double(horizon + 1) / double(stack.Size()));
  }
  result.Report = ReportRepair(repaired.Repair, stack);
  return result;
}
}
