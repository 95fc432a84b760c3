// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightFit.h"

#include "Common/Base/CountingSort.h"
#include "Common/Base/Parallel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr int StepsOfFit = 2;
constexpr double PartOfStep = 1.0 / 3.0;

// Errors below this fraction of the reach weigh alike, so that no weight is 0.
constexpr double LeastError = 1e-2;

class MovableCorners
{
public:
  static constexpr int None = -1;

  MovableCorners(const HeightMesh& mesh, const std::vector<VertexId>& vertices)
    : Corners(std::size_t(mesh.Triangles().Size()))
  {
    std::vector<int> numbers(std::size_t(mesh.EndOfVertices()), None);
    for (std::size_t n = 0; n < vertices.size(); ++n)
    {
      numbers[vertices[n]] = int(n);
    }
    mesh.ForEachTriangle(Monitor(),
      [&](TriangleId triangle)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          this->Corners[triangle][corner] = numbers[mesh.Triangles().Corner(triangle, corner)];
        }
      });
  }

  const std::array<int, 3>& operator[](TriangleId triangle) const { return this->Corners[triangle]; }

private:
  std::vector<std::array<int, 3>> Corners;
};

// ---- Equations -----------------------------------------------------------------------------------------------------
/// A triangle adds terms to the diagonal, to its edges and to the right-hand sides.
struct Element
{
  std::array<double, 3> Corners = {};
  std::array<double, 3> Edges = {};
  std::array<double, 3> Right = {};
};

class MeshEquations
{
public:
  MeshEquations(const PlaneMesh& mesh, const MovableCorners& corners, std::size_t unknowns)
    : Mesh(mesh)
    , Corners(corners)
    , Rows(std::int64_t(unknowns), [this](auto&& add) { this->ForEachEntry(add); })
    , Values(this->Rows.Size())
    , Diagonal(unknowns)
    , Right(unknowns)
    , Sums((unknowns + RowsOfBlock - 1) / RowsOfBlock)
  {
  }

  /// Errors at the vertices' own columns count for no triangle and are added here.
  template <typename Weight>
  void Set(const std::vector<Element>& elements, const std::vector<double>& errors, const Weight& weight)
  {
    this->ForEachRow(
      [&](std::int64_t row)
      {
        this->Diagonal[row] = weight(errors[row]);
        this->Right[row] = -this->Diagonal[row] * errors[row];
        return 0.0;
      });
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const int unknown = this->Corners[triangle][corner];
        if (unknown != MovableCorners::None)
        {
          this->Diagonal[unknown] += elements[triangle].Corners[corner];
          this->Right[unknown] += elements[triangle].Right[corner];
        }
      }
    }
    this->ForEachRow(
      [&](std::int64_t row)
      {
        for (const Entry* entry = this->Rows.begin(row); entry != this->Rows.end(row); ++entry)
        {
          this->Values[this->Rows.IndexOf(entry)] =
            elements[entry->Triangle].Edges[entry->Edge] + elements[entry->OtherTriangle].Edges[entry->OtherEdge];
        }
        return 0.0;
      });
  }

  /// Conjugate gradients (Hestenes and Stiefel 1952) are preconditioned by the diagonal.
  std::vector<double> Solve()
  {
    std::vector<double> solution(this->Right.size(), 0.0);
    std::vector<double> direction(this->Right.size(), 0.0);
    std::vector<double> image(this->Right.size());
    const double enough =
      Precision * Precision * this->ForEachRow([&](std::int64_t row) { return this->Squared(row); });
    double product = 1.0; // arbitrary, as there is no direction yet
    double rest = enough;
    for (int iteration = 0; iteration < MostIterations && rest >= enough && enough > 0.0; ++iteration)
    {
      const double next =
        this->ForEachRow([&](std::int64_t row) { return this->Right[row] * this->Right[row] / this->Diagonal[row]; });
      const double ratio = next / product;
      product = next;
      this->ForEachRow(
        [&](std::int64_t row)
        {
          direction[row] = this->Right[row] / this->Diagonal[row] + ratio * direction[row];
          return 0.0;
        });
      const double bend = this->ForEachRow(
        [&](std::int64_t row)
        {
          image[row] = this->ImageAt(row, direction);
          return image[row] * direction[row];
        });
      rest = this->ForEachRow(
        [&](std::int64_t row)
        {
          solution[row] += product / bend * direction[row];
          this->Right[row] -= product / bend * image[row];
          return this->Squared(row);
        });
    }
    return solution;
  }

