// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The methods for numpy. Python classes (horizon.py, mesh.py) give these functions arrays and options, and take what they
// return; units and defaults are theirs. Methods run without the interpreter's lock, and stop at Ctrl-C.

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/CoveredColumns.h"
#include "Common/Horizon/HeightNoise.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/MergedPoints.h"
#include "Common/Survey/FieldRole.h"
#include "Common/Survey/GridPlacement.h"
#include "Common/Survey/PickPlacement.h"
#include "Common/Survey/PickWarnings.h"
#include "Common/Survey/SurveyFrame.h"
#include "Common/Survey/TSurf.h"
#include "Common/Survey/Units.h"
#include "Common/Survey/VerticalSense.h"
#include "Common/Text/InputFile.h"
#include "Common/Text/TextPrinter.h"
#include "Filters/Algorithms/Despiking/Despiking.h"
#include "Filters/Algorithms/Faults/FaultDetection.h"
#include "Filters/Algorithms/Gridding/Gridding.h"
#include "Filters/Algorithms/HoleFilling/HoleFilling.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Algorithms/Thickness/Thickness.h"
#include "Filters/Algorithms/Triangulation/TriangleQuality.h"
#include "Readers/HorizonGrid/GridReader.h"
#include "Readers/HorizonText/HorizonTextParser.h"
#include "Readers/VerneySparseMatrix/SparseMatrixFile.h"
#include "Writers/GOCADTSurf/TSurfPrinter.h"
#include "Writers/HorizonDXF/DXFPrinter.h"
#include "Writers/HorizonGrid/GridWriters.h"
#include "Writers/HorizonMesh/MeshPrinter.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace nb = nanobind;
using namespace nanobind::literals;
using namespace SeismicHorizons;

namespace
{
template <typename T>
using Values = nb::ndarray<const T, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
template <typename T>
using Tuples = nb::ndarray<const T, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

// ---- Arrays ---------------------------------------------------------------------------------------------------------
/// numpy owns the memory of the values.
template <typename T, typename Vector>
nb::object Give(Vector&& values, std::size_t components = 1)
{
  using Kept = std::decay_t<Vector>;
  auto* const kept = new Kept(std::forward<Vector>(values));
  const nb::capsule owner(kept, [](void* vector) noexcept { delete static_cast<Kept*>(vector); });
  auto* const numbers = reinterpret_cast<T*>(kept->data());
  const std::size_t size = kept->size() * sizeof(typename Kept::value_type) / sizeof(T) / components;
  return components == 1 ? nb::cast(nb::ndarray<nb::numpy, T, nb::ndim<1>>(numbers, { size }, owner))
                         : nb::cast(nb::ndarray<nb::numpy, T, nb::ndim<2>>(numbers, { size, components }, owner));
}

nb::object GivePlaces(std::vector<PlanePoint> places)
{
  return Give<std::int32_t>(std::move(places), 2);
}

nb::object GiveLoops(const Loops& loops)
{
  nb::list list;
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    list.append(Give<std::int32_t>(std::vector<std::int32_t>(loops.begin(loop), loops.end(loop))));
  }
  return std::move(list);
}

template <typename T>
std::vector<T> Copy(const Values<T>& values)
{
  return { values.data(), values.data() + values.size() };
}

PlanePoints PlacesOf(const Tuples<std::int32_t>& columns)
{
  if (columns.shape(1) != 2)
  {
    throw InputError(std::to_string(columns.shape(1)) + " numbers for each column, expected i and j");
  }
  return { reinterpret_cast<const PlanePoint*>(columns.data()), columns.shape(0) };
}

// ---- Calls ----------------------------------------------------------------------------------------------------------
/// Runs work(monitor) without the lock. Raises what a signal or the progress callback raises.
template <typename Work>
auto Run(const nb::object& progress, Work&& work)
{
  const Monitor monitor(
    [&progress](double part)
    {
      const nb::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0)
      {
        return false;
      }
      if (!progress.is_none())
      {
        try
        {
          progress(part);
        }
        catch (nb::python_error& error)
        {
          error.restore();
          return false;
        }
      }
      return true;
    });
  try
  {
    const nb::gil_scoped_release unlocked;
    return work(monitor);
  }
  catch (const Aborted&)
  {
    if (!PyErr_Occurred()) // The callback ran in another thread.
    {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
    throw nb::python_error();
  }
}

