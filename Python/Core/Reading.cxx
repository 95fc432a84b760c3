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
#include "Filters/Surface/SurfaceByRows.h"
#include "Readers/FaultLines/FaultLineFile.h"
#include "Readers/FaultLines/FaultLineHorizon.h"
#include "Readers/GOCADTSurf/TSurfHorizon.h"
#include "Readers/HorizonGrid/GridReader.h"
#include "Readers/HorizonText/HorizonTextParser.h"
#include "Readers/SEGYCube/SEGYHeader.h"
#include "Readers/VerneySparseMatrix/SparseMatrixFile.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <nanobind/ndarray.h>

#include <algorithm>
#include <array>
#include <memory>

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

  std::string Override(SurveyDescription& description) const
  {
    return OverrideSurvey(
      description, this->Survey[0].c_str(), this->Survey[1].c_str(), this->Survey[2].c_str(), this->Survey[3].c_str());
  }
};

using NamedHorizons = std::vector<NamedHorizon>;

/// Returns names and horizons, the description of their place, and warnings.
nb::tuple GiveHorizons(SurveyHorizons survey, const std::vector<std::string>& names, const Framing& framing)
{
  RequireAnyPoints(survey.Horizons, "");
  const std::string replaced = framing.Override(survey.Survey);
  if (!replaced.empty())
  {
    survey.Warnings.push_back(replaced);
  }
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

const std::vector<std::string> Policies = { "strongest", "topmost", "lowest", "sheets", "mean" };

PlacementOptions MakePlacement(const nb::dict& given, bool isUp)
{
  PlacementOptions options;
  options.Direction = isUp ? VerticalDirection::Up : VerticalDirection::Down;
  Take(given, "tolerance", options.Tolerance);
  Take(given, "leave_out_strays", options.LeaveOutStrays);
  TakeChoice(given, "duplicates", Policies, options.Policy);
  const auto takeVector = [&](const char* name, Eigen::Vector2d& vector)
  {
    if (given.contains(name))
    {
      options.Source = LatticeSource::OriginAndSteps;
      vector = Eigen::Vector2d(nb::cast<std::array<double, 2>>(given[name]).data());
    }
  };
  std::vector<double> lines; // first inline and its step, then those of crosslines
  Take(given, "lines", lines);
  if (!lines.empty())
  {
    options.Lines = { lines.at(2), lines.at(3), lines.at(0), lines.at(1) };
  }
  takeVector("origin", options.Origin);
  takeVector("column_step", options.ColumnStep);
  takeVector("row_step", options.RowStep);
  if (given.contains("corners"))
  {
    options.Source = LatticeSource::CornerPoints;
    const auto corners = nb::cast<std::array<std::array<double, 4>, 3>>(given["corners"]);
    for (std::size_t n = 0; n < corners.size(); ++n)
    {
      options.Corners[n] = { corners[n][0], corners[n][1], corners[n][2], corners[n][3] };
    }
  }
  CheckPlacement(options);
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
    if (given.contains("lines") && !options.Placement.Lines && picks.HasLines())
    {
      if (!picks.HasPlaces())
      {
        throw InputError("only line numbers for a cube that has none, expected x and y");
      }
      picks.Inline = picks.Crossline = {};
    }
    Take(given, "gridding", gridding);
    Take(given, "gridding_radius", options.Radius);
    Take(given, "gridding_smoothing", options.Smoothing);
  }
  if (gridding != "" && options.Placement.Policy == DuplicatePolicy::Sheets)
  {
    throw InputError("DuplicatePolicy Sheets with Gridding, expected one z for each column");
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
  std::string nulls;
  Take(options, "null_values", nulls);
  for (const auto& [name, target] : { std::make_pair("x", &picks.X), { "y", &picks.Y }, { "inline", &picks.Inline },
         { "crossline", &picks.Crossline }, { "z", &picks.Z } })
  {
    if (arrays.contains(name))
    {
      *target = Copy(nb::cast<Values<double>>(arrays[name]));
    }
  }
  std::replace_if(
    picks.Z.begin(), picks.Z.end(), [numbers = NullValues(nulls)](double z) { return numbers.IsNullNumber(z); },
    NoValue);
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
      HorizonGrid grid = ReadHorizonGrid(*OpenInputFile(path), monitor, GridBufferSize, numbers);
      name = grid.Name;
      format = grid.Format;
      return PlaceGrid(std::move(grid), numbers);
    });
  return nb::make_tuple(format, GiveHorizons(std::move(placed), { name }, framing));
}