private:
  // Solutions need not be exact, as each step is damped.
  static constexpr double Precision = 1e-3;
  static constexpr int MostIterations = 100;

  // Sums of blocks are added in order, whatever the number of threads.
  static constexpr std::size_t RowsOfBlock = 512;
  static constexpr std::int64_t BlockGrain = 4;

  /// Two triangles share the edge of an entry.
  struct Entry
  {
    int Other;
    TriangleId Triangle;
    TriangleId OtherTriangle;
    std::int8_t Edge;
    std::int8_t OtherEdge;
  };

  template <typename Add>
  void ForEachEntry(Add&& add) const
  {
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const TriangleId beyond = this->Mesh.Neighbour(triangle, edge);
        const int from = this->Corners[triangle][edge];
        const int to = this->Corners[triangle][NextCorner(edge)];
        if (beyond > triangle && from != MovableCorners::None && to != MovableCorners::None)
        {
          const int back = this->Mesh.EdgeTo(beyond, triangle);
          add(from, { to, triangle, beyond, std::int8_t(edge), std::int8_t(back) });
          add(to, { from, triangle, beyond, std::int8_t(edge), std::int8_t(back) });
        }
      }
    }
  }

  template <typename Call>
  double ForEachRow(Call&& call)
  {
    ParallelFor(std::int64_t(this->Sums.size()), BlockGrain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t block = first; block < last; ++block)
        {
          const std::size_t end = std::min(this->Right.size(), std::size_t(block + 1) * RowsOfBlock);
          this->Sums[block] = 0.0;
          for (std::size_t row = std::size_t(block) * RowsOfBlock; row < end; ++row)
          {
            this->Sums[block] += call(std::int64_t(row));
          }
        }
      });
    return std::accumulate(this->Sums.begin(), this->Sums.end(), 0.0);
  }

  double Squared(std::int64_t row) const { return this->Right[row] * this->Right[row]; }

  double ImageAt(std::int64_t row, const std::vector<double>& values) const
  {
    double sum = this->Diagonal[row] * values[row];
    for (const Entry* entry = this->Rows.begin(row); entry != this->Rows.end(row); ++entry)
    {
      sum += this->Values[this->Rows.IndexOf(entry)] * values[entry->Other];
    }
    return sum;
  }

  const PlaneMesh& Mesh;
  const MovableCorners& Corners;
  const ItemLists<Entry> Rows;
  std::vector<double> Values; // by entry
  std::vector<double> Diagonal;
  std::vector<double> Right; // residual during the solution
  std::vector<double> Sums;
};

// ---- Fit -----------------------------------------------------------------------------------------------------------
class ErrorWeight
{
public:
  /// Errors are divided by the unit.
  explicit ErrorWeight(double unit)
    : PerUnit(1.0 / unit)
  {
  }

  double operator()(double error) const
  {
    const double size = std::max(std::abs(error) * this->PerUnit, LeastError);
    return size * size;
  }

  template <typename Real>
  FourColumns<Real> operator()(const FourColumns<Real>& errors) const
  {
    return (errors.abs() * Real(this->PerUnit)).max(Real(LeastError)).square();
  }

private:
  double PerUnit;
};

template <typename Real>
class ElementSums
{
public:
  using Four = FourColumns<Real>;

  void Add(const std::array<Four, 3>& fractions, const Four& errors, const Four& weights)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Four weighted = weights * fractions[corner];
      this->Corners[corner] += weighted * fractions[corner];
      this->Edges[corner] += weighted * fractions[corner == 2 ? 0 : corner + 1];
      this->Right[corner] += weighted * errors;
    }
  }

  Element Sum() const
  {
    Element element;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      element.Corners[corner] = double(this->Corners[corner].sum());
      element.Edges[corner] = double(this->Edges[corner].sum());
      element.Right[corner] = -double(this->Right[corner].sum());
    }
    return element;
  }