/// A horizon on its lattice.
struct Points
{
  PlanePoints Columns;
  SeismicHorizons::Lattice Lattice;
  std::array<double, 16> Map;
  std::vector<double> Height; // lattice units
  const double* Elevations; // world z

  Eigen::Vector3d World(std::size_t point) const
  {
    const PlanePoint& column = this->Columns[point];
    return { this->Map[0] * column.X + this->Map[1] * column.Y + this->Map[3],
      this->Map[4] * column.X + this->Map[5] * column.Y + this->Map[7], this->Elevations[point] };
  }
};

/// Columns, world z, size of the lattice, and its map to the world.
using PointArrays = std::tuple<Tuples<std::int32_t>, Values<double>, std::array<int, 3>, std::array<double, 16>>;

Points MakePoints(const PointArrays& arrays)
{
  const auto& [columns, elevations, dimensions, map] = arrays;
  Points points{ PlacesOf(columns), {}, map, {}, elevations.data() };
  if (elevations.size() != points.Columns.size())
  {
    throw InputError(std::to_string(elevations.size()) + " heights for " + std::to_string(points.Columns.size()) +
      " columns, expected as many");
  }
  Eigen::Matrix4d toWorld;
  for (int n = 0; n < 16; ++n)
  {
    toWorld(n / 4, n % 4) = map[std::size_t(n)];
  }
  points.Lattice = Lattice(dimensions, toWorld);
  points.Height.resize(points.Columns.size());
  ParallelFor(std::int64_t(points.Height.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto point = std::size_t(first); point < std::size_t(last); ++point)
      {
        const Eigen::Vector3d place = points.Lattice.ToLattice(points.World(point));
        points.Lattice.CheckInside(place, PointId(point));
        points.Height[point] = place.z();
      }
    });
  return points;
}

std::optional<LinkCuts> MakeCuts(const std::optional<Tuples<std::int32_t>>& given)
{
  std::vector<LatticeLink> links;
  for (std::size_t n = 0; given && n < given->shape(0); ++n)
  {
    links.push_back({ { (*given)(n, 0), (*given)(n, 1) }, (*given)(n, 2) == 1 ? LinkSide::North : LinkSide::East });
  }
  return CutLinks(links);
}

// ---- Horizons -------------------------------------------------------------------------------------------------------
nb::dict GiveSurvey(const SurveyDescription& survey)
{
  return nb::cast<nb::dict>(
    nb::module_::import_("builtins")
      .attr("dict")("vertical_unit"_a = survey.VerticalUnit, "vertical_domain"_a = survey.VerticalDomain,
        "horizontal_unit"_a = survey.HorizontalUnit, "coordinate_system"_a = survey.CoordinateSystem));
}

nb::dict GiveHorizon(LatticeHorizon& horizon, const LatticeFrame& frame)
{
  nb::dict given;
  given["survey"] = GiveSurvey(frame.Survey);
  given["size"] = nb::make_tuple(frame.Lattice.Columns[0], frame.Lattice.Columns[1], frame.Sampling.Indices);
  given["origin"] = nb::make_tuple(frame.Lattice.Origin.x(), frame.Lattice.Origin.y());
  given["column_step"] = nb::make_tuple(frame.Lattice.ColumnStep.x(), frame.Lattice.ColumnStep.y());
  given["row_step"] = nb::make_tuple(frame.Lattice.RowStep.x(), frame.Lattice.RowStep.y());
  given["first_z"] = frame.Sampling.First;
  given["vertical_step"] = frame.Sampling.Step;
  given["is_up"] = frame.Direction == VerticalDirection::Up;
  given["lines"] = nb::none();
  if (const std::optional<LineNumbering>& lines = frame.Lattice.Lines)
  {
    given["lines"] = nb::make_tuple(lines->FirstInline, lines->InlineStep, lines->FirstCrossline, lines->CrosslineStep);
  }
  given["duplicates"] = horizon.DroppedDuplicates;
  given["without_z"] = horizon.DroppedNulls;
  given["columns"] = Give<std::int32_t>(std::move(horizon.Column), 2);
  given["z"] = Give<double>(std::move(horizon.RealZ));
  nb::dict attributes;
  for (auto& [name, values] : horizon.Attributes)
  {
    attributes[name.c_str()] = Give<double>(std::move(values));
  }
  given["attributes"] = attributes;
  return given;
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
};

