// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayersPrinter.h"

#include "Common/Base/Errors.h"
#include "Common/Text/TextPrinter.h"
#include "LayerBoundary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int GmshSurface = 2; // dimension
constexpr int GmshVolume = 3;
constexpr std::size_t BetweenReports = 1 << 14;

/// Cells by number, as of their layers, and by kind: wedges, pyramids and tetrahedra.
using CellGroups = std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>>;

CellGroups GroupCells(const VolumeCells& cells, const std::vector<int>& numbers)
{
  CellGroups groups;
  for (std::size_t cell = 0; cell < cells.Size(); ++cell)
  {
    groups[{ std::size_t(numbers[cell]), 6 - cells.SizeOf(cell) }].push_back(cell);
  }
  return groups;
}

using CellNodes = std::vector<std::int64_t>; // from 1

/// In Gmsh's wedges the other triangle comes first.
CellNodes NodesOf(const VolumeCells& cells, std::size_t cell)
{
  CellNodes nodes;
  const std::size_t size = cells.SizeOf(cell);
  for (std::size_t n = 0; n < size; ++n)
  {
    const std::size_t from = size == 6 ? (n + 3) % 6 : n;
    nodes.push_back(1 + cells.Corners[std::size_t(cells.FirstCorner(cell)) + from]);
  }
  return nodes;
}

/// True if the first and the last corner of the quadrangle of a pyramid are above each other; otherwise the first two are.
bool IsFirstOverLast(const VolumeCells& cells, const CellNodes& nodes)
{
  const auto at = [&](std::size_t n) { return cells.Points[std::size_t(nodes[n] - 1)]; };
  return at(0)[0] == at(3)[0] && at(0)[1] == at(3)[1];
}

/// Pyramids become wedges with a repeated apex, since many solvers have no pyramids.
CellNodes NodesWithoutPyramids(const VolumeCells& cells, std::size_t cell)
{
  const CellNodes nodes = NodesOf(cells, cell);
  if (nodes.size() != 5)
  {
    return nodes;
  }
  return IsFirstOverLast(cells, nodes) ? CellNodes{ nodes[4], nodes[1], nodes[0], nodes[4], nodes[2], nodes[3] }
                                       : CellNodes{ nodes[4], nodes[0], nodes[3], nodes[4], nodes[1], nodes[2] };
}

/// The number in the order of Abaqus.
int NumberOfFace(const VolumeCells& cells, const BoundaryFace& face)
{
  const CellNodes nodes = NodesOf(cells, std::size_t(face.Cell));
  const std::array<int, 5> numbers = nodes.size() == 6 ? std::array{ 2, 1, 3, 4, 5 }
    : nodes.size() == 4                                ? std::array{ 2, 3, 4, 1, 0 }
    : IsFirstOverLast(cells, nodes)                    ? std::array{ 4, 1, 3, 2, 5 }
                                                       : std::array{ 4, 3, 2, 5, 1 };
  return numbers[face.Number];
}

template <typename Nodes>
void PrintCells(const VolumeCells& cells, const std::vector<std::size_t>& group, std::string_view between,
  Nodes&& nodesOf, std::int64_t& printed, TextPrinter& out, const Monitor& monitor)
{
  for (const std::size_t cell : group)
  {
    if (std::size_t(printed) % BetweenReports == 0)
    {
      monitor.Progress(double(printed) / double(cells.Size()));
    }
    out.Print(++printed);
    for (const std::int64_t node : nodesOf(cells, cell))
    {
      out.Print(between, node);
    }
    out.Print("\n");
  }
}

void CheckCorners(const VolumeCells& cells, std::size_t cell)
{
  for (std::int64_t n = cells.FirstCorner(cell); n < cells.Ends[cell]; ++n)
  {
    const std::int64_t point = cells.Corners[std::size_t(n)];
    if (point < 0 || std::size_t(point) >= cells.Points.size())
    {
      throw InputError("point id " + std::to_string(point) + " in cell " + std::to_string(cell) + ", expected 0 to " +
        std::to_string(std::int64_t(cells.Points.size()) - 1));
    }
  }
}

