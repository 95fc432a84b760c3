// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cubes of amplitudes: dictionaries of the extent (first and last i, j and k), the map of indices to the world (16
// numbers, by rows), amplitudes (i fastest), optional ghosts, and field data.

#include "Data.h"

#include "Common/Survey/Units.h"
#include "Readers/SEGYCube/SEGYImage.h"
#include "Sources/Reflections/ReflectionStage.h"

#include <array>
#include <limits>

using namespace nanobind::literals;

namespace SeismicHorizons
{
namespace
{
using Matrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

std::array<double, 16> MapOf(const ImageFrame& frame)
{
  std::array<double, 16> map = {};
  Eigen::Map<Matrix> matrix(map.data());
  matrix.setIdentity();
  matrix.topLeftCorner<3, 3>() = frame.Direction * frame.Spacing.asDiagonal();
  matrix.topRightCorner<3, 1>() = frame.Origin;
  return map;
}

SeismicImage TakeCube(const nb::dict& given)
{
  SeismicImage image;
  image.Extent = nb::cast<std::array<int, 6>>(given["extent"]);
  const auto map = nb::cast<std::array<double, 16>>(given["to_world"]);
  image.ToWorld.matrix() = Eigen::Map<const Matrix>(map.data());
  image.Amplitudes = TakeArray(given["amplitudes"]);
  if (given.contains("ghosts"))
  {
    image.Ghosts = TakeArray(given["ghosts"]);
  }
  image.FieldData = TakeTable(given, "field_data");
  return image;
}

nb::tuple ReadCube(const std::string& path, const nb::dict& chosen, const std::string& direction,
  const std::array<std::string, 4>& survey, const nb::object& progress)
{
  SEGYOptions options;
  Take(chosen, "sample_format", options.FormatCode);
  Take(chosen, "inline_byte", options.LineFields.First);
  Take(chosen, "crossline_byte", options.LineFields.Second);
  Take(chosen, "x_byte", options.PlaceFields.First);
  Take(chosen, "y_byte", options.PlaceFields.Second);
  Take(chosen, "tolerance", options.Tolerance);
  Take(chosen, "vertical_step", options.VerticalStep);
  Take(chosen, "samples", options.Samples);
  Take(chosen, "ignore_incomplete_trace", options.IgnoreIncompleteTrace);
  TakeChoice(chosen, "duplicates", { "refuse", "first", "last", "mean" }, options.Duplicates);
  TakeChoice(chosen, "delays", { "interpolate", "nearest" }, options.Delays);
  SEGYRanges ranges;
  Take(chosen, "inlines", ranges.Inlines);
  Take(chosen, "crosslines", ranges.Crosslines);
  Take(chosen, "sample_range", ranges.Samples);
  double imageTolerance = std::numeric_limits<double>::infinity(); // The lattice has the places; the image is not drawn.
  Take(chosen, "image_tolerance", imageTolerance);
  CheckSEGYOptions(options);
  SEGYCube cube;
  CubeView view;
  CubeImage read;
  Run(progress,
    [&](const Monitor& monitor)
    {
      cube = ReadSEGYCube(path, options, monitor.Step(0.0, 0.1));
      SurveyDescription description = cube.Survey;
      OverrideSurvey(description, survey[0].c_str(), survey[1].c_str(), survey[2].c_str(), survey[3].c_str());
      view = MakeCubeView(
        cube, description, direction == "up" ? VerticalDirection::Up : VerticalDirection::Down, imageTolerance);
      read = ReadCubeImage(cube, view, FindExtent(cube, ranges), monitor.Step(0.1, 1.0));
    });
  std::vector<std::string> warnings;
  if (!cube.Warnings.empty())
  {
    warnings.push_back(WarningText(cube));
  }
  if (read.NotFinite > 0)
  {
    warnings.push_back(std::to_string(read.NotFinite) +
      " samples that are nan or beyond the range of a float; is sample_format right?");
  }
  nb::dict given;
  given["extent"] = nb::cast(read.Image.Extent);
  given["to_world"] = nb::cast(MapOf(view.Image));
  given["point_data"] = GiveTable(read.Image.PointData);
  given["field_data"] = GiveTable(read.Image.FieldData);
  given["description"] = Describe(cube);
  return nb::make_tuple(given, warnings);
}

ExtractionOptions TakeExtractionOptions(const nb::dict& chosen)
{
  ExtractionOptions options;
  Take(chosen, "phase_rotation", options.PhaseRotation);
  TakeChoice(chosen, "polarity", { "both", "positive", "negative" }, options.Reflections.Polarity);
  TakeChoice(chosen, "position", { "middle", "peak", "zero_crossing" }, options.Reflections.Position);
  TakeChoice(chosen, "threshold", { "amplitude", "percentile" }, options.Reflections.Threshold);
  Take(chosen, "amplitude_threshold", options.Reflections.AmplitudeThreshold);
  Take(chosen, "amplitude_percentile", options.Reflections.AmplitudePercentile);
  TakeChoice(chosen, "joining", { "best_first", "components" }, options.Joining);
  bool hasEight = false;
  Take(chosen, "eight_neighbours", hasEight);
  options.Connectivity = hasEight ? ColumnConnectivity::Eight : ColumnConnectivity::Four;
  Take(chosen, "largest_step", options.LargestStep);
  Take(chosen, "smallest_correlation", options.SmallestCorrelation);
  Take(chosen, "smallest_contact", options.SmallestContact);
  Take(chosen, "smallest_size", options.SmallestSize);
  Take(chosen, "largest_number", options.LargestNumber);
  TakeChoice(chosen, "order", { "strength", "size" }, options.Order);
  Take(chosen, "guide_tolerance", options.Guidance.Tolerance);
  Take(chosen, "growth_correlation", options.Guidance.GrowthCorrelation);
  Take(chosen, "growth_reach", options.Guidance.GrowthReach);
  Take(chosen, "keep_others", options.Guidance.KeepOthers);
  CheckOptions(options);
  return options;
}

nb::tuple Extract(const nb::dict& cube, const std::optional<nb::list>& guides, const std::optional<nb::list>& limits,
  const nb::dict& chosen, const nb::object& progress)
{
  const ExtractionOptions options = TakeExtractionOptions(chosen);
  ReflectionInputs inputs;
  inputs.Image = TakeCube(cube);
  if (guides)
  {
    inputs.Guides = TakeNamed(*guides);
  }
  if (limits)
  {
    inputs.Limits = TakeNamed(*limits);
  }
  TakeChoice(chosen, "limit_side", { "below", "above" }, inputs.Side);
  FoundReflections found;
  std::vector<NamedHorizon> surfaces;
  Run(progress,
    [&](const Monitor& monitor)
    {
      found = FindReflections(std::move(inputs), options, monitor);
      for (std::size_t n = 0; n < found.Names.size(); ++n)
      {
        surfaces.push_back({ found.Names[n], TakeSurface(found, n, true) });
      }
    });
  return nb::make_tuple(nb::make_tuple(GiveNamed(surfaces), found.Description, found.Result.Period), found.Warnings);
}
}

//----------------------------------------------------------------------------------------------------------------------
void BindCubes(nb::module_& module)
{
  module.def("read_cube", &ReadCube, "path"_a, "options"_a, "direction"_a, "survey"_a, "progress"_a.none());
  module.def("extract", &Extract, "cube"_a, "guides"_a.none(), "limits"_a.none(), "options"_a, "progress"_a.none());
}
}
