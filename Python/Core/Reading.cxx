// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Data.h"

#include "Common/Horizon/NamedHorizon.h"
#include "Common/Survey/FieldRole.h"
#include "Common/Survey/GridPlacement.h"
#include "Common/Survey/HorizonDataSet.h"
#include "Common/Survey/PickPlacement.h"
#include "Common/Survey/PickWarnings.h"
#include "Common/Survey/SurveyFrame.h"
#include "Common/Survey/Units.h"
#include "Common/Survey/VerticalSense.h"
#include "Common/Text/InputFile.h"
#include "Filters/Algorithms/Gridding/Gridding.h"
#include "Readers/FaultLines/FaultLineHorizon.h"
#include "Readers/GOCADTSurf/TSurfHorizon.h"
#include "Readers/HorizonGrid/GridReader.h"
#include "Readers/HorizonText/HorizonTextParser.h"
#include "Readers/VerneySparseMatrix/SparseMatrixFile.h"

#include <nanobind/ndarray.h>

#include <array>
#include <memory>
#include <numeric>

using namespace nanobind::literals;

namespace SeismicHorizons
{
namespace
{
template <typename T>
using Values = nb::ndarray<const T, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

template <typename T>
std::vector<T> Copy(const Values<T>& values)
{
  return { values.data(), values.data() + values.size() };
}

struct Framing
{
  double VerticalStep = 0.0;
  std::optional<VerticalDirection> Direction;
  std::array<std::string, 4> Survey; // vertical unit and domain, horizontal unit, coordinate system

  Framing(double step, const std::string& direction, const std::array<std::string, 4>& survey)
    : VerticalStep(step)
    , Survey(survey)
  {
    if (direction != "")
    {
      this->Direction = direction == "up" ? VerticalDirection::Up : VerticalDirection::Down;
    }
  }