/// Errors within `work` say so if the file looks like lines of faults.
template <typename Work>
auto SayingFaults(const std::string& path, Work&& work)
{
  try
  {
    return work();
  }
  catch (const InputError& error)
  {
    const bool areFaults = IsRecognised(
      path.c_str(), [](std::istream& stream) { return BeginsAsFaultLines(stream) || IsFaultTable(stream); });
    if (areFaults)
    {
      throw InputError(error.what() + std::string("; lines of faults are for the Fault Lines Reader"));
    }
    throw;
  }
}

nb::tuple ReadText(const std::string& path, const std::string& columns, const std::string& nulls, int headerLines,
  const std::string& where, const nb::dict& options, double verticalStep, const std::string& direction,
  const std::array<std::string, 4>& survey, const nb::object& progress)
{
  const Framing framing(verticalStep, direction, survey);
  std::vector<std::string> names;
  std::string format;
  const auto read = [&](const Monitor& monitor)
  {
    const auto stream = OpenInputFile(path);
    const TextLayout layout = ReadTextLayout(*stream, { columns, nulls, headerLines, where });
    PickTable picks = ReadPicks(*stream, layout, monitor.Step(0.0, 0.6));
    format = layout.Describe(picks.OtherLines);
    names = layout.HasNames() ? picks.Names : std::vector<std::string>{ layout.HorizonName };
    return Place(std::move(picks), direction, options, monitor.Step(0.6, 1.0));
  };
  SurveyHorizons placed = SayingFaults(path, [&] { return Run(progress, read); });
  return nb::make_tuple(format, GiveHorizons(std::move(placed), names, framing));
}

/// A file of sparse voxels. With an overview it keeps no points from listing, and reads rows of chosen horizons.
class SparseFile
{
public:
  SparseFile(const std::string& path, bool withOverview)
    : Path(path)
    , File(MakeSparseMatrixFile(withOverview))
  {
  }

  void List(const nb::dict& chosen, const nb::object& progress)
  {
    SparseMatrixOptions options;
    TakeChoice(chosen, "duplicates", Policies, options.Policy);
    if (chosen.contains("rows"))
    {
      options.RowRange = nb::cast<std::array<int, 2>>(chosen["rows"]); // first and last
    }
    Run(progress, [&](const Monitor& monitor) { this->File->List(this->Path, options, monitor); });
  }

  std::vector<std::string> Names() const
  {
    std::vector<std::string> names;
    for (const ListedHorizon& horizon : this->File->Horizons())
    {
      names.push_back(HorizonName(horizon.SurfaceId));
    }
    return MakeDistinct(std::move(names));
  }

  std::vector<std::int64_t> Sizes() const
  {
    std::vector<std::int64_t> sizes;
    for (const ListedHorizon& horizon : this->File->Horizons())
    {
      sizes.push_back(horizon.Size);
    }
    return sizes;
  }

  bool HasRealZ() const { return this->File->VerticalFit().Step != 0.0; }

  /// The options place the lattice: origin of x, y and z, column_step, row_step, vertical_step, and use_real_z.
  nb::list Take(const std::vector<int>& places, const nb::dict& chosen, const std::string& direction,
    const std::array<std::string, 4>& survey, const nb::object& progress)
  {
    LatticeFrame frame = TakeFrame(chosen, direction, survey);
    NamedHorizons horizons;
    const std::vector<std::string> names = this->Names();
    Run(progress,
      [&](const Monitor& monitor)
      {
        SparseMatrix matrix = this->File->Take(places, monitor);
        this->AddFile(frame);
        for (const int place : places)
        {
          horizons.push_back(
            { names[std::size_t(place)], MakeHorizonPoints(std::move(matrix.Horizons[std::size_t(place)]), frame) });
        }
      });
    return GiveNamed(horizons);
  }

