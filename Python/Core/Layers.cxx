// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stages of all horizons of a stack.

#include "Data.h"

#include "Filters/Layers/LayerStage.h"

using namespace nanobind::literals;

namespace SeismicHorizons
{
namespace
{
void TakeStackOptions(const nb::dict& chosen, StackStageOptions& options)
{
  Take(chosen, "by_height", options.ByHeight);
  TakeChoice(chosen, "crossings", { "mean", "upper_wins", "lower_wins", "stop" }, options.Crossings);
  Take(chosen, "crossings_by_layer", options.CrossingsByLayer);
  Take(chosen, "minimum_thickness", options.MinimumThickness);
  TakeChoice(chosen, "height_unit", { "steps", "world" }, options.Unit);
}

HorizonStack MakeStack(const std::vector<NamedHorizon>& horizons, const StackStageOptions& options)
{
  HorizonStack stack;
  for (const NamedHorizon& horizon : horizons)
  {
    PrefixErrors(horizon.Name, [&]() { stack.Add(horizon.Name, horizon.Data); });
  }
  stack.PlaceTogether();
  OrderStack(options, stack);
  return stack;
}

nb::tuple FindLayers(const nb::list& given, const nb::dict& chosen, const nb::object& progress)
{
  LayerStageOptions options;
  TakeStackOptions(chosen, options);
  Take(chosen, "maximum_error", options.MaximumError);
  Take(chosen, "bound_thickness", options.BoundThickness);
  Take(chosen, "pinch_out_lines", options.PinchOutLines);
  Take(chosen, "smallest_pinch", options.SmallestPinch);
  TakeChoice(chosen, "domain", { "common", "each_layer" }, options.Domain);
  Take(chosen, "keep_outlines", options.KeepOutlines);
  TakeChoice(chosen, "missing", { "void", "interpolate", "follow" }, options.Missing);
  Take(chosen, "largest_hole_size", options.LargestHoleSize);
  Take(chosen, "largest_gap", options.LargestGap);
  TakeChoice(chosen, "effort", { "fast", "best" }, options.Effort);
  Take(chosen, "smallest_angle", options.SmallestAngle);
  Take(chosen, "edge_length", options.EdgeLength);
  Take(chosen, "edge_growth", options.EdgeGrowth);
  Take(chosen, "fit_heights", options.FitHeights);
  Take(chosen, "sublayers", options.Sublayers);
  Take(chosen, "largest_sublayer_thickness", options.LargestSublayerThickness);
  Take(chosen, "tetrahedra", options.Tetrahedra);
  Take(chosen, "contact", options.Contact);
  const std::vector<NamedHorizon> horizons = TakeNamed(given);
  HorizonStack stack;
  const LayerStageResult made = Run(progress,
    [&](const Monitor& monitor)
    {
      stack = MakeStack(horizons, options);
      return RunLayers(stack, options, monitor);
    });
  nb::dict result;
  result["volumes"] = GiveVolumes(made.Layers);
  result["bodies"] = GiveList(made.Bodies);
  result["horizons"] = GiveList(made.Horizons);
  result["names"] = nb::cast(stack.Names());
  result["figures"] = GiveTable(made.Figures);
  result["curve"] = GiveTable(made.Volumes);
  std::vector<std::string> warnings = { stack.GetDoubt(), WarnOfTime(stack) };
  warnings.insert(warnings.end(), made.Warnings.begin(), made.Warnings.end());
  return nb::make_tuple(result, warnings);
}

nb::tuple PutInOrder(const nb::list& given, const nb::dict& chosen, const nb::object& progress)
{
  StackStageOptions options;
  TakeStackOptions(chosen, options);
  const std::vector<NamedHorizon> horizons = TakeNamed(given);
  HorizonStack stack;
  const CrossingStageResult made = Run(progress,
    [&](const Monitor& monitor)
    {
      stack = MakeStack(horizons, options);
      return RunCrossings(stack, options, monitor);
    });
  return nb::make_tuple(
    nb::make_tuple(stack.Names(), GiveList(made.Horizons)), std::vector<std::string>{ stack.GetDoubt() });
}
}

//----------------------------------------------------------------------------------------------------------------------
void BindLayers(nb::module_& module)
{
  module.def("layers", &FindLayers, "horizons"_a, "options"_a, "progress"_a.none());
  module.def("crossings", &PutInOrder, "horizons"_a, "options"_a, "progress"_a.none());
}
}
