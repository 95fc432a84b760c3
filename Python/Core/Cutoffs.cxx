// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cutoffs of horizons at faults.

#include "Data.h"

#include "Filters/Cutoffs/CutoffOutput.h"
#include "Filters/Cutoffs/CutoffStage.h"
#include "Filters/Cutoffs/FaultInput.h"

using namespace nanobind::literals;

namespace SeismicHorizons
{
namespace
{
/// `faults` are lists of named sticks or surfaces; empty for the cuts of the horizons.
nb::tuple FindAllCutoffs(
  const nb::list& given, const nb::list& faults, const nb::dict& chosen, const nb::object& progress)
{
  CutoffStageOptions options;
  options.ErrorUnit = HeightUnit::World;
  Take(chosen, "dip", options.Dip);
  Take(chosen, "drop_distance", options.DropDistance);
  Take(chosen, "drop_noise", options.DropNoise);
  Take(chosen, "largest_gap", options.LargestGap);
  Take(chosen, "smallest_length", options.SmallestLength);
  Take(chosen, "maximum_error", options.MaximumError);
  const std::vector<NamedHorizon> horizons = TakeNamed(given);
  const std::vector<NamedHorizon> blocks = TakeNamed(faults);
  std::vector<std::string> warnings;
  const CutoffStageResult made = Run(progress,
    [&](const Monitor& monitor)
    {
      std::vector<CutInput> inputs;
      for (const NamedHorizon& horizon : horizons)
      {
        PrefixErrors(horizon.Name, [&]() { inputs.push_back({ horizon.Name, ReadCutPoints(horizon.Data) }); });
      }
      GivenFaultPicks picks = blocks.empty() ? GivenFaultPicks() : ReadFaultPicks(blocks);
      const ArrayTable fields = JoinFields(inputs, picks);
      const CutoffModelData model = RunCutoffs(inputs, picks.Picks, options, monitor);
      warnings = picks.Warnings;
      warnings.insert(warnings.end(), model.Warnings.begin(), model.Warnings.end());
      return WriteCutoffs(model, fields);
    });
  nb::dict result;
  result["names"] = nb::cast(made.FaultNames);
  result["cutoffs"] = GiveList(made.Cutoffs);
  result["polygons"] = GiveList(made.Polygons);
  result["faults"] = GiveData(made.Faults);
  result["diagrams"] = GiveData(made.Diagrams);
  result["figures"] = GiveTable(made.Figures);
  result["areas"] = GiveTable(made.Areas);
  return nb::make_tuple(result, warnings);
}
}

//----------------------------------------------------------------------------------------------------------------------
void BindCutoffs(nb::module_& module)
{
  module.def("cutoffs", &FindAllCutoffs, "horizons"_a, "faults"_a, "options"_a, "progress"_a.none());
}
}