  /// Returns the mesh of a horizon, whose rows are read as needed, and warnings.
  nb::tuple MakeSurface(std::size_t place, const nb::dict& chosen, const std::string& direction,
    const std::array<std::string, 4>& survey, const nb::dict& surface, std::int64_t mostAtOnce,
    const nb::object& progress)
  {
    const SurfaceStageOptions options = TakeSurfaceOptions(surface);
    LatticeFrame frame = TakeFrame(chosen, direction, survey);
    this->AddFile(frame);
    const RowsOfFile rows(*this->File, place, frame);
    Horizon mesh;
    const std::vector<std::string> warnings =
      Run(progress, [&](const Monitor& monitor) { return RunSurfaceByRows(rows, options, mostAtOnce, mesh, monitor); });
    return nb::make_tuple(GiveData(mesh), warnings);
  }

  /// Returns the number of columns and rows around a horizon.
  std::array<std::int64_t, 2> Extent(std::size_t place) const
  {
    const PlaneBox box = this->File->ColumnsOf(place);
    return { std::int64_t(box.Greatest.X) - box.Least.X + 1, std::int64_t(box.Greatest.Y) - box.Least.Y + 1 };
  }

private:
  class RowsOfFile : public HorizonRows
  {
  public:
    RowsOfFile(const SparseMatrixFile& file, std::size_t place, const LatticeFrame& frame)
      : File(file)
      , Place(place)
      , Frame(frame)
    {
    }

    PlaneBox Box() const override { return this->File.ColumnsOf(this->Place); }

    std::int64_t CountPoints(std::int32_t firstRow, std::int32_t lastRow) const override
    {
      return this->File.CountVoxels(this->Place, firstRow, lastRow);
    }

    Horizon Read(std::int32_t firstRow, std::int32_t lastRow) const override
    {
      SparseMatrix matrix = this->File.TakeRows(this->Place, firstRow, lastRow);
      return MakeHorizonPoints(std::move(matrix.Horizons.front()), this->Frame);
    }

  private:
    const SparseMatrixFile& File;
    const std::size_t Place;
    const LatticeFrame& Frame;
  };

  static LatticeFrame TakeFrame(
    const nb::dict& chosen, const std::string& direction, const std::array<std::string, 4>& survey)
  {
    LatticeFrame frame;
    frame.Direction = direction == "up" ? VerticalDirection::Up : VerticalDirection::Down;
    frame.Sampling = { 0.0, 1.0, 0 };
    if (chosen.contains("origin"))
    {
      const auto [x, y, z] = nb::cast<std::array<double, 3>>(chosen["origin"]);
      frame.Lattice.Origin = { x, y };
      frame.Sampling.First = static_cast<int>(frame.Direction) * z;
    }
    const auto takeStep = [&](const char* name, Eigen::Vector2d& step)
    {
      if (chosen.contains(name))
      {
        step = Eigen::Vector2d(nb::cast<std::array<double, 2>>(chosen[name]).data());
      }
    };
    takeStep("column_step", frame.Lattice.ColumnStep);
    takeStep("row_step", frame.Lattice.RowStep);
    SeismicHorizons::Take(chosen, "vertical_step", frame.Sampling.Step);
    SeismicHorizons::Take(chosen, "use_real_z", frame.UseRealZ);
    Framing(0.0, direction, survey).Override(frame.Survey);
    frame.Check();
    return frame;
  }

  /// Adds what is known of the file that was read or listed.
  void AddFile(LatticeFrame& frame) const
  {
    const SparseMatrixVerticalFit& fit = this->File->VerticalFit();
    if (frame.UseRealZ && fit.Step != 0.0)
    {
      frame.Sampling = { fit.Offset, fit.Step, 0 };
    }
    const auto [columns, rows, indices] = this->File->Size();
    frame.Lattice.Columns = { columns, rows };
    frame.Sampling.Indices = indices;
  }

  std::string Path;
  std::unique_ptr<SparseMatrixFile> File;
};

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

