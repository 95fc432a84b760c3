// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealedOutput.h"

#include "Common/Horizon/DataModel.h"
#include "Filters/Common/CellWriter.h"
#include "Filters/Common/StageReport.h"
#include "ModelTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
const SealedSurface& SurfaceOf(const SealedModel& model, const SealedTriangle& triangle)
{
  return model.Surfaces[std::size_t(triangle.Surface)];
}

double AreaOf(const SealedModel& model, const SealedTriangle& triangle)
{
  const Eigen::Vector3d& a = model.Vertices[std::size_t(triangle.Corners[0])];
  const Eigen::Vector3d b = model.Vertices[std::size_t(triangle.Corners[1])] - a;
  const Eigen::Vector3d c = model.Vertices[std::size_t(triangle.Corners[2])] - a;
  return 0.5 * b.cross(c).norm();
}

std::string NameBody(const SealedModel& model, const std::vector<std::string>& layers, std::int32_t body)
{
  if (body < 0)
  {
    return "outside";
  }
  const SealedBody& own = model.Bodies[std::size_t(body)];
  const std::string block = NameBlock(model, model.Blocks[own.Block]);
  return layers[own.Layer] + (block.empty() ? "" : ", " + block);
}

std::string NameLayerOf(const SealedModel& model, const std::vector<std::string>& layers, std::int32_t body)
{
  return body < 0 ? "outside" : layers[model.Bodies[std::size_t(body)].Layer];
}

/// The triangles that are wanted, with their points; `sideOf` gives -1 for none, 1 for those that are turned.
template <typename SideOf>
Horizon WriteSealedTriangles(const SealedModel& model, SideOf&& sideOf, std::vector<const SealedTriangle*>& written)
{
  CellWriter cells;
  std::vector<std::int64_t> numbers(model.Vertices.size(), -1);
  std::vector<unsigned char> sources;
  for (const SealedTriangle& triangle : model.Triangles)
  {
    const int side = sideOf(triangle);
    for (std::size_t n = 0; n < 3 && side >= 0; ++n)
    {
      const auto vertex = std::size_t(triangle.Corners[side == 1 ? 2 - n : n]);
      if (numbers[vertex] < 0)
      {
        numbers[vertex] = cells.AddPoint(model.Vertices[vertex]);
        sources.push_back(static_cast<unsigned char>(model.Sources[vertex]));
      }
      cells.Use(numbers[vertex]);
    }
    if (side >= 0)
    {
      cells.Close();
      written.push_back(&triangle);
    }
  }
  Horizon output;
  cells.Finish(output, &Horizon::Polygons);
  AddArray<unsigned char>(output.PointData, PointArray::Guessed, sources);
  std::vector<std::string> names;
  std::vector<unsigned char> types;
  for (const SealedTriangle* const triangle : written)
  {
    names.push_back(SurfaceOf(model, *triangle).Name);
    types.push_back(static_cast<unsigned char>(SurfaceOf(model, *triangle).Type));
  }
  output.CellData.Add({ CellArray::SurfaceName, std::move(names) });
  AddArray<unsigned char>(output.CellData, CellArray::SurfaceType, types);
  return output;
}

Horizon WriteSurfaces(const SealedModel& model, const std::vector<std::string>& layers)
{
  std::vector<const SealedTriangle*> written;
  Horizon output = WriteSealedTriangles(
    model, [](const SealedTriangle&) { return 0; }, written);
  std::vector<int> above, below;
  std::vector<std::string> layerAbove, layerBelow;
  for (const SealedTriangle* const triangle : written)
  {
    above.push_back(triangle->Body[0]);
    below.push_back(triangle->Body[1]);
    layerAbove.push_back(NameLayerOf(model, layers, triangle->Body[0]));
    layerBelow.push_back(NameLayerOf(model, layers, triangle->Body[1]));
  }
  AddArray<int>(output.CellData, CellArray::BodyAbove, above);
  AddArray<int>(output.CellData, CellArray::BodyBelow, below);
  output.CellData.Add({ CellArray::LayerAbove, std::move(layerAbove) });
  output.CellData.Add({ CellArray::LayerBelow, std::move(layerBelow) });
  std::vector<std::string> names;
  std::vector<int> layerNumbers, blocks;
  std::vector<double> volumes;
  for (std::size_t body = 0; body < model.Bodies.size(); ++body)
  {
    names.push_back(NameBody(model, layers, std::int32_t(body)));
    layerNumbers.push_back(int(model.Bodies[body].Layer));
    blocks.push_back(int(model.Bodies[body].Block));
    volumes.push_back(model.Bodies[body].Volume);
  }
  output.FieldData.Add({ FieldArray::BodyName, std::move(names) });
  AddArray<int>(output.FieldData, FieldArray::BodyLayer, layerNumbers);
  AddArray<int>(output.FieldData, FieldArray::BodyBlock, blocks);
  AddArray<double>(output.FieldData, FieldArray::BodyVolume, volumes);
  return output;
}

