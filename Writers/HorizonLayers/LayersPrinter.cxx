// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayersPrinter.h"

#include "Common/Base/Errors.h"
#include "Common/Text/TextPrinter.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t Kinds = 3;
constexpr int GmshVolume = 3; // dimension
constexpr std::size_t BetweenReports = 1 << 14;

std::size_t KindOf(std::size_t corners)
{
  return 6 - corners;
}

class CellGroups
{
public:
  explicit CellGroups(const VolumeCells& cells)
    : Groups(cells.Names.size() * Kinds)
  {
    for (std::size_t cell = 0; cell < cells.Size(); ++cell)
    {
      this->Groups[std::size_t(cells.Layers[cell]) * Kinds + KindOf(cells.SizeOf(cell))].push_back(cell);
    }
  }

  const std::vector<std::size_t>& Of(std::size_t layer, std::size_t kind) const
  {
    return this->Groups[layer * Kinds + kind];
  }
  bool HasLayer(std::size_t layer) const
  {
    return !this->Of(layer, 0).empty() || !this->Of(layer, 1).empty() || !this->Of(layer, 2).empty();
  }
  std::size_t Size() const
  {
    return std::size_t(std::count_if(
      this->Groups.begin(), this->Groups.end(), [](const std::vector<std::size_t>& group) { return !group.empty(); }));
  }

private:
  std::vector<std::vector<std::size_t>> Groups;
};

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

/// Pyramids become wedges with a repeated apex, since many solvers have no pyramids.
CellNodes NodesWithoutPyramids(const VolumeCells& cells, std::size_t cell)
{
  const CellNodes nodes = NodesOf(cells, cell);
  if (nodes.size() != 5)
  {
    return nodes;
  }
  const auto at = [&](std::size_t n) { return cells.Points[std::size_t(nodes[n] - 1)]; };
  const bool areOver =
    at(0)[0] == at(3)[0] && at(0)[1] == at(3)[1]; // Otherwise the first and the second corner are above each other.
  return areOver ? CellNodes{ nodes[4], nodes[1], nodes[0], nodes[4], nodes[2], nodes[3] }
                 : CellNodes{ nodes[4], nodes[0], nodes[3], nodes[4], nodes[1], nodes[2] };
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

std::vector<std::string> MakeSetNames(const std::vector<std::string>& names)
{
  constexpr std::size_t longest = 60;
  std::vector<std::string> sets;
  for (std::size_t layer = 0; layer < names.size(); ++layer)
  {
    std::string name = names[layer].substr(0, longest);
    std::replace_if(
      name.begin(), name.end(),
      [](char c) { return static_cast<unsigned char>(c) >= 0x80 || !std::isalnum(static_cast<unsigned char>(c)); },
      '_');
    sets.push_back("L" + std::to_string(layer + 1) + "_" + name);
  }
  return sets;
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

/// Each layer with cells is a physical volume of one entity.
void PrintGmshVolumes(const VolumeCells& cells, const std::vector<std::size_t>& layers, TextPrinter& out)
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
  out.Print("$PhysicalNames\n", layers.size(), "\n");
  for (const std::size_t layer : layers)
  {
    out.PrintLine(" ", GmshVolume, layer + 1, '"' + WithoutQuotes(cells.Names[layer]) + '"');
  }
  out.Print("$EndPhysicalNames\n$Entities\n");
  out.PrintLine(" ", 0, 0, 0, layers.size());
  for (const std::size_t layer : layers) // All entities share one bounding box.
  {
    out.PrintLine(" ", layer + 1, box[0], box[1], box[2], box[3], box[4], box[5], 1, layer + 1, 0);
  }
  out.Print("$EndEntities\n");
}

/// Gmsh wants one owner, although cells of several layers may share the node.
void PrintGmshNodes(const VolumeCells& cells, std::size_t owner, const Monitor& monitor, TextPrinter& out)
{
  const std::size_t count = cells.Points.size();
  out.Print("$Nodes\n");
  out.PrintLine(" ", 1, count, 1, count);
  out.PrintLine(" ", GmshVolume, owner + 1, 0, count);
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
  constexpr std::array<int, Kinds> types = { 6, 7, 4 };
  const CellGroups groups(cells);
  std::vector<std::size_t> layers;
  for (std::size_t layer = 0; layer < cells.Names.size(); ++layer)
  {
    if (groups.HasLayer(layer))
    {
      layers.push_back(layer);
    }
  }
  TextPrinter out(stream);
  out.Print("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
  PrintGmshVolumes(cells, layers, out);
  PrintGmshNodes(cells, layers.front(), monitor.Step(0.0, 0.4), out);
  out.Print("$Elements\n");
  out.PrintLine(" ", groups.Size(), cells.Size(), 1, cells.Size());
  std::int64_t printed = 0;
  for (const std::size_t layer : layers)
  {
    for (std::size_t kind = 0; kind < Kinds; ++kind)
    {
      const std::vector<std::size_t>& group = groups.Of(layer, kind);
      if (!group.empty())
      {
        out.PrintLine(" ", GmshVolume, layer + 1, types[kind], group.size());
        PrintCells(cells, group, " ", NodesOf, printed, out, monitor.Step(0.4, 1.0));
      }
    }
  }
  out.Print("$EndElements\n");
  out.Flush();
  monitor.Progress(1.0);
}

//----------------------------------------------------------------------------------------------------------------------
void PrintAbaqus(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor)
{
  constexpr std::array<std::string_view, Kinds> types = { "C3D6", "C3D6", "C3D4" };
  const CellGroups groups(cells);
  const std::vector<std::string> names = MakeSetNames(cells.Names);
  TextPrinter out(stream);
  out.Print("*HEADING\nLayers between seismic horizons\n*NODE\n");
  ForEach(cells.Points.size(), monitor.Step(0.0, 0.4),
    [&](std::size_t point)
    {
      const std::array<double, 3>& place = cells.Points[point];
      out.PrintLine(", ", point + 1, place[0], place[1], place[2]);
    });
  std::int64_t printed = 0;
  for (std::size_t layer = 0; layer < names.size(); ++layer)
  {
    for (std::size_t kind = 0; kind < Kinds; ++kind)
    {
      const std::vector<std::size_t>& group = groups.Of(layer, kind);
      if (!group.empty())
      {
        out.PrintLine("", "*ELEMENT, TYPE=", types[kind], ", ELSET=", names[layer]);
        PrintCells(cells, group, ", ", NodesWithoutPyramids, printed, out, monitor.Step(0.4, 1.0));
      }
    }
  }
  out.Flush();
  monitor.Progress(1.0);
}
}
