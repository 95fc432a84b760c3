// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Data.h"

#include "Writers/FaultLines/FaultLinesFile.h"
#include "Writers/GOCADTSurf/HorizonTSurf.h"
#include "Writers/HorizonDXF/HorizonDXF.h"
#include "Writers/HorizonFiles.h"
#include "Writers/HorizonGrid/GridWriters.h"
#include "Writers/HorizonGrid/HorizonGridPrinter.h"
#include "Writers/HorizonLayers/LayersFile.h"
#include "Writers/SealedModel/SealedModelFile.h"
#include "Writers/HorizonMesh/HorizonMesh.h"
#include "Writers/HorizonSampling.h"
#include "Writers/HorizonText/HorizonText.h"
#include "Writers/VerneySparseMatrix/HorizonMatrix.h"
#include "Writers/VerneySparseMatrix/SparseMatrixPrinter.h"

#include <algorithm>
#include <cmath>

using namespace nanobind::literals;

namespace SeismicHorizons
{
namespace
{
const std::vector<std::string> Senses = { "as_read", "up", "down" };

/// Formats of several horizons in one file.
using Printer = std::function<void(const std::vector<NamedHorizon>&, std::ostream&, const Monitor&)>;

Printer ChoosePrinter(const std::string& format, const nb::dict& chosen, std::vector<std::string>& warnings)
{
  if (format == "ts")
  {
    TSurfOptions options;
    Take(chosen, "with_borders", options.WithBorders);
    bool isDown = false;
    Take(chosen, "is_down", isDown);
    options.Positive = isDown ? VerticalPositive::Depth : VerticalPositive::Elevation;
    options.Arrays = WrittenArrays::All;
    TakeChoice(chosen, "arrays", { "none", "picks", "all" }, options.Arrays);
    return [options](const auto& horizons, std::ostream& stream, const Monitor& monitor)
    { PrintTSurfs(horizons, options, stream, monitor); };
  }
  if (format == "dxf")
  {
    return PrintDXF;
  }
  if (format == "text")
  {
    HorizonTextOptions options;
    TakeChoice(chosen, "sense", Senses, options.Sense);
    Take(chosen, "with_attributes", options.WithAttributes);
    return [options](const auto& horizons, std::ostream& stream, const Monitor& monitor)
    { PrintHorizonText(horizons, options, stream, monitor); };
  }
  if (format == "vsm")
  {
    return [&warnings](const auto& horizons, std::ostream& stream, const Monitor& monitor)
    {
      WrittenMatrix matrix = MakeSparseMatrix(horizons, monitor.Step(0.0, 0.5));
      warnings = std::move(matrix.Warnings);
      PrintSparseMatrix(matrix.Matrix, stream, monitor.Step(0.5, 1.0));
    };
  }
  return nullptr;
}

/// Formats of one horizon; several get a file each.
Printer ChooseSinglePrinter(const std::string& format, const nb::dict& chosen, std::vector<std::string>& warnings)
{
  if (format == "stl" || format == "ply" || format == "obj")
  {
    return [format](const auto& horizons, std::ostream& stream, const Monitor& monitor)
    { PrintMesh(horizons.front(), format, stream, monitor); };
  }
  WrittenSense sense = WrittenSense::AsRead;
  TakeChoice(chosen, "sense", Senses, sense);
  const GridFileKind kind = ChooseFormat(GridFileKind::ByExtension, "grid." + format);
  return [kind, sense, &warnings](const auto& horizons, std::ostream& stream, const Monitor& monitor)
  {
    WrittenGrid written = MakeWrittenGrid(horizons.front(), kind, sense, monitor);
    warnings.insert(warnings.end(), written.Warnings.begin(), written.Warnings.end());
    PrintGrid(written.Grid, kind, stream, monitor.Step(0.6, 1.0));
  };
}

/// Returns warnings.
std::vector<std::string> Write(const std::string& path, const std::string& format, const nb::list& given,
  const nb::dict& chosen, const nb::object& progress)
{
  const std::vector<NamedHorizon> horizons = TakeNamed(given);
  std::vector<std::string> warnings;
  const Printer together = ChoosePrinter(format, chosen, warnings);
  const Printer print = together ? together : ChooseSinglePrinter(format, chosen, warnings);
  Run(progress,
    [&](const Monitor& monitor)
    {
      std::string subject;
      WriteHorizonFiles(path, horizons, !together, print, monitor, subject);
    });
  return warnings;
}

/// Writes lines of faults in the format of the extension.
void WriteFaults(const std::string& path, const nb::list& given, const std::string& sense, const nb::object& progress)
{
  const std::vector<NamedHorizon> lines = TakeNamed(given);
  WrittenSense written = WrittenSense::AsRead;
  nb::dict chosen;
  chosen["sense"] = sense;
  TakeChoice(chosen, "sense", Senses, written);
  Run(progress,
    [&](const Monitor& monitor)
    {
      std::string subject;
      WriteFaultLines(path, lines, written, monitor, subject);
    });
}

/// Writes pairs of a name and bytes: one into the path, several into files with the name added to that of the path.
void WriteContents(const std::string& path, const nb::list& given)
{
  std::vector<std::string> names;
  std::vector<nb::bytes> contents;
  for (const nb::handle& one : given)
  {
    const auto pair = nb::cast<nb::tuple>(one);
    names.push_back(nb::cast<std::string>(pair[0]));
    contents.push_back(nb::cast<nb::bytes>(pair[1]));
  }
  std::string subject;
  WriteFiles(
    names.size() == 1 ? std::vector<std::string>{ path } : NameFiles(path, names),
    [&](std::size_t n, std::ostream& stream, const Monitor&)
    { stream.write(contents[n].c_str(), std::streamsize(contents[n].size())); },
    Monitor(), subject);
}

/// Returns columns and rows, and heights there, of what a mesh covers; z is `sign` times world z.
nb::tuple Sample(const nb::dict& given, int sign, const nb::object& progress)
{
  const Horizon horizon = TakeData(given);
  const HorizonGrid grid =
    Run(progress, [&](const Monitor& monitor) { return SampleWholeLattice(horizon, sign, monitor); });
  const std::int64_t known = std::count_if(grid.Z.begin(), grid.Z.end(), [](double z) { return !std::isnan(z); });
  DataArray columns = DataArray::Make(ValueType::Int, known, 2);
  DataArray heights = DataArray::Make(ValueType::Double, known, 1);
  int* column = columns.As<int>();
  double* height = heights.As<double>();
  for (std::size_t n = 0; n < grid.Z.size(); ++n)
  {
    if (!std::isnan(grid.Z[n]))
    {
      *column++ = int(n % std::size_t(grid.Lattice.Columns[0]));
      *column++ = int(n / std::size_t(grid.Lattice.Columns[0]));
      *height++ = grid.Z[n];
    }
  }
  return nb::make_tuple(GiveArray(columns), GiveArray(heights));
}
}

//----------------------------------------------------------------------------------------------------------------------
void BindWriting(nb::module_& module)
{
  module.def(
    "write_layers",
    [](const std::string& path, const nb::dict& volumes, const nb::object& progress)
    {
      const VolumeGrid grid = TakeVolumes(volumes);
      Run(progress, [&](const Monitor& monitor) { WriteLayersFile(path, grid, monitor); });
    },
    "path"_a, "volumes"_a, "progress"_a.none());
  module.def(
    "write_sealed",
    [](const std::string& path, const nb::dict& surfaces, const nb::object& progress)
    {
      const Horizon model = TakeData(surfaces);
      Run(progress, [&](const Monitor& monitor) { WriteSealedModel(path, model, monitor); });
    },
    "path"_a, "surfaces"_a, "progress"_a.none());
  module.def(
    "layer_boundary",
    [](const nb::dict& volumes)
    {
      const LayerBoundary boundary = FindBoundary(TakeVolumes(volumes));
      std::vector<std::vector<std::vector<std::int64_t>>> faces(boundary.Names.size()); // cell and points, by group
      for (const BoundarySurface& surface : boundary.Surfaces)
      {
        for (const BoundaryFace& face : surface.Faces)
        {
          faces[surface.Group].push_back({ face.Cell });
          faces[surface.Group].back().insert(faces[surface.Group].back().end(), face.Points.begin(), face.Points.end());
        }
      }
      return nb::make_tuple(boundary.Names, boundary.PlainNames, faces);
    },
    "volumes"_a);
  module.def("write_contents", &WriteContents, "path"_a, "contents"_a);
  module.def("write_faults", &WriteFaults, "path"_a, "lines"_a, "sense"_a, "progress"_a.none());
  module.def("sample", &Sample, "mesh"_a, "sign"_a, "progress"_a.none());
  module.def("write", &Write, "path"_a, "format"_a, "horizons"_a, "options"_a, "progress"_a.none());
}
}