ClosedModel ToClosedModel(const SealedModel& model)
{
  ClosedModel closed;
  for (const Eigen::Vector3d& vertex : model.Vertices)
  {
    closed.Points.push_back({ vertex.x(), vertex.y(), vertex.z() });
  }
  for (const SealedTriangle& triangle : model.Triangles)
  {
    const auto point = [&](std::size_t corner) { return PointId(triangle.Corners[corner]); };
    closed.Triangles.push_back({ { point(0), point(1), point(2) }, std::size_t(triangle.Surface), triangle.Body });
  }
  for (const SealedSurface& surface : model.Surfaces)
  {
    closed.Surfaces.push_back({ surface.Name, int(surface.Type) });
  }
  closed.Bodies.resize(model.Bodies.size());
  return closed;
}

/// Kinds of lines by what meets there.
std::string TypeOfLine(const SealedModel& model, const std::set<std::size_t>& surfaces)
{
  const auto has = [&](SealedSurfaceType type)
  {
    return std::any_of(
      surfaces.begin(), surfaces.end(), [&](std::size_t surface) { return model.Surfaces[surface].Type == type; });
  };
  const bool isOutside = has(SealedSurfaceType::Wall) || has(SealedSurfaceType::Limit);
  return has(SealedSurfaceType::Horizon) && has(SealedSurfaceType::Fault) ? "cutoff"
    : has(SealedSurfaceType::Horizon)                                     ? (isOutside ? "outline" : "pinch-out")
    : has(SealedSurfaceType::Fault)                                       ? (isOutside ? "trace" : "branch")
                                                                          : "edge";
}

Horizon WriteLines(const SealedModel& model)
{
  CellWriter cells;
  std::vector<std::string> types, names;
  const ModelTopology topology = FindTopology(ToClosedModel(model));
  for (const ModelTopology::Line& line : topology.Lines)
  {
    for (const PointId point : line.Points)
    {
      cells.Add(model.Vertices[std::size_t(point)]);
    }
    cells.Close();
    std::set<std::size_t> surfaces;
    for (const auto& [face, isForward] : line.Faces)
    {
      surfaces.insert(topology.Faces[face].Surface);
    }
    types.push_back(line.Faces.size() == 1 ? "tip" : TypeOfLine(model, surfaces));
    std::string name;
    for (const std::size_t surface : surfaces)
    {
      name += (name.empty() ? "" : ", ") + model.Surfaces[surface].Name;
    }
    names.push_back(name);
  }
  Horizon output;
  cells.Finish(output, &Horizon::Lines);
  output.CellData.Add({ CellArray::LineType, std::move(types) });
  output.CellData.Add({ CellArray::SurfaceName, std::move(names) });
  return output;
}

ArrayTable WriteBodyTable(const SealedModel& model, const std::vector<std::string>& layers)
{
  ArrayTable table;
  std::vector<std::string> names, blocks;
  std::vector<double> volumes, areas(model.Bodies.size(), 0.0);
  for (const SealedTriangle& triangle : model.Triangles)
  {
    for (const std::int32_t body : triangle.Body)
    {
      if (body >= 0)
      {
        areas[std::size_t(body)] += AreaOf(model, triangle);
      }
    }
  }
  for (const SealedBody& body : model.Bodies)
  {
    names.push_back(layers[body.Layer]);
    blocks.push_back(NameBlock(model, model.Blocks[body.Block]));
    volumes.push_back(body.Volume);
  }
  table.Add({ "Layer", std::move(names) });
  table.Add({ "Block", std::move(blocks) });
  AddArray<double>(table, "Volume", volumes);
  AddArray<double>(table, "Area", areas);
  return table;
}

ArrayTable WriteFaultAreas(const SealedModel& model, const std::vector<std::string>& layers)
{
  std::map<std::tuple<std::string, std::string, std::string>, double> sums;
  for (const SealedTriangle& triangle : model.Triangles)
  {
    if (SurfaceOf(model, triangle).Type == SealedSurfaceType::Fault)
    {
      sums[{ SurfaceOf(model, triangle).Name, NameLayerOf(model, layers, triangle.Body[1]),
        NameLayerOf(model, layers, triangle.Body[0]) }] += AreaOf(model, triangle);
    }
  }
  std::vector<std::string> faults, foot, hanging;
  std::vector<double> areas;
  for (const auto& [key, area] : sums)
  {
    faults.push_back(std::get<0>(key));
    foot.push_back(std::get<1>(key));
    hanging.push_back(std::get<2>(key));
    areas.push_back(area);
  }
  ArrayTable table;
  table.Add({ "Fault", std::move(faults) });
  table.Add({ "Footwall", std::move(foot) });
  table.Add({ "HangingWall", std::move(hanging) });
  AddArray<double>(table, "Area", areas);
  return table;
}