/// Returns horizons, the description of their place, and warnings.
nb::tuple GiveHorizons(SurveyHorizons survey, const std::vector<std::string>& names, const Framing& framing)
{
  RequireAnyPoints(survey.Horizons, "");
  const std::array<std::string, 4>& known = framing.Survey;
  OverrideSurvey(survey.Survey, known[0].c_str(), known[1].c_str(), known[2].c_str(), known[3].c_str());
  FramedSurvey framed = FrameSurvey(survey, framing.VerticalStep, framing.Direction);
  nb::list horizons;
  for (std::size_t number = 0; number < survey.Horizons.size(); ++number)
  {
    framed.Frame.Sampling = framed.Samplings[number];
    const std::size_t owner = std::size_t(std::max(1, survey.Horizons[number].SurfaceId)) - 1;
    nb::dict given = GiveHorizon(survey.Horizons[number], framed.Frame);
    given["name"] = owner < names.size() ? names[owner] : names.front();
    horizons.append(given);
  }
  survey.Warnings.insert(survey.Warnings.end(), framed.Warnings.begin(), framed.Warnings.end());
  return nb::make_tuple(horizons, framed.Description, survey.Warnings);
}

// ---- Points of others -----------------------------------------------------------------------------------------------
const std::map<std::string, DuplicatePolicy> Policies = { { "strongest", DuplicatePolicy::StrongestAmplitude },
  { "topmost", DuplicatePolicy::Topmost }, { "lowest", DuplicatePolicy::Lowest }, { "mean", DuplicatePolicy::Mean },
  { "sheets", DuplicatePolicy::Sheets } };