  void Override(SurveyDescription& description) const
  {
    OverrideSurvey(
      description, this->Survey[0].c_str(), this->Survey[1].c_str(), this->Survey[2].c_str(), this->Survey[3].c_str());
  }
};

using NamedHorizons = std::vector<NamedHorizon>;

/// Returns names and horizons, the description of their place, and warnings.
nb::tuple GiveHorizons(SurveyHorizons survey, const std::vector<std::string>& names, const Framing& framing)
{
  RequireAnyPoints(survey.Horizons, "");
  framing.Override(survey.Survey);
  const FramedSurvey framed = FrameSurvey(survey, framing.VerticalStep, framing.Direction);
  NamedHorizons horizons;
  for (std::size_t number = 0; number < survey.Horizons.size(); ++number)
  {
    const std::size_t owner = std::size_t(std::max(1, survey.Horizons[number].SurfaceId)) - 1;
    horizons.push_back(
      { owner < names.size() ? names[owner] : names.front(), TakeHorizonPoints(survey, framed, number) });
  }
  survey.Warnings.insert(survey.Warnings.end(), framed.Warnings.begin(), framed.Warnings.end());
  return nb::make_tuple(GiveNamed(horizons), framed.Description, survey.Warnings);
}

// ---- Points of others -----------------------------------------------------------------------------------------------

const std::vector<std::string> Policies = { "strongest", "topmost", "lowest", "mean", "sheets" };

PlacementOptions MakePlacement(const nb::dict& given, bool isUp)
{
  PlacementOptions options;
  options.Direction = isUp ? VerticalDirection::Up : VerticalDirection::Down;
  Take(given, "tolerance", options.Tolerance);
  Take(given, "leave_out_strays", options.LeaveOutStrays);
  TakeChoice(given, "duplicates", Policies, options.Policy);
  if (given.contains("origin"))
  {
    const auto vector = [&](const char* name)
    { return Eigen::Vector2d(nb::cast<std::array<double, 2>>(given[name]).data()); };
    options.Source = LatticeSource::OriginAndSteps;
    options.Origin = vector("origin");
    options.ColumnStep = vector("column_step");
    options.RowStep = vector("row_step");
  }
  return options;
}

/// Adds what is known of the direction of z, places picks, and adds warnings.
SurveyHorizons Place(PickTable picks, const std::string& direction, const nb::dict& given, const Monitor& monitor)
{
  std::string sense = FindSense(picks.Survey, picks.Z);
  GriddingOptions options;
  std::string gridding;
  {
    const nb::gil_scoped_acquire lock;
    options.Placement = MakePlacement(given, direction == "" ? picks.Survey.IsUpright : direction == "up");
    gridding = nb::cast<std::string>(given["gridding"]);
  }
  options.Method = gridding == "plate" ? GriddingMethod::Plate : GriddingMethod::Nearest;
  SurveyHorizons placed = gridding == "" ? PlacePicks(std::move(picks), options.Placement, monitor)
                                         : GridPicks(std::move(picks), options, monitor);
  placed.Sense = std::move(sense);
  placed.Warnings = FindWarnings(placed, options.Placement.Policy);
  return placed;
}

nb::tuple PlacePoints(const nb::dict& arrays, const nb::dict& attributes, const std::vector<std::string>& names,
  const nb::dict& options, double verticalStep, const std::string& direction, const std::array<std::string, 4>& survey,
  const nb::object& progress)
{
  PickTable picks;
  picks.Names = names;
  for (const auto& [name, target] : { std::make_pair("x", &picks.X), { "y", &picks.Y }, { "inline", &picks.Inline },
         { "crossline", &picks.Crossline }, { "z", &picks.Z } })
  {
    if (arrays.contains(name))
    {
      *target = Copy(nb::cast<Values<double>>(arrays[name]));
    }
  }
  if (arrays.contains("horizon"))
  {
    picks.Horizon = Copy(nb::cast<Values<int>>(arrays["horizon"]));
  }
  for (const auto& [name, values] : attributes)
  {
    picks.Attributes.push_back({ nb::cast<std::string>(name), Copy(nb::cast<Values<double>>(values)) });
  }
  const Framing framing(verticalStep, direction, survey);
  SurveyHorizons placed =
    Run(progress, [&](const Monitor& monitor) { return Place(std::move(picks), direction, options, monitor); });
  return GiveHorizons(std::move(placed), names, framing);
}

// ---- Files ----------------------------------------------------------------------------------------------------------

nb::tuple ReadGrid(const std::string& path, const std::string& nulls, double verticalStep, const std::string& direction,
  const std::array<std::string, 4>& survey, const nb::object& progress)
{
  const Framing framing(verticalStep, direction, survey);
  std::string name;
  std::string format;
  SurveyHorizons placed = Run(progress,
    [&](const Monitor& monitor)
    {
      const NullValues numbers(nulls);
      HorizonGrid grid = ReadHorizonGrid(*OpenInputFile(path), monitor);
      name = grid.Name;
      format = grid.Format;
      return PlaceGrid(std::move(grid), numbers);
    });
  return nb::make_tuple(format, GiveHorizons(std::move(placed), { name }, framing));
}

nb::tuple ReadText(const std::string& path, const std::string& columns, const std::string& nulls, int headerLines,
  const nb::dict& options, double verticalStep, const std::string& direction, const std::array<std::string, 4>& survey,
  const nb::object& progress)
{
  const Framing framing(verticalStep, direction, survey);
  std::vector<std::string> names;
  std::string format;
  SurveyHorizons placed = Run(progress,
    [&](const Monitor& monitor)
    {
      const auto stream = OpenInputFile(path);
      const TextLayout layout = ReadTextLayout(*stream, { columns, nulls, headerLines });
      format = layout.Describe();
      PickTable picks = ReadPicks(*stream, layout, monitor.Step(0.0, 0.6));
      names = layout.HasNames() ? picks.Names : std::vector<std::string>{ layout.HorizonName };
      return Place(std::move(picks), direction, options, monitor.Step(0.6, 1.0));
    });
  return nb::make_tuple(format, GiveHorizons(std::move(placed), names, framing));
}

/// z is real z, or the vertical index in files without it.
nb::tuple ReadSparse(const std::string& path, const nb::dict& chosen, const std::string& direction,
  const std::array<std::string, 4>& survey, const nb::object& progress)
{
  SparseMatrixOptions options;
  TakeChoice(chosen, "duplicates", Policies, options.Policy);
  LatticeFrame frame;
  frame.Direction = direction == "up" ? VerticalDirection::Up : VerticalDirection::Down;
  Framing(0.0, direction, survey).Override(frame.Survey);
  NamedHorizons horizons;
  Run(progress,
    [&](const Monitor& monitor)
    {
      const std::unique_ptr<SparseMatrixFile> file = MakeSparseMatrixFile(false);
      file->List(path, options, monitor.Step(0.0, 0.8));
      std::vector<int> places(file->Horizons().size());
      std::iota(places.begin(), places.end(), 0);
      SparseMatrix matrix = file->Take(places, monitor.Step(0.8, 1.0));
      const auto [columns, rows, indices] = file->Size();
      const SparseMatrixVerticalFit& fit = file->VerticalFit();
      frame.Lattice.Columns = { columns, rows };
      frame.UseRealZ = fit.Step != 0.0;
      frame.Sampling = { frame.UseRealZ ? fit.Offset : 0.0, frame.UseRealZ ? fit.Step : 1.0, indices };
      for (const int place : places)
      {
        horizons.push_back({ HorizonName(file->Horizons()[std::size_t(place)].SurfaceId),
          MakeHorizonPoints(std::move(matrix.Horizons[std::size_t(place)]), frame) });
      }
    });
  const std::string description = std::to_string(frame.Lattice.Columns[0]) + " x " +
    std::to_string(frame.Lattice.Columns[1]) + " columns, places are their numbers\nz is " +
    (frame.UseRealZ ? "real z of the file" : "the vertical index") + ", and increases " +
    (frame.Direction == VerticalDirection::Up ? "upwards" : "downwards");
  return nb::make_tuple("sparse voxels", nb::make_tuple(GiveNamed(horizons), description, std::vector<std::string>()));
}

/// Meshes; returns their names, and where z increases to.
nb::tuple ReadTSurfs(const std::string& path, const nb::object& progress)
{
  NamedHorizons meshes;
  std::string sense;
  Run(progress,
    [&](const Monitor& monitor)
    {
      const std::vector<std::string> names = NamesOf(ListTSurfs(*OpenInputFile(path), monitor.Step(0.0, 0.3)));
      std::vector<TSurf> surfaces = LoadTSurfs(
        *OpenInputFile(path), [](std::size_t) { return true; }, monitor.Step(0.3, 1.0));
      sense = DescribeSense(surfaces);
      for (std::size_t n = 0; n < surfaces.size(); ++n)
      {
        meshes.push_back({ names[n], MakeTSurfHorizon(std::move(surfaces[n])) });
      }
    });
  return nb::make_tuple(GiveNamed(meshes), sense);
}

nb::dict ReadLines(const std::string& path, const std::string& direction, const nb::object& progress)
{
  const Framing framing(0.0, direction, {});
  return GiveData(Run(progress,
    [&](const Monitor& monitor)
    { return MakeFaultLines(ReadFaultLines(*OpenInputFile(path), monitor), framing.Direction); }));
}

std::string FindFormat(const std::string& path)
{
  const auto isRecognised = [&path](auto&& isOne) { return IsRecognised(path.c_str(), isOne); };
  const auto isTSurf = [](std::istream& stream)
  {
    const std::optional<std::string> type = FirstTypeOfGOCAD(stream);
    return type && *type != "pline";
  };
  return ExtensionOf(path) == "vsm"                                                               ? "sparse"
    : isRecognised(isTSurf)                                                                       ? "tsurf"
    : isRecognised(IsGrid)                                                                        ? "grid"
    : isRecognised([&path](std::istream& stream) { return ArePicks(stream, ExtensionOf(path)); }) ? "text"
                                                                                                  : "";
}
}

//----------------------------------------------------------------------------------------------------------------------
void BindReading(nb::module_& module)
{
  module.def("find_format", &FindFormat, "path"_a);
  module.def(
    "role_of", [](const std::string& name) { return std::string(RoleWord(RoleOfName(name))); }, "name"_a);
  module.def(
    "short_unit", [](const std::string& unit) { return ShortUnit(unit); }, "unit"_a);
  module.def("choose_z",
    [](const std::vector<std::string>& names, const std::string& remedy) { return ChooseZ(names, remedy.c_str()); });
  module.def(
    "read_grid", &ReadGrid, "path"_a, "nulls"_a, "vertical_step"_a, "direction"_a, "survey"_a, "progress"_a.none());
  module.def("read_sparse", &ReadSparse, "path"_a, "options"_a, "direction"_a, "survey"_a, "progress"_a.none());
  module.def("read_text", &ReadText, "path"_a, "columns"_a, "nulls"_a, "header_lines"_a, "options"_a, "vertical_step"_a,
    "direction"_a, "survey"_a, "progress"_a.none());
  module.def("read_tsurfs", &ReadTSurfs, "path"_a, "progress"_a.none());
  module.def("read_fault_lines", &ReadLines, "path"_a, "direction"_a, "progress"_a.none());
  module.def("place_points", &PlacePoints, "arrays"_a, "attributes"_a, "names"_a, "options"_a, "vertical_step"_a,
    "direction"_a, "survey"_a, "progress"_a.none());
}
}