/// What became of picks.
ArrayTable WritePickTable(const SealedModel& model)
{
  ArrayTable table;
  std::vector<std::string> names;
  for (std::size_t n = 0; n < model.Accounts.size(); ++n)
  {
    names.push_back(model.Surfaces[n].Name);
  }
  table.Add({ "Horizon", std::move(names) });
  const auto add = [&](const char* title, auto member)
  {
    using Value = std::decay_t<decltype(PickAccount().*member)>;
    using Stored = std::conditional_t<std::is_floating_point_v<Value>, double, std::int64_t>;
    AddArray<Stored>(
      table, title, model.Accounts, [member](const PickAccount& own) { return static_cast<Stored>(own.*member); });
  };
  add("Used", &PickAccount::Used);
  add("BesideFaults", &PickAccount::BesideFaults);
  add("NotAgreeing", &PickAccount::NotAgreeing);
  add("Doubled", &PickAccount::Doubled);
  add("Outside", &PickAccount::Outside);
  add("Moved", &PickAccount::Moved);
  add("LargestMove", &PickAccount::LargestMove);
  add("Columns", &PickAccount::Columns);
  add("Continued", &PickAccount::Continued);
  return table;
}

std::string ReportSealed(const SealedModel& model, const std::vector<std::string>& layers)
{
  std::ostringstream text = MakeReportStream();
  std::set<std::size_t> blocks;
  for (const SealedBody& body : model.Bodies)
  {
    blocks.insert(body.Block);
  }
  text << model.Bodies.size() << " bodies of " << layers.size() << " layers in " << blocks.size() << " blocks, "
       << model.Vertices.size() << " points, " << model.Triangles.size() << " triangles, largest error "
       << model.LargestError << "\n";
  for (std::size_t layer = 0; layer < layers.size(); ++layer)
  {
    double volume = 0.0;
    for (const SealedBody& body : model.Bodies)
    {
      volume += body.Layer == layer ? body.Volume : 0.0;
    }
    text << layers[layer] << ": volume " << volume << "\n";
  }
  for (std::size_t n = 0; n < model.Accounts.size(); ++n)
  {
    const PickAccount& own = model.Accounts[n];
    text << model.Surfaces[n].Name << ": " << own.Used << " picks used, not "
         << own.BesideFaults + own.NotAgreeing + own.Doubled + own.Outside << " (beside faults " << own.BesideFaults
         << ", not agreeing " << own.NotAgreeing << ", doubled " << own.Doubled << ", outside " << own.Outside
         << "); continued over " << own.Continued << " of " << own.Columns << " columns\n";
  }
  return text.str();
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> NameLayers(const SealedModel& model)
{
  std::vector<std::string> names;
  for (const SealedSurface& surface : model.Surfaces)
  {
    if (surface.Type != SealedSurfaceType::Horizon)
    {
      break;
    }
    names.push_back(names.empty() ? "above " + surface.Name : "");
    if (names.size() > 1)
    {
      names.back() = model.Surfaces[names.size() - 2].Name + " to " + surface.Name;
    }
  }
  names.push_back("below " + model.Surfaces[names.size() - 1].Name);
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
std::string NameBlock(const SealedModel& model, const std::vector<signed char>& sides)
{
  std::string name;
  std::set<std::string> named; // A fault with two parts is named once.
  for (std::size_t fault = 0; fault < sides.size(); ++fault)
  {
    const std::string side = model.FaultNames[fault] + (sides[fault] > 0 ? " hanging wall" : " footwall");
    if (sides[fault] != 0 && named.insert(side).second)
    {
      name += (name.empty() ? "" : ", ") + side;
    }
  }
  return name;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteSealed(const SealedModel& model, const ArrayTable& fields, SealedStageResult& result)
{
  const std::vector<std::string> layers = NameLayers(model);
  const auto withFields = [&fields](Horizon data)
  {
    data.FieldData.AddAll(fields);
    return data;
  };
  result.Surfaces = withFields(WriteSurfaces(model, layers));
  result.Lines = withFields(WriteLines(model));
  for (std::size_t body = 0; body < model.Bodies.size(); ++body)
  {
    const auto number = std::int32_t(body);
    std::vector<const SealedTriangle*> written;
    const auto sideOf = [number](const SealedTriangle& triangle)
    {
      return triangle.Body[0] == triangle.Body[1] ? -1 // a fault that dies out in the body
        : triangle.Body[1] == number              ? 0
        : triangle.Body[0] == number              ? 1
                                                  : -1;
    };
    Horizon surface = WriteSealedTriangles(model, sideOf, written);
    AddArray<int>(surface.CellData, CellArray::Layer, std::vector<int>(written.size(), int(model.Bodies[body].Layer)));
    result.Bodies.push_back(withFields(std::move(surface)));
    result.BodyNames.push_back(NameBody(model, layers, number));
  }
  result.Figures = WriteBodyTable(model, layers);
  result.Areas = WriteFaultAreas(model, layers);
  result.Picks = WritePickTable(model);
  result.Report = ReportSealed(model, layers);
}
}