PlacementOptions MakePlacement(const nb::dict& given, bool isUp)
{
  PlacementOptions options;
  options.Direction = isUp ? VerticalDirection::Up : VerticalDirection::Down;
  options.Tolerance = nb::cast<double>(given["tolerance"]);
  options.LeaveOutStrays = nb::cast<bool>(given["leave_out_strays"]);
  options.Policy = Policies.at(nb::cast<std::string>(given["duplicates"]));
  if (given.contains("origin"))
  {
    const auto vector = [&](const char* name)
    {
      const auto numbers = nb::cast<std::array<double, 2>>(given[name]);
      return Eigen::Vector2d(numbers[0], numbers[1]);
    };
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
nb::tuple ReadSparse(const std::string& path, const std::string& duplicates, const std::string& direction,
  const std::array<std::string, 4>& survey, const nb::object& progress)
{
  SparseMatrixOptions options;
  options.Policy = Policies.at(duplicates);
  LatticeFrame frame;
  std::vector<int> ids;
  SparseMatrix matrix;
  Run(progress,
    [&](const Monitor& monitor)
    {
      const std::unique_ptr<SparseMatrixFile> file = MakeSparseMatrixFile(false);
      file->List(path, options, monitor.Step(0.0, 0.8));
      std::vector<int> places;
      for (const ListedHorizon& horizon : file->Horizons())
      {
        places.push_back(int(places.size()));
        ids.push_back(horizon.SurfaceId);
      }
      matrix = file->Take(places, monitor.Step(0.8, 1.0));
      const auto [columns, rows, indices] = file->Size();
      const SparseMatrixVerticalFit& fit = file->VerticalFit();
      frame.Lattice.Columns = { columns, rows };
      frame.UseRealZ = fit.Step != 0.0;
      frame.Sampling = { frame.UseRealZ ? fit.Offset : 0.0, frame.UseRealZ ? fit.Step : 1.0, indices };
    });
  frame.Direction = direction == "up" ? VerticalDirection::Up : VerticalDirection::Down;
  OverrideSurvey(frame.Survey, survey[0].c_str(), survey[1].c_str(), survey[2].c_str(), survey[3].c_str());
  nb::list horizons;
  for (std::size_t number = 0; number < ids.size(); ++number)
  {
    LatticeHorizon& voxels = matrix.Horizons[number];
    if (!frame.UseRealZ)
    {
      std::copy(voxels.K.begin(), voxels.K.end(), voxels.RealZ.begin());
    }
    voxels.Attributes.emplace_back("Thickness", std::move(voxels.Thickness));
    voxels.Attributes.emplace_back("Amplitude", std::move(voxels.Amplitude));
    nb::dict given = GiveHorizon(voxels, frame);
    given["name"] = "Horizon " + std::to_string(ids[number]);
    horizons.append(given);
  }
  const std::string description = std::to_string(frame.Lattice.Columns[0]) + " x " +
    std::to_string(frame.Lattice.Columns[1]) + " columns, places are their numbers\nz is " +
    (frame.UseRealZ ? "real z of the file" : "the vertical index") + ", and increases " +
    (frame.Direction == VerticalDirection::Up ? "upwards" : "downwards");
  return nb::make_tuple("sparse voxels", nb::make_tuple(horizons, description, std::vector<std::string>()));
}

std::string FindFormat(const std::string& path)
{
  return ExtensionOf(path) == "vsm"      ? "sparse"
    : IsRecognised(path.c_str(), IsGrid) ? "grid"
    : IsRecognised(path.c_str(), [&path](std::istream& stream) { return ArePicks(stream, ExtensionOf(path)); }) ? "text"
                                                                                                                : "";
}

// ---- Stages ---------------------------------------------------------------------------------------------------------
nb::tuple Noise(const PointArrays& horizon)
{
  const HeightNoise noise = Run(nb::none(),
    [&](const Monitor&)
    {
      const Points points = MakePoints(horizon);
      return MeasureHeightNoise(points.Columns, points.Height);
    });
  return nb::make_tuple(noise.MaximumError(), noise.Deviation, noise.IsRounding);
}

template <typename T>
void Take(const nb::dict& given, const char* name, T& value)
{
  if (given.contains(name))
  {
    value = nb::cast<T>(given[name]);
  }
}

template <typename T>
void Take(const nb::dict& given, const char* name, std::optional<T>& value)
{
  if (given.contains(name))
  {
    value = nb::cast<T>(given[name]);
  }
}

SurfaceOptions MakeSurfaceOptions(const nb::dict& given)
{
  SurfaceOptions options;
  bool isFast = false;
  Take(given, "maximum_error", options.MaximumError);
  Take(given, "maximum_number_of_triangles", options.MaximumNumberOfTriangles);
  Take(given, "fit_heights", options.FitHeights);
  Take(given, "smallest_angle", options.SmallestAngle);
  Take(given, "fast", isFast);
  Take(given, "radius", options.Radius);
  Take(given, "hole_boundaries", options.HoleBoundaries);
  Take(given, "smallest_hole_size", options.SmallestHoleSize);
  Take(given, "minimum_patch_size", options.MinimumPatchSize);
  Take(given, "outline_tolerance", options.OutlineTolerance);
  options.Effort = isFast ? DecimationEffort::Fast : DecimationEffort::Best;
  return options;
}

std::vector<double> WorldVertices(const Points& points, const std::vector<PointId>& kept, const Reduction& reduction)
{
  std::vector<double> vertices(3 * reduction.Source.size());
  for (std::size_t n = 0; n < reduction.Source.size(); ++n)
  {
    const Eigen::Vector3d world = WorldPlace(reduction, n, points.Lattice,
      [&](PointId source) { return points.World(std::size_t(kept[std::size_t(source)])); });
    std::copy_n(world.data(), 3, vertices.data() + 3 * n);
  }
  return vertices;
}

nb::dict MeshSurface(const PointArrays& horizon, const Values<std::uint8_t>& filled,
  const std::vector<Values<double>>& attributes, const std::optional<Tuples<std::int32_t>>& links,
  const nb::dict& given, const nb::object& progress)
{
  SurfaceOptions options = MakeSurfaceOptions(given);
  Surface surface;
  Ledger ledger;
  TriangleQuality quality;
  std::vector<PointId> kept;
  std::vector<double> vertices;
  std::vector<std::int64_t> counts;
  std::vector<std::vector<double>> averages;
  Run(progress,
    [&](const Monitor& monitor)
    {
      Points points = MakePoints(horizon);
      const std::optional<LinkCuts> cuts = MakeCuts(links);
      options.Cuts = cuts ? &*cuts : nullptr;
      surface = MakeSurface({ points.Columns, std::move(points.Height) }, options, monitor);
      Reduction& reduction = surface.Mesh.Points;
      ledger =
        CoveredColumns(reduction.Plane, reduction.Boundary, 1).Account(points.Columns, Copy(filled), surface.Kept);
      kept.reserve(surface.Kept.size());
      for (std::size_t n = 0; n < surface.Kept.size(); ++n)
      {
        kept.push_back(surface.Kept[n]);
      }
      vertices = WorldVertices(points, kept, reduction);
      quality = MeasureQuality(reduction.Plane, surface.Mesh.Triangles);
      FaceUp(points.Lattice, surface.Mesh.Triangles);
      const MergedPoints merged(reduction, {});
      counts.resize(std::size_t(merged.Size()));
      averages.assign(attributes.size(), std::vector<double>(counts.size()));
      ParallelFor(merged.Size(), Grain,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t target = first; target < last; ++target)
          {
            counts[std::size_t(target)] = merged.SumCounts(target);
            for (std::size_t n = 0; n < attributes.size(); ++n)
            {
              const double* const values = attributes[n].data();
              averages[n][std::size_t(target)] =
                merged.Average(target, [&](PointId point) { return values[kept[std::size_t(point)]]; });
            }
          }
        });
    });
  std::vector<std::int32_t> sources;
  std::vector<std::int32_t> patches;
  for (const PointId source : surface.Mesh.Points.Source)
  {
    sources.push_back(kept[std::size_t(source)]);
    patches.push_back(surface.Boundary.Patch[std::size_t(source)]);
  }
  nb::dict made;
  made["vertices"] = Give<double>(std::move(vertices), 3);
  made["columns"] = GivePlaces(surface.Mesh.Points.Plane);
  made["triangles"] = Give<std::int32_t>(std::move(surface.Mesh.Triangles), 3);
  made["errors"] = Give<double>(std::move(surface.Mesh.Errors));
  made["quality"] = Give<float>(std::move(quality.Shape));
  made["sources"] = Give<std::int32_t>(std::move(sources));
  made["patches"] = Give<std::int32_t>(std::move(patches));
  made["counts"] = Give<std::int64_t>(std::move(counts));
  nb::list lists;
  for (std::vector<double>& average : averages)
  {
    lists.append(Give<double>(std::move(average)));
  }
  made["averages"] = lists;
  made["outlines"] = GiveLoops(surface.Mesh.Points.Boundary);
  made["ledger"] = nb::cast(std::vector<std::int64_t>(ledger.Columns.begin(), ledger.Columns.end()));
  made["figures"] =
    nb::module_::import_("builtins")
      .attr("dict")("largest_error"_a = surface.Mesh.LargestError, "mean_error"_a = surface.Mesh.MeanError,
        "largest_loop_error"_a = std::max(surface.Mesh.LargestLoopError, surface.OutlineHeightDeviation),
        "outline_deviation"_a = surface.OutlineDeviation, "outside_points"_a = surface.NumberOutside,
        "smallest_angle"_a = quality.SmallestAngle, "slivers"_a = surface.Mesh.NumberOfSlivers,
        "patches"_a = surface.Boundary.NumberOfPatches,
        "holes"_a = surface.Boundary.Boundary.Size() - surface.Boundary.NumberOfPatches,
        "chosen_radius"_a = surface.Parameters.Radius,
        "chosen_smallest_hole_size"_a = surface.Parameters.SmallestHoleSize,
        "chosen_outline_tolerance"_a = surface.Parameters.OutlineTolerance,
        "chosen_maximum_error"_a = surface.Parameters.MaximumError);
  return made;
}