/// Lines of all files; returns data, and what each file was taken for, in lines.
nb::tuple ReadLines(const std::vector<std::string>& paths, const nb::dict& chosen, const std::string& direction,
  const nb::object& progress)
{
  const Framing framing(0.0, direction, {});
  FaultTextOptions options;
  Take(chosen, "columns", options.Columns);
  Take(chosen, "nulls", options.NullValues);
  Take(chosen, "header_lines", options.HeaderLines);
  const FaultLineData data =
    Run(progress, [&](const Monitor& monitor) { return LoadFaultLines(paths, options, framing.Direction, monitor); });
  return nb::make_tuple(GiveData(data.Lines), data.Description);
}

/// Names may be any bytes, as those of files in a folder.
std::string FindFormat(const nb::bytes& name)
{
  const std::string path(name.c_str(), name.size());
  const auto isRecognised = [&path](auto&& isOne) { return IsRecognised(path.c_str(), isOne); };
  const auto isTSurf = [](std::istream& stream)
  {
    const std::optional<std::string> type = FirstTypeOfGOCAD(stream);
    return type && *type != "pline" && *type != "vset";
  };
  return ExtensionOf(path) == "vsm" || isRecognised(BeginsAsSparseMatrix)                         ? "sparse"
    : isRecognised(IsGrid)                                                                        ? "grid"
    : IsSEGYFile(path)                                                                            ? "cube"
    : isRecognised(isTSurf)                                                                       ? "tsurf"
    : isRecognised([&path](std::istream& stream) { return ArePicks(stream, ExtensionOf(path)); }) ? "text"
                                                                                                  : "";
}
}

//----------------------------------------------------------------------------------------------------------------------
void BindReading(nb::module_& module)
{
  nb::class_<SparseFile>(module, "SparseFile")
    .def(nb::init<const std::string&, bool>(), "path"_a, "with_overview"_a)
    .def("list", &SparseFile::List, "options"_a, "progress"_a.none())
    .def_prop_ro("names", &SparseFile::Names)
    .def_prop_ro("sizes", &SparseFile::Sizes)
    .def_prop_ro("has_real_z", &SparseFile::HasRealZ)
    .def("extent", &SparseFile::Extent, "place"_a)
    .def("take", &SparseFile::Take, "places"_a, "options"_a, "direction"_a, "survey"_a, "progress"_a.none())
    .def("surface", &SparseFile::MakeSurface, "place"_a, "options"_a, "direction"_a, "survey"_a, "surface"_a,
      "most_at_once"_a, "progress"_a.none());
  module.def("find_format", &FindFormat, "path"_a);
  module.attr("DEFAULT_NULLS") = DefaultNulls;
  module.def("make_distinct", &MakeDistinct, "names"_a);
  module.def(
    "role_of", [](const std::string& name) { return std::string(RoleWord(RoleOfName(name))); }, "name"_a);
  module.def(
    "is_elevation", [](const std::string& name) { return IsElevation(name); }, "name"_a);
  module.def(
    "short_unit", [](const std::string& unit) { return ShortUnit(unit); }, "unit"_a);
  module.def("choose_z",
    [](const std::vector<std::string>& names, const std::string& remedy) { return ChooseZ(names, remedy.c_str()); });
  module.def(
    "read_grid", &ReadGrid, "path"_a, "nulls"_a, "vertical_step"_a, "direction"_a, "survey"_a, "progress"_a.none());
  module.def("read_text", &ReadText, "path"_a, "columns"_a, "nulls"_a, "header_lines"_a, "where"_a, "options"_a,
    "vertical_step"_a, "direction"_a, "survey"_a, "progress"_a.none());
  module.def("read_tsurfs", &ReadTSurfs, "path"_a, "progress"_a.none());
  module.def("read_fault_lines", &ReadLines, "paths"_a, "options"_a, "direction"_a, "progress"_a.none());
  module.def("place_points", &PlacePoints, "arrays"_a, "attributes"_a, "names"_a, "options"_a, "vertical_step"_a,
    "direction"_a, "survey"_a, "progress"_a.none());
}
}
