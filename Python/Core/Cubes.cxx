// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cubes of amplitudes: dictionaries of the extent (first and last i, j and k), the map of indices to the world (16
// numbers, by rows), amplitudes (i fastest) and optional ghosts, or the file that has them, and field data.

#include "Data.h"

#include "Common/Survey/Units.h"
#include "Readers/SEGYCube/SEGYImage.h"
#include "Readers/SEGYCube/SEGYTraces.h"
#include "Sources/Reflections/ReflectionStage.h"

#include <array>
#include <limits>
#include <memory>

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

SEGYOptions TakeCubeOptions(const nb::dict& chosen)
{
  SEGYOptions options;
  Take(chosen, "sample_format", options.FormatCode);
  Take(chosen, "inline_byte", options.LineFields.First);
  Take(chosen, "crossline_byte", options.LineFields.Second);
  Take(chosen, "x_byte", options.PlaceFields.First);
  Take(chosen, "y_byte", options.PlaceFields.Second);
  Take(chosen, "tolerance", options.Tolerance);
  Take(chosen, "vertical_step", options.VerticalStep);
  Take(chosen, "number_of_samples", options.Samples);
  Take(chosen, "ignore_incomplete_trace", options.IgnoreIncompleteTrace);
  TakeChoice(chosen, "duplicates", { "refuse", "first", "last", "mean" }, options.Duplicates);
  TakeChoice(chosen, "delays", { "interpolate", "nearest" }, options.Delays);
  CheckSEGYOptions(options);
  return options;
}

/// A cube of which the headers are known.
class CubeFile
{
public:
  CubeFile(const std::string& path, const nb::dict& chosen, const nb::object& progress)
  {
    const SEGYOptions options = TakeCubeOptions(chosen);
    SEGYRanges ranges;
    Take(chosen, "inlines", ranges.Inlines);
    Take(chosen, "crosslines", ranges.Crosslines);
    Take(chosen, "sample_range", ranges.Samples);
    Run(progress,
      [&](const Monitor& monitor)
      {
        this->Cube = std::make_shared<const SEGYCube>(ReadSEGYCube(path, options, monitor));
        this->Extent = FindExtent(*this->Cube, ranges);
      });
  }

  /// The number that is read.
  std::int64_t CountSamples() const
  {
    const auto& e = this->Extent;
    return std::int64_t(e[1] - e[0] + 1) * (e[3] - e[2] + 1) * (e[5] - e[4] + 1);
  }

  std::int64_t CountTraces() const
  {
    const auto& e = this->Extent;
    return std::int64_t(e[1] - e[0] + 1) * (e[3] - e[2] + 1);
  }

  /// Returns the image, without points if samples stay in the file, and warnings.
  nb::tuple Read(const std::string& direction, const std::array<std::string, 4>& survey, bool isLoaded,
    const nb::object& progress) const
  {
    CubeView view;
    CubeImage read;
    const SEGYCube& cube = *this->Cube;
    SurveyDescription description = cube.Survey;
    OverrideSurvey(description, survey[0].c_str(), survey[1].c_str(), survey[2].c_str(), survey[3].c_str());
    Run(progress,
      [&](const Monitor& monitor)
      {
        // The lattice has the places; the image is not drawn.
        view = MakeCubeView(cube, description, direction == "up" ? VerticalDirection::Up : VerticalDirection::Down,
          std::numeric_limits<double>::infinity());
        read = ReadCubeImage(cube, view, isLoaded ? this->Extent : CubeExtent{ 0, -1, 0, -1, 0, -1 }, monitor);
      });
    const std::vector<std::string> warnings = { WarningText(cube), NullsText(read.Nulls) };
    nb::dict given;
    given["extent"] = nb::cast(this->Extent);
    given["to_world"] = nb::cast(MapOf(view.Image));
    given["point_data"] = GiveTable(read.Image.PointData);
    given["field_data"] = GiveTable(read.Image.FieldData);
    if (!cube.Places.empty())
    {
      auto extent = this->Extent;
      extent[4] = extent[5];
      given["line"] = GiveArray(PlaceLineSamples(cube, view.Frame, extent));
    }
    given["description"] = Describe(cube, description);
    return nb::make_tuple(given, warnings);
  }

  TraceCube Traces() const
  {
    const auto& e = this->Extent;
    const auto traces = std::make_shared<const SEGYTraces>(this->Cube, e);
    return { { e[1] - e[0] + 1, e[3] - e[2] + 1, e[5] - e[4] + 1 },
      [traces](int j, int first, int count, float* samples) { traces->Read(j, first, count, samples); } };
  }

private:
  std::shared_ptr<const SEGYCube> Cube;
  CubeExtent Extent = {};
};

SeismicImage TakeCube(const nb::dict& given)
{
  SeismicImage image;
  image.Extent = nb::cast<std::array<int, 6>>(given["extent"]);
  const auto map = nb::cast<std::array<double, 16>>(given["to_world"]);
  image.ToWorld.matrix() = Eigen::Map<const Matrix>(map.data());
  if (given.contains("file"))
  {
    image.InFile = nb::cast<const CubeFile&>(given["file"]).Traces();
  }
  else
  {
    image.Amplitudes = TakeArray(given["amplitudes"]);
  }
  if (given.contains("ghosts"))
  {
    image.Ghosts = TakeArray(given["ghosts"]);
  }
  image.FieldData = TakeTable(given, "field_data");
  return image;
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
  Take(chosen, "least_confidence", options.Guidance.LeastConfidence);
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
  nb::class_<CubeFile>(module, "CubeFile")
    .def(nb::init<const std::string&, const nb::dict&, const nb::object&>(), "path"_a, "options"_a, "progress"_a.none())
    .def_prop_ro("samples", &CubeFile::CountSamples)
    .def_prop_ro("traces", &CubeFile::CountTraces)
    .def("read", &CubeFile::Read, "direction"_a, "survey"_a, "is_loaded"_a, "progress"_a.none());
  module.def("extract", &Extract, "cube"_a, "guides"_a.none(), "limits"_a.none(), "options"_a, "progress"_a.none());
}
}