nb::dict Fill(const PointArrays& horizon, const std::vector<Values<double>>& attributes,
  const std::optional<Tuples<std::int32_t>>& links, const nb::dict& given, const nb::object& progress)
{
  static const std::map<std::string, FillMethod> methods = { { "plate", FillMethod::Plate },
    { "membrane", FillMethod::Membrane }, { "automatic", FillMethod::Automatic } };
  HoleFillingOptions options;
  options.Method = methods.at(nb::cast<std::string>(given["method"]));
  Take(given, "largest_hole_size", options.LargestHoleSize);
  Take(given, "rim_smoothing", options.RimSmoothing);
  Take(given, "rim_width", options.RimWidth);
  Take(given, "extrapolation_distance", options.ExtrapolationDistance);
  const std::array<int, 3>& size = std::get<2>(horizon);
  options.Survey = PlaneBox({ { 0, 0 }, { size[0] - 1, size[1] - 1 } });
  FilledColumns filled;
  std::vector<double> made;
  Run(progress,
    [&](const Monitor& monitor)
    {
      const Points points = MakePoints(horizon);
      const std::optional<LinkCuts> cuts = MakeCuts(links);
      std::vector<PointValue> values;
      for (const Values<double>& attribute : attributes)
      {
        values.push_back([data = attribute.data()](PointId point) { return data[point]; });
      }
      filled = FillHoles(points.Columns, points.Height, values, options, cuts ? &*cuts : nullptr, monitor);
      for (std::size_t n = 0; n < filled.Column.size(); ++n)
      {
        made.push_back(
          points.Lattice.ToWorld({ double(filled.Column[n].X), double(filled.Column[n].Y), filled.Height[n] }).z());
      }
    });
  nb::dict result;
  result["columns"] = GivePlaces(std::move(filled.Column));
  result["elevations"] = Give<double>(std::move(made));
  result["nearest"] = Give<std::int32_t>(std::move(filled.Nearest));
  nb::list lists;
  for (std::vector<double>& attribute : filled.Attribute)
  {
    lists.append(Give<double>(std::move(attribute)));
  }
  result["attributes"] = lists;
  result["first_outside"] = filled.FirstOutside;
  return result;
}

