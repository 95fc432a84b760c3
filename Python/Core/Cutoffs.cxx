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
  std::optional<std::vector<NamedHorizon>> blocks;
  if (faults.size() > 0)
  {
    blocks = TakeNamed(faults);
  }
  std::vector<std::string> warnings;
  const CutoffStageResult made = Run(progress,
    [&](const Monitor& monitor)
    {
      const CutInputs inputs = ReadCutInputs(horizons, blocks);
      const CutoffModelData model = RunCutoffs(inputs.Horizons, inputs.Faults.Picks, options, monitor);
      warnings = inputs.Faults.Warnings;
      warnings.insert(warnings.end(), model.Warnings.begin(), model.Warnings.end());
      return WriteCutoffs(model, inputs.Fields);
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