void PrintGmshNames(const VolumeCells& cells, const LayerBoundary& boundary, TextPrinter& out)
{
  const std::set<int> layers(cells.Layers.begin(), cells.Layers.end());
  out.Print("$PhysicalNames\n", layers.size() + boundary.Names.size(), "\n");
  for (std::size_t group = 0; group < boundary.Names.size(); ++group)
  {
    out.PrintLine(" ", GmshSurface, group + 1, '"' + WithoutQuotes(boundary.Names[group]) + '"');
  }
  for (const int layer : layers)
  {
    out.PrintLine(" ", GmshVolume, layer + 1, '"' + WithoutQuotes(cells.Names[std::size_t(layer)]) + '"');
  }
  out.Print("$EndPhysicalNames\n");
}

/// Numbers of surfaces around a volume are negative if they look into it. All entities share one bounding box.
void PrintGmshEntities(const VolumeCells& cells, const LayerBoundary& boundary, TextPrinter& out)
{
  std::array<double, 6> box = { HUGE_VAL, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (const std::array<double, 3>& point : cells.Points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box[axis] = std::min(box[axis], point[axis]);
      box[3 + axis] = std::max(box[3 + axis], point[axis]);
    }
  }
  const auto print = [&](std::size_t entity, std::size_t group, const std::vector<std::int64_t>& around)
  {
    out.Print(std::int64_t(entity) + 1);
    std::for_each(box.begin(), box.end(), [&](double value) { out.Print(" ", value); });
    out.Print(" 1 ", group + 1, " ", around.size());
    std::for_each(around.begin(), around.end(), [&](std::int64_t number) { out.Print(" ", number); });
    out.Print("\n");
  };
  std::map<int, int> layers; // by region
  for (std::size_t cell = 0; cell < cells.Size(); ++cell)
  {
    layers[boundary.Regions[cell]] = cells.Layers[cell];
  }
  std::vector<std::vector<std::int64_t>> around(layers.size());
  out.Print("$Entities\n");
  out.PrintLine(" ", 0, 0, boundary.Surfaces.size(), around.size());
  for (std::size_t n = 0; n < boundary.Surfaces.size(); ++n)
  {
    const BoundarySurface& surface = boundary.Surfaces[n];
    print(n, surface.Group, {});
    around[std::size_t(surface.Region)].push_back(std::int64_t(n) + 1);
    if (surface.Other >= 0)
    {
      around[std::size_t(surface.Other)].push_back(-std::int64_t(n) - 1);
    }
  }
  for (const auto [region, layer] : layers)
  {
    print(std::size_t(region), std::size_t(layer), around[std::size_t(region)]);
  }
  out.Print("$EndEntities\n");
}

/// Gmsh wants one owner, although cells of several layers may share the node: the first volume.
void PrintGmshNodes(const VolumeCells& cells, const Monitor& monitor, TextPrinter& out)
{
  const std::size_t count = cells.Points.size();
  out.Print("$Nodes\n");
  out.PrintLine(" ", 1, count, 1, count);
  out.PrintLine(" ", GmshVolume, 1, 0, count);
  for (std::size_t point = 1; point <= count; ++point)
  {
    out.PrintLine("", point);
  }
  ForEach(count, monitor,
    [&](std::size_t point)
    {
      const std::array<double, 3>& place = cells.Points[point];
      out.PrintLine(" ", place[0], place[1], place[2]);
    });
  out.Print("$EndNodes\n");
}

/// By surface and number of corners.
using FaceBlocks = std::map<std::pair<std::size_t, std::size_t>, std::vector<const BoundaryFace*>>;

FaceBlocks MakeBlocks(const LayerBoundary& boundary)
{
  FaceBlocks blocks;
  for (std::size_t n = 0; n < boundary.Surfaces.size(); ++n)
  {
    for (const BoundaryFace& face : boundary.Surfaces[n].Faces)
    {
      blocks[{ n, face.Points.size() }].push_back(&face);
    }
  }
  return blocks;
}

void PrintGmshFaces(const FaceBlocks& blocks, std::int64_t printed, TextPrinter& out)
{
  for (const auto& [block, faces] : blocks)
  {
    out.PrintLine(" ", GmshSurface, block.first + 1, block.second - 1, faces.size());
    for (const BoundaryFace* const face : faces)
    {
      out.Print(++printed);
      std::for_each(face->Points.begin(), face->Points.end(), [&](std::int64_t point) { out.Print(" ", point + 1); });
      out.Print("\n");
    }
  }
}