nb::tuple Despike(const PointArrays& horizon, double threshold, int radius, int spurWidth, const nb::object& progress)
{
  const Spikes spikes = Run(progress,
    [&](const Monitor& monitor)
    {
      const Points points = MakePoints(horizon);
      return FindSpikes(points.Columns, points.Height, { threshold, radius, spurWidth }, monitor);
    });
  std::vector<std::uint8_t> kinds;
  for (const SpikeKind kind : spikes.Kind)
  {
    kinds.push_back(std::uint8_t(kind));
  }
  return nb::make_tuple(Give<std::uint8_t>(std::move(kinds)), spikes.Threshold);
}

nb::dict FindFaults(const PointArrays& horizon, const nb::dict& given, const nb::object& progress)
{
  FaultDetectionOptions options;
  options.SmallestThrow = 0.0;
  Take(given, "smallest_throw", options.SmallestThrow);
  Take(given, "noise", options.Noise);
  Take(given, "smallest_extent", options.SmallestExtent);
  Take(given, "smallest_branch", options.SmallestBranch);
  Take(given, "largest_gap", options.LargestGap);
  Take(given, "largest_ramp", options.LargestRamp);
  Take(given, "join_through_holes", options.JoinThroughHoles);
  FaultDetection found;
  Run(progress,
    [&](const Monitor& monitor)
    {
      CheckOptions(options);
      const Points points = MakePoints(horizon);
      if (options.SmallestThrow == 0.0)
      {
        options.SmallestThrow = ThrowAboveNoise(points.Columns, points.Height, options.Noise);
      }
      found = DetectFaults(ColumnHeights(points.Columns, points.Height), options, monitor);
    });
  std::vector<std::int32_t> links;
  std::vector<std::int32_t> lines;
  std::vector<double> throws;
  for (const LinkOfLine& item : SortLinks(found.Lines))
  {
    const FaultedLink& link = found.Lines[item.Link];
    links.insert(links.end(), { link.Place.Column.X, link.Place.Column.Y, std::int32_t(link.Place.Side) });
    lines.push_back(std::int32_t(item.Line));
    throws.push_back(link.Throw);
  }
  nb::dict made;
  made["links"] = Give<std::int32_t>(std::move(links), 3);
  made["lines"] = Give<std::int32_t>(std::move(lines));
  made["throws"] = Give<double>(std::move(throws));
  made["noise"] = found.Noise;
  made["smallest_throw"] = found.High;
  return made;
}

