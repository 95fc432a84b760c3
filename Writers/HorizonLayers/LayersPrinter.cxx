// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayersPrinter.h"

#include "Common/Errors.h"
#include "Common/TextPrinter.h"

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
constexpr std::array<std::size_t, Kinds> SizeOfKind = { 6, 5, 4 };
constexpr std::size_t BetweenReports = 1 << 14; // cells

std::size_t KindOf(std::size_t corners)
{
  return 6 - corners;
}

std::int64_t FirstCorner(const VolumeCells& cells, std::size_t cell)
{
  return cell == 0 ? 0 : cells.Ends[cell - 1];
}

std::size_t SizeOf(const VolumeCells& cells, std::size_t cell)
{
  return std::size_t(cells.Ends[cell] - FirstCorner(cells, cell));
}

/// The cells of each layer, by their kinds.
class CellGroups
{
public:
  explicit CellGroups(const VolumeCells& cells)
    : Groups(cells.Names.size() * Kinds)
  {
    for (std::size_t cell = 0; cell < cells.Size(); ++cell)
    {
      this->Groups[std::size_t(cells.Layers[cell]) * Kinds + KindOf(SizeOf(cells, cell))].push_back(cell);
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

/// A text file of words and numbers.
class LinePrinter
{
public:
  explicit LinePrinter(std::ostream& stream)
    : Out(stream)
  {
  }

  template <typename Value>
  LinePrinter& Add(const Value& value)
  {
    if constexpr (std::is_same_v<Value, double>)
    {
      this->Out.Print(value);
    }
    else if constexpr (std::is_integral_v<Value>)
    {
      this->Out.Print(std::int64_t(value));
    }
    else
    {
      this->Out.Print(std::string_view(value));
    }
    return *this;
  }

  /// Values with something between them.
  template <typename First, typename... Others>
  void Line(std::string_view between, const First& first, const Others&... others)
  {
    this->Add(first);
    (this->Add(between).Add(others), ...);
    this->Add("\n");
  }

  void Flush() { this->Out.Flush(); }

private:
  TextPrinter Out;
};

using CellNodes = std::vector<std::int64_t>; // from 1

/// As Gmsh has them: of wedges the other triangle comes first.
CellNodes NodesOf(const VolumeCells& cells, std::size_t cell)
{
  CellNodes nodes;
  const std::size_t size = SizeOf(cells, cell);
  for (std::size_t n = 0; n < size; ++n)
  {
    const std::size_t from = size == 6 ? (n + 3) % 6 : n;
    nodes.push_back(1 + cells.Corners[std::size_t(FirstCorner(cells, cell)) + from]);
  }
  return nodes;
}

/// The same with pyramids as wedges of which the apex is two nodes: pyramids are unknown to many solvers.
CellNodes NodesWithoutPyramids(const VolumeCells& cells, std::size_t cell)
{
  const CellNodes nodes = NodesOf(cells, cell);
  if (nodes.size() != 5)
  {
    return nodes;
  }
  const auto at = [&](std::size_t n) { return cells.Points[std::size_t(nodes[n] - 1)]; };
  const bool areOver =
    at(0)[0] == at(3)[0] && at(0)[1] == at(3)[1]; // each other; else the first and the second one are
  return areOver ? CellNodes{ nodes[4], nodes[1], nodes[0], nodes[4], nodes[2], nodes[3] }
                 : CellNodes{ nodes[4], nodes[0], nodes[3], nodes[4], nodes[1], nodes[2] };
}

/// Prints the cells of a group, each on a line with its number; `printed` counts cells.
template <typename Nodes>
void PrintCells(const VolumeCells& cells, const std::vector<std::size_t>& group, std::string_view between,
  Nodes&& nodesOf, std::int64_t& printed, LinePrinter& out, const Monitor& monitor)
{
  for (const std::size_t cell : group)
  {
    if (std::size_t(printed) % BetweenReports == 0)
    {
      monitor.Progress(double(printed) / double(cells.Size()));
    }
    out.Add(++printed);
    for (const std::int64_t node : nodesOf(cells, cell))
    {
      out.Add(between).Add(node);
    }
    out.Add("\n");
  }
}

std::string WithoutQuotes(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c == '"' || std::iscntrl(static_cast<unsigned char>(c)); }, '_');
  return name;
}

/// Of letters, digits and underscores, and each once.
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

// ---- Columns of level cells ----------------------------------------------------------------------------------------
/// A cell over a triangle of the plan, as a level one.
struct LevelCell
{
  std::int64_t Triangle;
  int Layer;
  std::array<std::int64_t, 3> Vertices; // ascending
  double Top;
  double Base;

