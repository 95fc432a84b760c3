// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sealed models.

#include "Data.h"

#include "Filters/Cutoffs/FaultInput.h"
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
  TakeChoice(chosen, "height_unit", { "lattice", "world" }, options.Cutoffs.ErrorUnit);
  Take(chosen, "endings", options.Endings);
  Take(chosen, "end_distance", options.EndDistance);
  Take(chosen, "unconformities", options.Unconformities);
  Take(chosen, "dip", options.Cutoffs.Dip);
  Take(chosen, "drop_distance", options.Cutoffs.DropDistance);
  Take(chosen, "drop_noise", options.Cutoffs.DropNoise);
  Take(chosen, "maximum_error", options.Cutoffs.MaximumError);
  const std::vector<NamedHorizon> horizons = TakeNamed(given);
  const std::vector<NamedHorizon> blocks = TakeNamed(faults);
  std::vector<std::string> warnings;
  const SealedStageResult made = Run(progress,
    [&](const Monitor& monitor)
    {
      std::vector<CutInput> inputs;
      for (const NamedHorizon& horizon : horizons)
      {
        PrefixErrors(horizon.Name, [&]() { inputs.push_back({ horizon.Name, ReadCutPoints(horizon.Data) }); });
      }
      GivenFaultPicks picks = blocks.empty() ? GivenFaultPicks() : ReadFaultPicks(blocks);
      const ArrayTable fields = JoinFields(inputs, picks);
      SealedStageResult result = RunSealed(inputs, picks.Picks, fields, options, monitor);
      warnings = picks.Warnings;
      warnings.insert(warnings.end(), result.Warnings.begin(), result.Warnings.end());
      return result;
    });
  nb::dict result;
  result["surfaces"] = GiveData(made.Surfaces);
  result["lines"] = GiveData(made.Lines);
  result["names"] = nb::cast(made.BodyNames);
  result["bodies"] = GiveList(made.Bodies);
  result["figures"] = GiveTable(made.Figures);
  result["areas"] = GiveTable(made.Areas);
  result["picks"] = GiveTable(made.Picks);
  result["report"] = nb::cast(made.Report);
  return nb::make_tuple(result, warnings);
}
}

//----------------------------------------------------------------------------------------------------------------------
void BindSealed(nb::module_& module)
{
  module.def("sealed", &MakeSealedModel, "horizons"_a, "faults"_a, "options"_a, "progress"_a.none());
}
}