/// Both horizons are on one lattice.
nb::dict FindThickness(const PointArrays& horizon, const PointArrays& base, const nb::object& progress)
{
  Thickness found;
  Run(progress,
    [&](const Monitor& monitor)
    {
      const Points first = MakePoints(horizon);
      const Points other = MakePoints(base);
      found = MeasureThickness({ first.Columns, first.Height.data() }, { other.Columns, other.Height.data() },
        ScaleOf(first.Lattice), monitor);
    });
  nb::dict made;
  made["isochore"] = Give<double>(std::move(found.Isochore));
  made["isopach"] = Give<double>(std::move(found.Isopach));
  made["columns"] = found.Columns;
  made["left_out"] = found.LeftOut;
  made["crossings"] = found.Crossings;
  made["least"] = found.Least;
  made["mean"] = found.Mean;
  made["largest"] = found.Largest;
  made["volume"] = found.Volume;
  return made;
}

// ---- Writing --------------------------------------------------------------------------------------------------------
TSurf MakeTSurf(const std::string& name, const Tuples<double>& vertices, const Tuples<std::int32_t>& triangles,
  const nb::dict& attributes, bool isUp, const std::array<std::string, 4>& survey)
{
  TSurf surface;
  surface.Name = name;
  surface.Positive = isUp ? VerticalPositive::Elevation : VerticalPositive::Depth;
  surface.HasPositive = true;
  OverrideSurvey(surface.Survey, survey[0].c_str(), survey[1].c_str(), survey[2].c_str(), survey[3].c_str());
  for (std::size_t n = 0; n < vertices.shape(0); ++n)
  {
    surface.Vertices.push_back({ vertices(n, 0), vertices(n, 1), vertices(n, 2) });
  }
  for (std::size_t n = 0; n < triangles.shape(0); ++n)
  {
    surface.Triangles.push_back({ triangles(n, 0), triangles(n, 1), triangles(n, 2) });
  }
  for (const auto& [key, values] : attributes)
  {
    surface.Properties.push_back({ nb::cast<std::string>(key), "", 1, Copy(nb::cast<Values<double>>(values)) });
  }
  return surface;
}

/// Calls print(stream, monitor).
template <typename Print>
void WriteFile(const std::string& path, const nb::object& progress, Print&& print)
{
  Run(progress,
    [&](const Monitor& monitor)
    {
      std::ofstream stream(path, std::ios::binary);
      print(stream, monitor);
      if (!stream.flush())
      {
        throw std::runtime_error("cannot be written");
      }
    });
}

void WriteMesh(const std::string& path, const std::string& format, const std::string& name,
  const Tuples<double>& vertices, const Tuples<std::int32_t>& triangles, const nb::dict& attributes, bool isUp,
  const std::array<std::string, 4>& survey, const nb::object& progress)
{
  const TSurf surface = MakeTSurf(name, vertices, triangles, attributes, isUp, survey);
  WriteFile(path, progress,
    [&](std::ostream& stream, const Monitor& monitor)
    {
      if (format == "ts")
      {
        PrintTSurf(surface, true, stream, monitor);
      }
      else if (format == "dxf")
      {
        TextPrinter out(stream);
        const std::vector<std::string> layers = MakeLayerNames({ name });
        PrintDXFBegin(layers, out);
        PrintDXFFaces(surface, layers.front(), out, monitor);
        PrintDXFEnd(out);
      }
      else
      {
        (format == "stl" ? PrintSTL : format == "ply" ? PrintPLY : PrintOBJ)(surface, stream, monitor);
      }
    });
}

