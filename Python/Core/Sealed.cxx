// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sealed models.

#include "Data.h"

#include "Filters/Sealing/SealedStage.h"

using namespace nanobind::literals;

namespace SeismicHorizons
{
namespace
{
/// `faults` are lists of named sticks or surfaces; empty for the cuts of the horizons.
nb::tuple MakeSealedModel(
  const nb::list& given, const nb::list& faults, const nb::dict& chosen, const nb::object& progress)
{
  SealedStageOptions options;
  options.Cutoffs.ErrorUnit = HeightUnit::World;
  TakeChoice(chosen, "height_unit", { "steps", "world" }, options.Cutoffs.ErrorUnit);
  Take(chosen, "endings", options.Endings);
  Take(chosen, "end_distance", options.EndDistance);
  Take(chosen, "unconformities", options.Unconformities);
  TakeChoice(chosen, "tips", { "sticks", "through" }, options.GoesThrough);
  TakeChoice(chosen, "outline", { "box", "picks" }, options.FollowsOutline);
  Take(chosen, "dip", options.Cutoffs.Dip);
  Take(chosen, "drop_distance", options.Cutoffs.DropDistance);
  Take(chosen, "drop_noise", options.Cutoffs.DropNoise);
  Take(chosen, "maximum_error", options.Cutoffs.MaximumError);
  const std::vector<NamedHorizon> horizons = TakeNamed(given);
  std::optional<std::vector<NamedHorizon>> blocks;
  if (faults.size() > 0)
  {
    blocks = TakeNamed(faults);
  }
  const SealedStageResult made =
    Run(progress, [&](const Monitor& monitor) { return RunSealed(ReadCutInputs(horizons, blocks), options, monitor); });
  nb::dict result;
  result["surfaces"] = GiveData(made.Surfaces);
  result["lines"] = GiveData(made.Lines);
  result["names"] = nb::cast(made.BodyNames);
  result["bodies"] = GiveList(made.Bodies);
  result["figures"] = GiveTable(made.Figures);
  result["areas"] = GiveTable(made.Areas);
  result["picks"] = GiveTable(made.Picks);
  result["report"] = nb::cast(made.Report);
  return nb::make_tuple(result, made.Warnings);
}
}

//----------------------------------------------------------------------------------------------------------------------
void BindSealed(nb::module_& module)
{
  module.def("sealed", &MakeSealedModel, "horizons"_a, "faults"_a, "options"_a, "progress"_a.none());
}
}