  friend bool operator<(const LevelCell& a, const LevelCell& b)
  {
    return a.Triangle != b.Triangle ? a.Triangle < b.Triangle : a.Layer < b.Layer;
  }
};

class LevelGrid
{
public:
  explicit LevelGrid(const VolumeCells& cells)
    : Cells(cells)
  {
    this->FindVertices();
    this->MakeCells();
    this->MakeColumns();
  }

  std::vector<std::array<double, 2>> Vertices;
  std::vector<std::array<std::int64_t, 3>> Triangles; // by column
  std::vector<double> Tops;
  std::vector<std::vector<double>> Bases; // by layer and column
  std::vector<std::vector<int>> Domain; // the same

private:
  void FindVertices()
  {
    std::vector<std::size_t> order(this->Cells.Points.size());
    for (std::size_t n = 0; n < order.size(); ++n)
    {
      order[n] = n;
    }
    const auto place = [this](std::size_t n) {
      return std::array<double, 2>{ this->Cells.Points[n][0], this->Cells.Points[n][1] };
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    this->VertexOf.resize(order.size());
    for (const std::size_t n : order)
    {
      if (this->Vertices.empty() || this->Vertices.back() != place(n))
      {
        this->Vertices.push_back(place(n));
      }
      this->VertexOf[n] = std::int64_t(this->Vertices.size()) - 1;
    }
  }

  void MakeCells()
  {
    for (std::size_t cell = 0; cell < this->Cells.Size(); ++cell)
    {
      this->Levels.push_back(this->MakeCell(cell));
    }
    std::sort(this->Levels.begin(), this->Levels.end());
  }

  LevelCell MakeCell(std::size_t cell) const
  {
    std::vector<std::pair<std::int64_t, double>> corners; // by vertex and height
    for (std::int64_t n = FirstCorner(this->Cells, cell); n < this->Cells.Ends[cell]; ++n)
    {
      const auto point = std::size_t(this->Cells.Corners[std::size_t(n)]);
      corners.emplace_back(this->VertexOf[point], this->Cells.Points[point][2]);
    }
    std::sort(corners.begin(), corners.end());
    LevelCell level = { this->Cells.Triangles[cell], this->Cells.Layers[cell], {}, 0.0, 0.0 };
    std::size_t count = 0;
    for (std::size_t n = 0; n < corners.size(); ++count)
    {
      std::size_t last = n;
      while (last + 1 < corners.size() && corners[last + 1].first == corners[n].first)
      {
        ++last;
      }
      if (count == 3 || last > n + 1)
      {
        count = 4;
        break;
      }
      level.Vertices[count] = corners[n].first;
      level.Base += corners[n].second / 3.0;
      level.Top += corners[last].second / 3.0;
      n = last + 1;
    }
    if (count != 3)
    {
      throw InputError("cell " + std::to_string(cell) +
        ", whose sides are not upright, expected layers as Horizon Layers "
        "makes them");
    }
    return level;
  }

  void MakeColumns()
  {
    const std::size_t layers = this->Cells.Names.size();
    this->Bases.resize(layers);
    this->Domain.resize(layers);
    for (std::size_t first = 0; first < this->Levels.size();)
    {
      std::size_t end = first;
      for (; end < this->Levels.size() && this->Levels[end].Triangle == this->Levels[first].Triangle; ++end)
      {
        const bool isTwice = end > first && this->Levels[end].Layer == this->Levels[end - 1].Layer;
        if (this->Levels[end].Vertices != this->Levels[first].Vertices || isTwice)
        {
          throw InputError("cells of triangle " + std::to_string(this->Levels[first].Triangle) +
            " that are not over each other, expected layers as Horizon Layers makes them");
        }
      }
      this->AddColumn(first, end);
      first = end;
    }
  }

  /// Where there is no cell, a level that closes up to the next one that there is.
  void AddColumn(std::size_t first, std::size_t end)
  {
    this->Triangles.push_back(this->Levels[first].Vertices);
    this->Tops.push_back(this->Levels[first].Top);
    double above = this->Levels[first].Top;
    std::size_t next = first;
    for (std::size_t layer = 0; layer < this->Bases.size(); ++layer)
    {
      int domain = 0;
      if (next < end && std::size_t(this->Levels[next].Layer) == layer)
      {
        domain = 1;
        above = this->Levels[next++].Base;
      }
      else if (next > first && next < end && this->Levels[next].Top == above)
      {
        domain = -1;
      }
      else if (next < end && std::size_t(this->Levels[next].Layer) == layer + 1)
      {
        above = this->Levels[next].Top;
      }
      this->Bases[layer].push_back(above);
      this->Domain[layer].push_back(domain);
    }
  }

  const VolumeCells& Cells;
  std::vector<std::int64_t> VertexOf; // by point
  std::vector<LevelCell> Levels;
};

/// An array of the block of grid data, ten values on a line.
template <typename Value>
void PrintArray(const std::vector<Value>& values, LinePrinter& out)
{
  constexpr std::size_t onLine = 10;
  out.Add("    INTERNAL FACTOR 1\n");
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    out.Add(n % onLine == 0 ? "      " : " ").Add(values[n]);
    out.Add(n % onLine + 1 == onLine || n + 1 == values.size() ? "\n" : "");
  }
}

template <typename Value>
void PrintLayered(std::string_view name, const std::vector<std::vector<Value>>& values, LinePrinter& out)
{
  out.Line("", "  ", name, " LAYERED");
  for (const std::vector<Value>& ofLayer : values)
  {
    PrintArray(ofLayer, out);
  }
}

/// Clockwise, as MODFLOW wants them.
void PrintColumn(const LevelGrid& grid, std::size_t column, LinePrinter& out)
{
  std::array<std::int64_t, 3> corners = grid.Triangles[column];
  const auto at = [&](std::size_t n) { return grid.Vertices[std::size_t(corners[n])]; };
  const double turn = (at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) - (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]);
  if (turn > 0.0)
  {
    std::swap(corners[1], corners[2]);
  }
  const auto middle = [&](std::size_t axis) { return at(0)[axis] / 3.0 + at(1)[axis] / 3.0 + at(2)[axis] / 3.0; };
  out.Line(" ", " ", column + 1, middle(0), middle(1), 3, corners[0] + 1, corners[1] + 1, corners[2] + 1);
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
    for (const double coordinate : cells.Points[point])
    {
      if (!std::isfinite(coordinate))
      {
        throw InputError("coordinate " + std::to_string(coordinate) + " of point " + std::to_string(point) +
          ", expected a finite number");
      }
    }
  }
  for (std::size_t cell = 0; cell < cells.Size(); ++cell)
  {
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
  constexpr int volume = 3;
  const CellGroups groups(cells);
  std::vector<std::size_t> layers;
  for (std::size_t layer = 0; layer < cells.Names.size(); ++layer)
  {
    if (groups.HasLayer(layer))
    {
      layers.push_back(layer);
    }
  }
  std::array<double, 6> box = { HUGE_VAL, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (const std::array<double, 3>& point : cells.Points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box[axis] = std::min(box[axis], point[axis]);
      box[3 + axis] = std::max(box[3 + axis], point[axis]);
    }
  }
  LinePrinter out(stream);
  out.Add("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n").Add(layers.size()).Add("\n");
  for (const std::size_t layer : layers)
  {
    out.Line(" ", volume, layer + 1, '"' + WithoutQuotes(cells.Names[layer]) + '"');
  }
  out.Add("$EndPhysicalNames\n$Entities\n");
  out.Line(" ", 0, 0, 0, layers.size());
  for (const std::size_t layer : layers) // the box is that of all
  {
    out.Line(" ", layer + 1, box[0], box[1], box[2], box[3], box[4], box[5], 1, layer + 1, 0);
  }
  out.Add("$EndEntities\n$Nodes\n");
  out.Line(" ", 1, cells.Points.size(), 1, cells.Points.size());
  out.Line(" ", volume, layers.front() + 1, 0, cells.Points.size());
  for (std::size_t point = 1; point <= cells.Points.size(); ++point)
  {
    out.Line("", point);
  }
  for (const std::array<double, 3>& point : cells.Points)
  {
    out.Line(" ", point[0], point[1], point[2]);
  }
  out.Add("$EndNodes\n$Elements\n");
  out.Line(" ", groups.Size(), cells.Size(), 1, cells.Size());
  std::int64_t printed = 0;
  for (const std::size_t layer : layers)
  {
    for (std::size_t kind = 0; kind < Kinds; ++kind)
    {
      const std::vector<std::size_t>& group = groups.Of(layer, kind);
      if (!group.empty())
      {
        out.Line(" ", volume, layer + 1, types[kind], group.size());
        PrintCells(cells, group, " ", NodesOf, printed, out, monitor);
      }
    }
  }
  out.Add("$EndElements\n");
  out.Flush();
}