private:
  std::array<Four, 3> Corners = { Four::Zero(), Four::Zero(), Four::Zero() };
  std::array<Four, 3> Edges = Corners;
  std::array<Four, 3> Right = Corners;
};

constexpr std::int64_t ColumnsPerTask = 1024;

class HeightFitter
{
public:
  HeightFitter(const HeightMesh& mesh, double reach, bool withEdges, std::size_t horizon, InnerHeights heights)
    : Surface(mesh)
    , Horizon(horizon)
    , Mesh(mesh.Triangles())
    , Reach(reach)
    , WithEdges(withEdges)
    , Inner(std::move(heights))
    , Corners(mesh, this->Inner.Vertices)
    , Equations(this->Mesh, this->Corners, this->Inner.Vertices.size())
    , Elements(std::size_t(this->Mesh.Size()))
    , Columns(this->Inner.Vertices.size())
  {
    ParallelFor(std::int64_t(this->Columns.size()), ColumnsPerTask,
      [this](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          this->Columns[n] = this->Surface.ColumnHeight(this->Horizon, this->Inner.Vertices[n]);
        }
      });
  }

  InnerHeights Run(const Monitor& monitor)
  {
    for (int step = 0; step < StepsOfFit && !this->Inner.Vertices.empty(); ++step)
    {
      monitor.Progress(double(step) / StepsOfFit);
      this->Improve();
    }
    return std::move(this->Inner);
  }

private:
  /// Moves a fraction of the solution.
  void Improve()
  {
    this->Surface.ForEachTriangle(
      Monitor(), [&](TriangleId triangle) { this->Elements[triangle] = this->MakeElement(triangle); });
    const ErrorWeight weight(this->Reach);
    std::vector<double> errors;
    errors.reserve(this->Columns.size());
    std::transform(this->Inner.Heights.begin(), this->Inner.Heights.end(), this->Columns.begin(),
      std::back_inserter(errors), std::minus<>());
    this->Equations.Set(this->Elements, errors, weight);
    const std::vector<double> moves = this->Equations.Solve();
    for (std::size_t n = 0; n < moves.size(); ++n)
    {
      double& height = this->Inner.Heights[n];
      height =
        std::clamp(height + PartOfStep * moves[n], this->Columns[n] - this->Reach, this->Columns[n] + this->Reach);
    }
  }

  Element MakeElement(TriangleId triangle) const
  {
    RaisedTriangle raised = this->Surface.RaisedCorners(this->Horizon, triangle);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const int unknown = this->Corners[triangle][corner];
      raised[corner].Height = unknown == MovableCorners::None ? raised[corner].Height : this->Inner.Heights[unknown];
    }
    const ErrorWeight weight(this->Reach);
    const HeightRaster& raster = this->Surface.RasterOf(this->Horizon, triangle);
    if (raster.IsFloatEnough(this->Reach))
    {
      Element element = this->SumColumns<float>(triangle, raised, weight);
      this->AddEdges<float>(triangle, raised, weight, element);
      return element;
    }
    Element element = this->SumColumns<double>(triangle, raised, weight);
    this->AddEdges<double>(triangle, raised, weight, element);
    return element;
  }

  template <typename Real>
  Element SumColumns(TriangleId triangle, const RaisedTriangle& raised, const ErrorWeight& weight) const
  {
    using Four = FourColumns<Real>;
    const Real perArea = Real(1.0 / double(SignedArea(raised[0].Column, raised[1].Column, raised[2].Column)));
    ElementSums<Real> sums;
    this->Surface.RasterOf(this->Horizon, triangle)
      .ForEachFour<Real>(raised, this->Surface.OwnedColumns(triangle),
        [&](const Four& errors, const Four& b, const Four& c, const Four& isIn)
        {
          const Four fractionOfB = b * perArea;
          const Four fractionOfC = c * perArea;
          sums.Add(
            { Four(Real(1) - fractionOfB - fractionOfC), fractionOfB, fractionOfC }, errors, weight(errors) * isIn);
        });
    return sums.Sum();
  }

  template <typename Real>
  void AddEdges(TriangleId triangle, const RaisedTriangle& raised, const ErrorWeight& weight, Element& element) const
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      if (this->WithEdges && this->Mesh.Neighbour(triangle, edge) > triangle)
      {
        const int next = NextCorner(edge);
        this->Surface.RasterOf(this->Horizon, triangle)
          .ForEachCrossing<Real>(raised[edge], raised[next],
            [&](const Crossing& crossing)
            {
              const double fraction = crossing.FractionOfEdge;
              const double weighs = weight(crossing.Error);
              element.Corners[edge] += weighs * (1.0 - fraction) * (1.0 - fraction);
              element.Corners[next] += weighs * fraction * fraction;
              element.Edges[edge] += weighs * fraction * (1.0 - fraction);
              element.Right[edge] -= weighs * (1.0 - fraction) * crossing.Error;
              element.Right[next] -= weighs * fraction * crossing.Error;
              return true;
            });
      }
    }
  }

  const HeightMesh& Surface;
  const std::size_t Horizon;
  const PlaneMesh& Mesh;
  const double Reach;
  const bool WithEdges;
  InnerHeights Inner;
  const MovableCorners Corners;
  MeshEquations Equations;
  std::vector<Element> Elements;
  std::vector<double> Columns; // column heights of the vertices
};

