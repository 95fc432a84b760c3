// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// MODFLOW has columns of horizontal cells.

#include "LayersPrinter.h"

#include "Common/Base/Errors.h"
#include "Common/Text/TextPrinter.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
namespace
{
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
  LevelGrid(const VolumeCells& cells, const Monitor& monitor)
    : Cells(cells)
  {
    this->FindVertices();
    this->NumberLayers();
    this->MakeCells(monitor.Step(0.3, 0.6));
    this->MakeColumns(monitor.Step(0.7, 1.0));
  }

  std::vector<std::string> Names; // of layers of the model
  std::vector<std::array<double, 2>> Vertices;
  std::vector<std::array<std::int64_t, 3>> Triangles; // by column
  std::vector<double> Tops;
  std::vector<std::vector<double>> Bases; // Indexed by layer and column.
  std::vector<std::vector<int>> Domain;

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

  /// Sublayers are layers of the model.
  void NumberLayers()
  {
    std::vector<int> counts(this->Cells.Names.size(), 1);
    for (std::size_t cell = 0; cell < this->Cells.Size(); ++cell)
    {
      int& count = counts[std::size_t(this->Cells.Layers[cell])];
      count = std::max(count, this->Cells.Sublayers[cell] + 1);
    }
    for (std::size_t layer = 0; layer < counts.size(); ++layer)
    {
      this->FirstLayers.push_back(int(this->Names.size()));
      for (int n = 0; n < counts[layer]; ++n)
      {
        const std::string number = counts[layer] > 1 ? ", sublayer " + std::to_string(n + 1) : "";
        this->Names.push_back(WithoutQuotes(this->Cells.Names[layer]) + number);
      }
    }
  }

  void MakeCells(const Monitor& monitor)
  {
    this->Levels.reserve(this->Cells.Size());
    ForEach(this->Cells.Size(), monitor, [this](std::size_t cell) { this->Levels.push_back(this->MakeCell(cell)); });
    std::sort(this->Levels.begin(), this->Levels.end());
  }

  LevelCell MakeCell(std::size_t cell) const
  {
    std::vector<std::pair<std::int64_t, double>> corners; // vertex and height
    for (std::int64_t n = this->Cells.FirstCorner(cell); n < this->Cells.Ends[cell]; ++n)
    {
      const auto point = std::size_t(this->Cells.Corners[std::size_t(n)]);
      corners.emplace_back(this->VertexOf[point], this->Cells.Points[point][2]);
    }
    std::sort(corners.begin(), corners.end());
    const int layer = this->FirstLayers[std::size_t(this->Cells.Layers[cell])] + this->Cells.Sublayers[cell];
    LevelCell level = { this->Cells.Triangles[cell], layer, {}, 0.0, 0.0 };
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
        ", whose sides are not vertical, expected layers as Horizon Layers "
        "makes them");
    }
    return level;
  }

  void MakeColumns(const Monitor& monitor)
  {
    this->Bases.resize(this->Names.size());
    this->Domain.resize(this->Names.size());
    for (std::size_t first = 0; first < this->Levels.size();)
    {
      std::size_t end = first;
      for (; end < this->Levels.size() && this->Levels[end].Triangle == this->Levels[first].Triangle; ++end)
      {
        const bool isTwice = end > first && this->Levels[end].Layer == this->Levels[end - 1].Layer;
        if (this->Levels[end].Vertices != this->Levels[first].Vertices || isTwice)
        {
          throw InputError("cells of triangle " + std::to_string(this->Levels[first].Triangle) +
            " that are not above each other, expected layers as Horizon Layers makes them without Tetrahedra");
        }
      }
      if (this->Tops.size() % 1024 == 0)
      {
        monitor.Progress(double(first) / double(this->Levels.size()));
      }
      this->AddColumn(first, end);
      first = end;
    }
  }

  /// Missing cells have no height, at the level of the next cell.
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
  std::vector<int> FirstLayers; // of the model, by layer
  std::vector<std::int64_t> VertexOf;
  std::vector<LevelCell> Levels;
};

template <typename Value>
void PrintArray(const std::vector<Value>& values, const Monitor& monitor, TextPrinter& out)
{
  constexpr std::size_t onLine = 10;
  out.Print("    INTERNAL FACTOR 1\n");
  ForEach(values.size(), monitor,
    [&](std::size_t n)
    {
      out.Print(n % onLine == 0 ? "      " : " ", values[n]);
      out.Print(n % onLine + 1 == onLine || n + 1 == values.size() ? "\n" : "");
    });
}

template <typename Value>
void PrintLayered(
  std::string_view name, const std::vector<std::vector<Value>>& values, const Monitor& monitor, TextPrinter& out)
{
  out.PrintLine("", "  ", name, " LAYERED");
  const double part = 1.0 / double(values.size());
  for (std::size_t layer = 0; layer < values.size(); ++layer)
  {
    PrintArray(values[layer], monitor.Step(part * double(layer), part * double(layer + 1)), out);
  }
}

/// MODFLOW wants clockwise order.
void PrintColumn(const LevelGrid& grid, std::size_t column, TextPrinter& out)
{
  std::array<std::int64_t, 3> corners = grid.Triangles[column];
  const auto at = [&](std::size_t n) { return grid.Vertices[std::size_t(corners[n])]; };
  const double turn = (at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) - (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]);
  if (turn > 0.0)
  {
    std::swap(corners[1], corners[2]);
  }
  const auto middle = [&](std::size_t axis) { return at(0)[axis] / 3.0 + at(1)[axis] / 3.0 + at(2)[axis] / 3.0; };
  out.PrintLine(" ", " ", column + 1, middle(0), middle(1), 3, corners[0] + 1, corners[1] + 1, corners[2] + 1);
}
}

//----------------------------------------------------------------------------------------------------------------------
void PrintDISV(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor)
{
  const LevelGrid grid(cells, monitor.Step(0.0, 0.3));
  TextPrinter out(stream);
  for (std::size_t layer = 0; layer < grid.Names.size(); ++layer)
  {
    out.PrintLine("", "# layer ", layer + 1, ": ", grid.Names[layer]);
  }
  out.Print("BEGIN OPTIONS\n");
  if (!cells.LengthUnit.empty())
  {
    out.PrintLine("", "  LENGTH_UNITS ", cells.LengthUnit);
  }
  out.Print("END OPTIONS\n\nBEGIN DIMENSIONS\n");
  out.PrintLine("", "  NLAY ", grid.Names.size());
  out.PrintLine("", "  NCPL ", grid.Triangles.size());
  out.PrintLine("", "  NVERT ", grid.Vertices.size());
  out.Print("END DIMENSIONS\n\nBEGIN GRIDDATA\n  TOP\n");
  PrintArray(grid.Tops, monitor.Step(0.3, 0.4), out);
  PrintLayered("BOTM", grid.Bases, monitor.Step(0.4, 0.6), out);
  PrintLayered("IDOMAIN", grid.Domain, monitor.Step(0.6, 0.7), out);
  out.Print("END GRIDDATA\n\nBEGIN VERTICES\n");
  ForEach(grid.Vertices.size(), monitor.Step(0.7, 0.8),
    [&](std::size_t vertex)
    { out.PrintLine(" ", " ", vertex + 1, grid.Vertices[vertex][0], grid.Vertices[vertex][1]); });
  out.Print("END VERTICES\n\nBEGIN CELL2D\n");
  ForEach(grid.Triangles.size(), monitor.Step(0.8, 1.0), [&](std::size_t column) { PrintColumn(grid, column, out); });
  out.Print("END CELL2D\n");
  out.Flush();
  monitor.Progress(1.0);
}
}