void PrintAbaqusSurfaces(
  const VolumeCells& cells, const std::vector<std::int64_t>& elements, TextPrinter& out, const Monitor& monitor)
{
  const LayerBoundary boundary = FindBoundary(cells, monitor);
  std::size_t group = boundary.Names.size();
  for (const BoundarySurface& surface : boundary.Surfaces)
  {
    if (surface.Group != group)
    {
      group = surface.Group;
      out.PrintLine("", "*SURFACE, NAME=", boundary.PlainNames[group], ", TYPE=ELEMENT");
    }
    for (const BoundaryFace& face : surface.Faces)
    {
      out.PrintLine("", elements[std::size_t(face.Cell)], ", S", NumberOfFace(cells, face));
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckCells(const VolumeCells& cells)
{
  if (cells.Size() == 0)
  {
    throw InputError("no cells, expected layers as Horizon Layers makes them");
  }
  for (std::size_t point = 0; point < cells.Points.size(); ++point)
  {
    RequireFinitePoint(cells.Points[point], std::int64_t(point));
  }
  for (std::size_t cell = 0; cell < cells.Size(); ++cell)
  {
    CheckCorners(cells, cell);
    if (cells.Layers[cell] < 0 || std::size_t(cells.Layers[cell]) >= cells.Names.size())
    {
      throw InputError("layer " + std::to_string(cells.Layers[cell]) + " of cell " + std::to_string(cell) +
        ", expected 0 to " + std::to_string(std::int64_t(cells.Names.size()) - 1));
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PrintGmsh(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor)
{
  constexpr std::array<int, 3> types = { 6, 7, 4 };
  const LayerBoundary boundary = FindBoundary(cells, monitor.Step(0.0, 0.2));
  const CellGroups groups = GroupCells(cells, boundary.Regions);
  const FaceBlocks faces = MakeBlocks(boundary);
  TextPrinter out(stream);
  out.Print("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
  PrintGmshNames(cells, boundary, out);
  PrintGmshEntities(cells, boundary, out);
  PrintGmshNodes(cells, monitor.Step(0.2, 0.5), out);
  std::size_t elements = cells.Size();
  std::for_each(faces.begin(), faces.end(), [&](const auto& block) { elements += block.second.size(); });
  out.Print("$Elements\n");
  out.PrintLine(" ", groups.size() + faces.size(), elements, 1, elements);
  std::int64_t printed = 0;
  for (const auto& [place, group] : groups)
  {
    out.PrintLine(" ", GmshVolume, place.first + 1, types[place.second], group.size());
    PrintCells(cells, group, " ", NodesOf, printed, out, monitor.Step(0.5, 0.9));
  }
  PrintGmshFaces(faces, printed, out);
  out.Print("$EndElements\n");
  out.Flush();
  monitor.Progress(1.0);
}

//----------------------------------------------------------------------------------------------------------------------
void PrintAbaqus(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor)
{
  constexpr std::array<std::string_view, 3> types = { "C3D6", "C3D6", "C3D4" };
  TextPrinter out(stream);
  out.Print("*HEADING\nLayers between seismic horizons\n*NODE\n");
  ForEach(cells.Points.size(), monitor.Step(0.0, 0.4),
    [&](std::size_t point)
    {
      const std::array<double, 3>& place = cells.Points[point];
      out.PrintLine(", ", point + 1, place[0], place[1], place[2]);
    });
  std::int64_t printed = 0;
  std::vector<std::int64_t> elements(cells.Size()); // by cell
  for (const auto& [place, group] : GroupCells(cells, cells.Layers))
  {
    out.Print("*ELEMENT, TYPE=", types[place.second], ", ELSET=L", place.first + 1, "_");
    out.PrintLine("", PlainName(cells.Names[place.first]));
    std::int64_t element = printed;
    std::for_each(group.begin(), group.end(), [&](std::size_t cell) { elements[cell] = ++element; });
    PrintCells(cells, group, ", ", NodesWithoutPyramids, printed, out, monitor.Step(0.4, 0.8));
  }
  PrintAbaqusSurfaces(cells, elements, out, monitor.Step(0.8, 1.0));
  out.Flush();
  monitor.Progress(1.0);
}
}