// ---- Moves ---------------------------------------------------------------------------------------------------------
// A vertex moves at least this fraction, or stays.
constexpr double LeastFraction = 0.25;

class MoveLimit
{
public:
  MoveLimit(HeightMesh& mesh, double error, const std::vector<InnerHeights>& heights)
    : Mesh(mesh)
    , Error(error)
    , Before(mesh.HeightsOf(heights.front().Vertices))
    , After(heights)
    , Heights(heights)
    , Corners(mesh, heights.front().Vertices)
    , Fractions(heights.front().Vertices.size(), 1.0)
    , IsMoved(heights.front().Vertices.size(), 1)
    , IsFar(std::size_t(mesh.Triangles().Size()))
  {
  }

  /// A vertex that moves less can push its triangles off, so they are measured again.
  void Run()
  {
    do
    {
      this->Mesh.SetAllHeights(this->Heights);
      this->Mesh.ForEachTriangle(
        Monitor(), [this](TriangleId triangle) { this->IsFar[triangle] = this->FindFar(triangle); });
    } while (this->MoveBack());
  }

private:
  using FarEdges = std::uint8_t; // a bit per edge, and one for the columns

  static constexpr int ColumnsBit = 3;

  /// Only triangles with a corner that has just moved are measured.
  FarEdges FindFar(TriangleId triangle) const
  {
    const auto isMoved = [&](int corner)
    {
      const int vertex = this->Corners[triangle][corner];
      return vertex != MovableCorners::None && this->IsMoved[vertex] != 0;
    };
    FarEdges far = 0;
    const std::size_t horizons = isMoved(0) || isMoved(1) || isMoved(2) ? this->Mesh.NumberOfHorizons() : 0;
    for (std::size_t horizon = 0; horizon < horizons; ++horizon)
    {
      const HeightRaster& raster = this->Mesh.RasterOf(horizon, triangle);
      const RaisedTriangle raised = this->Mesh.RaisedCorners(horizon, triangle);
      far |= raster.IsWithin(raised, this->Error) ? 0 : 1 << ColumnsBit;
      for (int edge = 0; edge < 3; ++edge)
      {
        const int next = NextCorner(edge);
        if (this->Mesh.Triangles().Neighbour(triangle, edge) > triangle && (isMoved(edge) || isMoved(next)) &&
          !raster.IsEdgeWithin(raised[edge], raised[next], this->Error))
        {
          far |= 1 << edge;
        }
      }
    }
    return far;
  }

  /// Returns false if no corner and no end can go back.
  bool MoveBack()
  {
    std::fill(this->IsMoved.begin(), this->IsMoved.end(), 0);
    bool isAnyMoved = false;
    for (TriangleId triangle = 0; triangle < this->Mesh.Triangles().Size(); ++triangle)
    {
      const int far = this->IsFar[triangle];
      for (int corner = 0; corner < 3 && far != 0; ++corner)
      {
        const bool isEnd = ((far >> corner | far >> PreviousCorner(corner) | far >> ColumnsBit) & 1) != 0;
        const bool isMoved = isEnd && this->MoveBack(this->Corners[triangle][corner]);
        isAnyMoved = isAnyMoved || isMoved;
      }
    }
    return isAnyMoved;
  }