/// Returns the largest move of a column by rounding.
double WriteGrid(const std::string& path, const std::string& format, const std::string& name, const Values<double>& z,
  const std::array<int, 2>& size, const std::array<double, 2>& origin, const std::array<double, 2>& columnStep,
  const std::array<double, 2>& rowStep, const nb::object& progress)
{
  HorizonGrid grid;
  grid.Name = name;
  grid.Lattice.Columns = size;
  grid.Lattice.Origin = Eigen::Vector2d(origin.data());
  grid.Lattice.ColumnStep = Eigen::Vector2d(columnStep.data());
  grid.Lattice.RowStep = Eigen::Vector2d(rowStep.data());
  grid.Z = Copy(z);
  WriteFile(path, progress,
    [&](std::ostream& stream, const Monitor& monitor) {
      (format == "irap" ? WriteIrapText : format == "gri" ? WriteIrapBinary : WriteZmap)(stream, grid, monitor);
    });
  return format == "gri" ? RoundingOf(grid.Lattice) : 0.0;
}
}

NB_MODULE(_core, module)
{
  nb::register_exception_translator(
    [](const std::exception_ptr& raised, void*)
    {
      try
      {
        std::rethrow_exception(raised);
      }
      catch (const InputError& error)
      {
        PyErr_SetString(PyExc_ValueError, error.what());
      }
    });
  module.def("find_format", &FindFormat, "path"_a);
  module.def(
    "role_of", [](const std::string& name) { return std::string(RoleWord(RoleOfName(name))); }, "name"_a);
  module.def(
    "short_unit", [](const std::string& unit) { return ShortUnit(unit); }, "unit"_a);
  module.def("choose_z",
    [](const std::vector<std::string>& names, const std::string& remedy) { return ChooseZ(names, remedy.c_str()); });
  module.def(
    "read_grid", &ReadGrid, "path"_a, "nulls"_a, "vertical_step"_a, "direction"_a, "survey"_a, "progress"_a.none());
  module.def("read_sparse", &ReadSparse, "path"_a, "duplicates"_a, "direction"_a, "survey"_a, "progress"_a.none());
  module.def("read_text", &ReadText, "path"_a, "columns"_a, "nulls"_a, "header_lines"_a, "options"_a, "vertical_step"_a,
    "direction"_a, "survey"_a, "progress"_a.none());
  module.def("place_points", &PlacePoints, "arrays"_a, "attributes"_a, "names"_a, "options"_a, "vertical_step"_a,
    "direction"_a, "survey"_a, "progress"_a.none());
  module.def("noise", &Noise, "horizon"_a);
  module.def("surface", &MeshSurface, "horizon"_a, "filled"_a, "attributes"_a, "links"_a.none(), "options"_a,
    "progress"_a.none());
  module.def("fill_holes", &Fill, "horizon"_a, "attributes"_a, "links"_a.none(), "options"_a, "progress"_a.none());
  module.def("despike", &Despike, "horizon"_a, "threshold"_a, "radius"_a, "spur_width"_a, "progress"_a.none());
  module.def("faults", &FindFaults, "horizon"_a, "options"_a, "progress"_a.none());
  module.def("thickness", &FindThickness, "horizon"_a, "base"_a, "progress"_a.none());
  module.def("write_mesh", &WriteMesh, "path"_a, "format"_a, "name"_a, "points"_a, "triangles"_a, "attributes"_a,
    "is_up"_a, "survey"_a, "progress"_a.none());
  module.def("write_grid", &WriteGrid, "path"_a, "format"_a, "name"_a, "z"_a, "size"_a, "origin"_a, "column_step"_a,
    "row_step"_a, "progress"_a.none());
}
