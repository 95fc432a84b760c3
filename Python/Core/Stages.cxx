// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stages of horizons. Options are those of the stages, in snake case; missing ones have their defaults.

#include "Data.h"

#include "Filters/Algorithms/Surface/SurfaceParts.h"
#include "Filters/Boundary/BoundaryStage.h"
#include "Filters/BoundarySimplification/BoundarySimplificationStage.h"
#include "Filters/CellSimplification/CellSimplificationStage.h"
#include "Filters/Common/StageReport.h"
#include "Filters/Contours/ContoursStage.h"
#include "Filters/Decimation/DecimationStage.h"
#include "Filters/Despiking/DespikingStage.h"
#include "Filters/Faults/FaultStage.h"
#include "Filters/HoleFilling/HoleFillingStage.h"
#include "Filters/Surface/SurfaceStage.h"
#include "Filters/SurfaceDistance/DistanceStage.h"
#include "Filters/Thickness/ThicknessStage.h"
#include "Filters/Triangulation/TriangulationStage.h"

using namespace nanobind::literals;

namespace SeismicHorizons
{
namespace
{
const std::vector<std::string> HeightUnits = { "steps", "world", "diagonal" };
const std::vector<std::string> Growths = { "distance", "clockwise" };

using Warnings = std::vector<std::string>;

/// Calls stage(horizon, outputs, monitor), which returns warnings, without the lock. Returns outputs and warnings.
template <typename Stage>
nb::tuple Call(const nb::dict& given, std::size_t ports, bool takesMeshes, const nb::object& progress, Stage&& stage)
{
  const Horizon horizon = TakeData(given);
  std::vector<Horizon> outputs(ports);
  const Warnings warnings = Run(progress,
    [&](const Monitor& monitor) {
      return RunStage(horizon, takesMeshes, outputs, [&]() -> Warnings { return stage(horizon, outputs, monitor); });
    });
  return nb::make_tuple(GiveList(outputs), warnings);
}

/// For stages without warnings.
template <typename Stage>
nb::tuple CallSilent(
  const nb::dict& given, std::size_t ports, bool takesMeshes, const nb::object& progress, Stage&& stage)
{
  return Call(given, ports, takesMeshes, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    {
      stage(horizon, outputs, monitor);
      return Warnings();
    });
}

// ---- Stages of the thesis -------------------------------------------------------------------------------------------

nb::tuple Outline(const nb::dict& given, const nb::dict& chosen, const nb::object& progress)
{
  BoundaryStageOptions options;
  TakeChoice(chosen, "kind", { "exterior", "topological4", "topological8" }, options.Type);
  Take(chosen, "radius", options.Radius);
  TakeChoice(chosen, "growth", Growths, options.Growth);
  Take(chosen, "keep_holes", options.KeepHoles);
  Take(chosen, "smallest_hole_size", options.SmallestHoleSize);
  Take(chosen, "smallest_hole_area", options.SmallestHoleArea);
  Take(chosen, "minimum_patch_size", options.MinimumPatchSize);
  return Call(given, 1, false, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { return RunBoundary(horizon, options, outputs, monitor); });
}

nb::tuple SimplifyOutline(const nb::dict& given, const nb::dict& chosen, const nb::object& progress)
{
  BoundarySimplificationOptions options;
  TakeChoice(chosen, "method", { "threshold", "fewest_points" }, options.Method);
  Take(chosen, "distance_threshold", options.DistanceThreshold);
  Take(chosen, "bound_deviation", options.BoundDeviation);
  Take(chosen, "outline_tolerance", options.OutlineTolerance);
  return CallSilent(given, 1, false, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { RunBoundarySimplification(horizon, options, outputs, monitor); });
}

void TakeCellOptions(const nb::dict& chosen, CellOptions& options)
{
  Take(chosen, "cell_size", options.CellSize);
  TakeChoice(chosen, "representative", { "barycentre", "nearest_point" }, options.Representative);
}

nb::tuple SimplifyRoughly(const nb::dict& given, const nb::dict& chosen, const nb::object& progress)
{
  CellOptions options(3);
  std::int64_t most = 0;
  TakeCellOptions(chosen, options);
  Take(chosen, "maximum_number_of_points", most);
  return CallSilent(given, 1, false, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { RunRoughSimplification(horizon, options, most, outputs, monitor); });
}

nb::tuple SimplifyElaborately(const nb::dict& given, const nb::dict& chosen, const nb::object& progress)
{
  ElaborateOptions options;
  std::int64_t most = 0;
  TakeCellOptions(chosen, options);
  Take(chosen, "maximum_number_of_points", most);
  Take(chosen, "flatness_threshold", options.FlatnessThreshold);
  Take(chosen, "boundary_density_threshold", options.BoundaryDensityThreshold);
  Take(chosen, "boundary_extent_threshold", options.BoundaryExtentThreshold);
  Take(chosen, "boundary_cell_size_threshold", options.BoundaryCellSizeThreshold);
  Take(chosen, "smallest_cell_size", options.SmallestCellSize);
  TakeChoice(chosen, "neighbour_mean", { "over_cubes", "over_pieces" }, options.NeighbourMean);
  Take(chosen, "growth_per_ring", options.GrowthPerRing);
  return CallSilent(given, 1, false, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { RunElaborateSimplification(horizon, options, most, outputs, monitor); });
}

nb::tuple TriangulateHorizon(const nb::dict& given, const nb::dict& chosen, const nb::object& progress)
{
  TriangulationStageOptions options;
  TakeChoice(chosen, "search", { "voxel_traversal", "compactness" }, options.Strategy);
  Take(chosen, "convex_hull", options.ConvexHull);
  Take(chosen, "maximum_boundary_angle", options.Limits.LargestAngle);
  Take(chosen, "maximum_boundary_edge_length", options.Limits.LongestEdge);
  Take(chosen, "close_faults", options.CloseFaults);
  return CallSilent(given, 2, false, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { RunTriangulation(horizon, options, outputs, monitor); });
}

// ---- Meshes of fewer points -----------------------------------------------------------------------------------------

void TakeMeshOptions(const nb::dict& chosen, ReducedMeshOptions& options)
{
  Take(chosen, "maximum_error", options.MaximumError);
  TakeChoice(chosen, "error_unit", HeightUnits, options.ErrorUnit);
  Take(chosen, "fit_heights", options.FitHeights);
  TakeChoice(chosen, "effort", { "fast", "best" }, options.Effort);
  TakeChoice(chosen, "priority", { "largest_errors", "sum_of_squares" }, options.Priority);
  Take(chosen, "smallest_angle", options.SmallestAngle);
  Take(chosen, "edge_length", options.EdgeLength);
  Take(chosen, "edge_growth", options.EdgeGrowth);
  TakeChoice(chosen, "crossing_tolerance", { "same", "twice", "unbounded" }, options.Crossings);
  Take(chosen, "close_faults", options.CloseFaults);
}

nb::tuple DecimateHorizon(const nb::dict& given, const nb::dict& chosen, const nb::object& progress)
{
  DecimationStageOptions options;
  TakeMeshOptions(chosen, options);
  TakeChoice(chosen, "target", { "error", "points", "reduction" }, options.Target);
  Take(chosen, "maximum_number_of_points", options.MaximumNumberOfPoints);
  Take(chosen, "target_reduction", options.TargetReduction);
  return CallSilent(given, 1, true, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { RunDecimation(horizon, options, outputs, monitor); });
}

nb::tuple MeshSurface(const nb::dict& given, const nb::dict& chosen, const nb::object& progress)
{
  const SurfaceStageOptions options = TakeSurfaceOptions(chosen);
  return Call(given, 2, true, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { return RunSurface(horizon, options, outputs, monitor); });
}

/// Returns the columns that are meshed at a time of a horizon that is not in memory, with default options.
std::int64_t ColumnsOfPart(std::int32_t columns, std::int32_t rows)
{
  PlaneBox box;
  box.Add(PlanePoint{ 0, 0 });
  box.Add(PlanePoint{ columns - 1, rows - 1 });
  const std::int32_t rowsOfPart = RowsOfPart(box, SurfaceOptions(), 1);
  return std::int64_t(columns) * (rowsOfPart > 0 ? rowsOfPart : rows);
}

// ---- Preparations ---------------------------------------------------------------------------------------------------

nb::tuple Fill(const nb::dict& given, const nb::dict& chosen, const nb::object& progress)
{
  HoleFillingStageOptions options;
  TakeChoice(chosen, "method", { "plate", "membrane", "automatic" }, options.Method);
  Take(chosen, "largest_hole_size", options.LargestHoleSize);
  Take(chosen, "largest_hole_area", options.LargestHoleArea);
  Take(chosen, "rim_smoothing", options.RimSmoothing);
  Take(chosen, "rim_width", options.RimWidth);
  Take(chosen, "extrapolation_distance", options.ExtrapolationDistance);
  Take(chosen, "fill_attributes", options.FillAttributes);
  return CallSilent(given, 1, false, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { RunHoleFilling(horizon, options, outputs, monitor); });
}

nb::tuple Despike(const nb::dict& given, const nb::dict& chosen, const nb::object& progress)
{
  DespikingStageOptions options;
  Take(chosen, "threshold", options.Threshold);
  TakeChoice(chosen, "threshold_unit", HeightUnits, options.ThresholdUnit);
  Take(chosen, "radius", options.Radius);
  Take(chosen, "spur_width", options.SpurWidth);
  Take(chosen, "remove", options.Remove);
  return Call(given, 1, false, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { return RunDespiking(horizon, options, outputs, monitor); });
}

/// `lines` collects warnings.
nb::tuple FindFaults(const nb::dict& given, GivenFaults* lines, const nb::dict& chosen, const nb::object& progress)
{
  FaultStageOptions options;
  options.SmallestThrow = 0.0;
  Take(chosen, "detect", options.Detect);
  Take(chosen, "smallest_throw", options.SmallestThrow);
  Take(chosen, "noise", options.Noise);
  TakeChoice(chosen, "throw_unit", HeightUnits, options.ThrowUnit);
  Take(chosen, "smallest_extent", options.SmallestExtent);
  Take(chosen, "smallest_branch", options.SmallestBranch);
  Take(chosen, "largest_gap", options.LargestGap);
  Take(chosen, "largest_ramp", options.LargestRamp);
  Take(chosen, "join_through_holes", options.JoinThroughHoles);
  Take(chosen, "are_sticks", options.AreSticks);
  Take(chosen, "extend_sticks", options.ExtendSticks);
  TakeChoice(chosen, "polygons", { "blank", "cut", "leave" }, options.Polygons);
  GivenFaults none;
  return CallSilent(given, 3, false, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { RunFaults(horizon, lines ? *lines : none, options, outputs, monitor); });
}

nb::tuple DrawContours(const nb::dict& given, double interval, const nb::object& progress)
{
  return CallSilent(given, 1, true, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { RunContours(horizon, interval, outputs, monitor); });
}

// ---- Two horizons ---------------------------------------------------------------------------------------------------

nb::tuple FindThickness(const nb::dict& given, const nb::dict& other, const nb::object& progress)
{
  const Horizon base = TakeData(other);
  return Call(given, 1, true, progress,
    [&](const Horizon& horizon, std::vector<Horizon>& outputs, const Monitor& monitor)
    { return RunThickness(horizon, base, outputs, monitor); });
}

/// Returns both surfaces, and a table of figures in three directions, in lattice and in world units.
nb::tuple MeasureDistance(
  const nb::dict& reference, const nb::dict& mesh, const nb::dict& chosen, const nb::object& progress)
{
  DistanceStageOptions options;
  options.InWorldUnits = true;
  Take(chosen, "in_world_units", options.InWorldUnits);
  std::string name;
  Take(chosen, "name", name);
  Take(chosen, "samples_per_point", options.SamplesPerPoint);
  Take(chosen, "seed", options.Seed);
  Take(chosen, "radius", options.Radius);
  Take(chosen, "include_filled_points", options.IncludeFilledPoints);
  const Horizon first = TakeData(reference);
  const Horizon second = TakeData(mesh);
  const MeasuredPair measured =
    Run(progress, [&](const Monitor& monitor) { return RunSurfaceDistance(first, second, name, options, monitor); });
  return nb::make_tuple(GiveData(measured.Reference), GiveData(measured.Mesh), GiveTable(measured.Rows.Figures));
}
}

//----------------------------------------------------------------------------------------------------------------------
SurfaceStageOptions TakeSurfaceOptions(const nb::dict& chosen)
{
  SurfaceStageOptions options;
  TakeMeshOptions(chosen, options);
  Take(chosen, "maximum_number_of_triangles", options.MaximumNumberOfTriangles);
  Take(chosen, "radius", options.Radius);
  TakeChoice(chosen, "growth", Growths, options.Growth);
  Take(chosen, "keep_holes", options.KeepHoles);
  Take(chosen, "smallest_hole_size", options.SmallestHoleSize);
  Take(chosen, "minimum_patch_size", options.MinimumPatchSize);
  Take(chosen, "outline_tolerance", options.OutlineTolerance);
  Take(chosen, "distance_threshold", options.DistanceThreshold);
  Take(chosen, "rows_of_part", options.RowsOfPart);
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
void BindStages(nb::module_& module)
{
  const auto bind = [&module](const char* name, auto&& stage)
  { module.def(name, stage, "horizon"_a, "options"_a, "progress"_a.none()); };
  bind("boundary", &Outline);
  bind("boundary_simplification", &SimplifyOutline);
  bind("rough_simplification", &SimplifyRoughly);
  bind("elaborate_simplification", &SimplifyElaborately);
  bind("triangulation", &TriangulateHorizon);
  bind("decimation", &DecimateHorizon);
  bind("surface", &MeshSurface);
  bind("fill_holes", &Fill);
  bind("despike", &Despike);
  module.def("columns_of_part", &ColumnsOfPart, "columns"_a, "rows"_a);
  nb::class_<GivenFaults>(module, "GivenFaults")
    .def(
      "__init__",
      [](GivenFaults* self, const nb::dict& lines) {
        new (self) GivenFaults(std::vector<NamedHorizon>{ { "", TakeData(lines) } });
      },
      "lines"_a)
    .def("warnings", &GivenFaults::Warnings);
  module.def("faults", &FindFaults, "horizon"_a, "lines"_a.none(), "options"_a, "progress"_a.none());
  module.def("contours", &DrawContours, "surface"_a, "interval"_a, "progress"_a.none());
  module.def("thickness", &FindThickness, "horizon"_a, "base"_a, "progress"_a.none());
  module.def("distance", &MeasureDistance, "reference"_a, "mesh"_a, "options"_a, "progress"_a.none());
}
}