  bool MoveBack(int vertex)
  {
    if (vertex == MovableCorners::None || !this->HasMoved(vertex))
    {
      return false;
    }
    double& fraction = this->Fractions[vertex];
    fraction *= 0.5;
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      const double before = this->Before[horizon].Heights[vertex];
      const double after = this->After[horizon].Heights[vertex];
      this->Heights[horizon].Heights[vertex] = fraction < LeastFraction ? before : before + fraction * (after - before);
    }
    this->IsMoved[vertex] = 1;
    return true;
  }

  bool HasMoved(int vertex) const
  {
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      if (this->Heights[horizon].Heights[vertex] != this->Before[horizon].Heights[vertex])
      {
        return true;
      }
    }
    return false;
  }

  HeightMesh& Mesh;
  const double Error;
  const std::vector<InnerHeights> Before; // by horizon, of the same vertices as Heights
  const std::vector<InnerHeights>& After;
  std::vector<InnerHeights> Heights;
  const MovableCorners Corners;
  std::vector<double> Fractions; // by vertex: the fraction of its move
  std::vector<unsigned char> IsMoved; // in this pass
  std::vector<FarEdges> IsFar;
};
std::vector<InnerHeights> FindUnruled(const std::vector<InnerHeights>& fitted, const std::vector<InnerHeights>& ruled)
{
  std::vector<InnerHeights> free(fitted.size());
  for (std::size_t horizon = 0; horizon < fitted.size(); ++horizon)
  {
    for (std::size_t n = 0; n < fitted[horizon].Vertices.size(); ++n)
    {
      if (ruled[horizon].Heights[n] == fitted[horizon].Heights[n])
      {
        free[horizon].Vertices.push_back(fitted[horizon].Vertices[n]);
        free[horizon].Heights.push_back(fitted[horizon].Heights[n]);
      }
    }
  }
  return free;
}

void Write(const InnerHeights& some, InnerHeights& all)
{
  std::size_t n = 0;
  for (std::size_t m = 0; m < some.Vertices.size(); ++m)
  {
    n = std::size_t(std::find(all.Vertices.begin() + n, all.Vertices.end(), some.Vertices[m]) - all.Vertices.begin());
    all.Heights[n] = some.Heights[m];
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
// Heights around a height that the rule has moved are fitted again.
std::vector<InnerHeights> FitAllHeights(
  HeightMesh& mesh, double reach, bool withEdges, const HeightRule& rule, const Monitor& monitor)
{
  const std::vector<InnerHeights> before = mesh.HeightsOf(mesh.InnerVertices());
  std::vector<InnerHeights> heights = before;
  const auto fit = [&](std::vector<InnerHeights> free, const Monitor& step)
  {
    const auto horizons = double(free.size());
    for (std::size_t horizon = 0; horizon < free.size(); ++horizon)
    {
      const Monitor part = step.Step(double(horizon) / horizons, double(horizon + 1) / horizons);
      Write(HeightFitter(mesh, reach, withEdges, horizon, std::move(free[horizon])).Run(part), heights[horizon]);
    }
  };
  fit(before, monitor.Step(0.0, rule ? 0.5 : 1.0));
  if (rule)
  {
    const std::vector<InnerHeights> fitted = heights;
    rule(heights);
    std::vector<InnerHeights> free = FindUnruled(fitted, heights);
    const bool isAnyMoved = std::any_of(free.begin(), free.end(),
      [&](const InnerHeights& one) { return one.Vertices.size() < before.front().Vertices.size(); });
    if (isAnyMoved)
    {
      mesh.SetAllHeights(heights);
      fit(std::move(free), monitor.Step(0.5, 1.0));
      rule(heights);
      mesh.SetAllHeights(before);
    }
  }
  return heights;
}

//----------------------------------------------------------------------------------------------------------------------
void MoveHeightsWithin(HeightMesh& mesh, double error, const std::vector<InnerHeights>& heights)
{
  assert(heights.size() == mesh.NumberOfHorizons());
  MoveLimit(mesh, error, heights).Run();
}
}