//----------------------------------------------------------------------------------------------------------------------
void PrintAbaqus(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor)
{
  constexpr std::array<std::string_view, Kinds> types = { "C3D6", "C3D6", "C3D4" };
  const CellGroups groups(cells);
  const std::vector<std::string> names = MakeSetNames(cells.Names);
  LinePrinter out(stream);
  out.Add("*HEADING\nLayers between seismic horizons\n*NODE\n");
  for (std::size_t point = 0; point < cells.Points.size(); ++point)
  {
    const std::array<double, 3>& place = cells.Points[point];
    out.Line(", ", point + 1, place[0], place[1], place[2]);
  }
  std::int64_t printed = 0;
  for (std::size_t layer = 0; layer < names.size(); ++layer)
  {
    for (std::size_t kind = 0; kind < Kinds; ++kind)
    {
      const std::vector<std::size_t>& group = groups.Of(layer, kind);
      if (!group.empty())
      {
        out.Line("", "*ELEMENT, TYPE=", types[kind], ", ELSET=", names[layer]);
        PrintCells(cells, group, ", ", NodesWithoutPyramids, printed, out, monitor);
      }
    }
  }
  out.Flush();
}

//----------------------------------------------------------------------------------------------------------------------
void PrintDISV(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor)
{
  const LevelGrid grid(cells);
  monitor.Progress(0.3);
  LinePrinter out(stream);
  for (std::size_t layer = 0; layer < cells.Names.size(); ++layer)
  {
    out.Line("", "# layer ", layer + 1, ": ", WithoutQuotes(cells.Names[layer]));
  }
  out.Add("BEGIN OPTIONS\n");
  if (!cells.LengthUnit.empty())
  {
    out.Line("", "  LENGTH_UNITS ", cells.LengthUnit);
  }
  out.Add("END OPTIONS\n\nBEGIN DIMENSIONS\n");
  out.Line("", "  NLAY ", cells.Names.size());
  out.Line("", "  NCPL ", grid.Triangles.size());
  out.Line("", "  NVERT ", grid.Vertices.size());
  out.Add("END DIMENSIONS\n\nBEGIN GRIDDATA\n  TOP\n");
  PrintArray(grid.Tops, out);
  PrintLayered("BOTM", grid.Bases, out);
  PrintLayered("IDOMAIN", grid.Domain, out);
  monitor.Progress(0.7);
  out.Add("END GRIDDATA\n\nBEGIN VERTICES\n");
  for (std::size_t vertex = 0; vertex < grid.Vertices.size(); ++vertex)
  {
    out.Line(" ", " ", vertex + 1, grid.Vertices[vertex][0], grid.Vertices[vertex][1]);
  }
  out.Add("END VERTICES\n\nBEGIN CELL2D\n");
  for (std::size_t column = 0; column < grid.Triangles.size(); ++column)
  {
    PrintColumn(grid, column, out);
  }
  out.Add("END CELL2D\n");
  out.Flush();
}
}
