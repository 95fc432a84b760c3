// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerBody.h"

#include "Common/Base/DisjointSets.h"
#include "Filters/Algorithms/Decimation/PlaneMesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace SeismicHorizons
{
namespace
{
class BodyMaker
{
public:
  BodyMaker(const LayerPlan& plan, std::size_t layer)
    : Plan(plan)
    , Layer(layer)
    , Mesh(plan.Columns, plan.Triangles)
    , FaultSides(FindFaultSides(plan))
  {
  }

  LayerBody Run(const Monitor& monitor)
  {
    this->FindCells();
    monitor.Progress(0.2);
    this->FindClosed();
    monitor.Progress(0.4);
    this->FindSectors();
    monitor.Progress(0.6);
    this->MakePoints();
    monitor.Progress(0.8);
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      if (this->HasCell(triangle))
      {
        this->AddTopAndBase(triangle);
        this->AddWalls(triangle);
      }
    }
    return std::move(this->Result);
  }

private:
  bool IsPinched(PointId vertex) const { return this->Plan.Thickness(this->Layer, vertex) <= 0.0; }
  bool HasCell(TriangleId triangle) const { return triangle != NoTriangle && this->IsKept[std::size_t(triangle)] != 0; }
  PointId Begin(TriangleId triangle, int side) const { return this->Mesh.Corner(triangle, side); }
  PointId End(TriangleId triangle, int side) const { return this->Mesh.Corner(triangle, NextCorner(side)); }

  void FindCells()
  {
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      const bool isPinched = this->IsPinched(this->Mesh.Corner(triangle, 0)) &&
        this->IsPinched(this->Mesh.Corner(triangle, 1)) && this->IsPinched(this->Mesh.Corner(triangle, 2));
      this->IsKept.push_back(!isPinched && this->Plan.HasLayer(this->Layer, std::size_t(triangle)) ? 1 : 0);
    }
  }

  void FindClosed()
  {
    this->IsClosed.assign(this->Plan.Columns.size(), 0);
    std::vector<std::array<PointId, 2>> edges; // between pinched vertices, both ways
    std::vector<PointId> waiting;
    const auto close = [&](PointId vertex)
    {
      if (this->IsPinched(vertex) && this->IsClosed[std::size_t(vertex)] == 0)
      {
        this->IsClosed[std::size_t(vertex)] = 1;
        waiting.push_back(vertex);
      }
    };
    this->ForEachSide(
      [&](TriangleId triangle, int side)
      {
        const PointId begin = this->Begin(triangle, side);
        const PointId end = this->End(triangle, side);
        if (!this->HasCell(this->Mesh.Neighbour(triangle, side)))
        {
          close(begin);
          close(end);
        }
        if (this->IsPinched(begin) && this->IsPinched(end))
        {
          edges.push_back({ begin, end });
          edges.push_back({ end, begin });
        }
      });
    std::sort(edges.begin(), edges.end());
    while (!waiting.empty())
    {
      const PointId vertex = waiting.back();
      waiting.pop_back();
      auto edge = std::lower_bound(edges.begin(), edges.end(), std::array<PointId, 2>{ vertex, 0 });
      for (; edge != edges.end() && edge->front() == vertex; ++edge)
      {
        close(edge->back());
      }
    }
  }

  /// Whether top and base meet along a side. Where one end is closed and the other one pinched, both are closed.
  bool IsParted(TriangleId triangle, int side) const
  {
    const auto isClosed = [this](PointId vertex) { return this->IsClosed[std::size_t(vertex)] != 0; };
    return isClosed(this->Begin(triangle, side)) && isClosed(this->End(triangle, side));
  }

  void FindSectors()
  {
    this->Sectors = DisjointSets(3 * std::size_t(this->Mesh.Size()));
    this->ForEachSide(
      [this](TriangleId triangle, int side)
      {
        const TriangleId beyond = this->Mesh.Neighbour(triangle, side);
        if (this->HasCell(beyond) && !this->IsParted(triangle, side))
        {
          for (const int corner : { side, NextCorner(side) })
          {
            this->Sectors.Join(
              3 * triangle + corner, 3 * beyond + this->Mesh.CornerAt(beyond, this->Mesh.Corner(triangle, corner)));
          }
        }
      });
  }

  /// Makes two points for each sector, or one, in the order of first corners.
  void MakePoints()
  {
    this->Points.resize(3 * std::size_t(this->Mesh.Size()), { NoPoint, NoPoint });
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      for (int corner = 0; corner < 3 && this->HasCell(triangle); ++corner)
      {
        const std::int32_t own = 3 * triangle + corner;
        const std::int32_t root = this->Sectors.Find(own);
        if (root == own)
        {
          const PointId vertex = this->Mesh.Corner(triangle, corner);
          const PointId top = this->AddPoint(vertex, this->Layer);
          const bool isOne = this->IsClosed[std::size_t(vertex)] != 0;
          this->Points[std::size_t(own)] = { top, isOne ? top : this->AddPoint(vertex, this->Layer + 1) };
        }
        this->Points[std::size_t(own)] = this->Points[std::size_t(root)];
      }
    }
  }

  PointId AddPoint(PointId vertex, std::size_t horizon)
  {
    this->Result.Vertices.push_back(vertex);
    this->Result.Heights.push_back(this->Plan.Heights[horizon][std::size_t(vertex)]);
    return PointId(this->Result.Vertices.size() - 1);
  }

  PointId Top(TriangleId triangle, int corner) const { return this->Points[std::size_t(3 * triangle + corner)][0]; }
  PointId Base(TriangleId triangle, int corner) const { return this->Points[std::size_t(3 * triangle + corner)][1]; }

  void AddTopAndBase(TriangleId triangle)
  {
    this->AddFace(BodyFace::Top, this->Top(triangle, 0), this->Top(triangle, 1), this->Top(triangle, 2));
    this->AddFace(BodyFace::Base, this->Base(triangle, 0), this->Base(triangle, 2), this->Base(triangle, 1));
  }

  bool IsAtFault(TriangleId triangle, int side) const
  {
    const std::array<PointId, 2> other = { this->End(triangle, side), this->Begin(triangle, side) };
    return std::binary_search(this->FaultSides.begin(), this->FaultSides.end(), other);
  }

  void AddWalls(TriangleId triangle)
  {
    for (int side = 0; side < 3; ++side)
    {
      const int next = NextCorner(side);
      const TriangleId beyond = this->Mesh.Neighbour(triangle, side);
      if (beyond != NoTriangle && this->Plan.HasLayer(this->Layer, std::size_t(beyond)))
      {
        continue;
      }
      const BodyFace face = this->IsAtFault(triangle, side) ? BodyFace::Fault : BodyFace::Outline;
      if (!this->IsPinched(this->Begin(triangle, side)))
      {
        this->AddFace(face, this->Top(triangle, next), this->Top(triangle, side), this->Base(triangle, side));
      }
      if (!this->IsPinched(this->End(triangle, side)))
      {
        this->AddFace(face, this->Top(triangle, next), this->Base(triangle, side), this->Base(triangle, next));
      }
    }
  }

  /// Counter-clockwise where the top has the greater heights.
  void AddFace(BodyFace face, PointId a, PointId b, PointId c)
  {
    const bool isTopHigh = !this->Plan.HeightsGrowDownwards;
    this->Result.Triangles.push_back(a);
    this->Result.Triangles.push_back(isTopHigh ? b : c);
    this->Result.Triangles.push_back(isTopHigh ? c : b);
    this->Result.Faces.push_back(face);
  }

  template <typename Visitor>
  void ForEachSide(Visitor&& visit) const
  {
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      for (int side = 0; side < 3 && this->HasCell(triangle); ++side)
      {
        visit(triangle, side);
      }
    }
  }

  const LayerPlan& Plan;
  const std::size_t Layer;
  const PlaneMesh Mesh;
  const std::vector<std::array<PointId, 2>> FaultSides;
  std::vector<unsigned char> IsKept; // by triangle: 1 for those with a cell
  std::vector<unsigned char> IsClosed; // by vertex
  DisjointSets Sectors; // of corners, three per triangle
  std::vector<std::array<PointId, 2>> Points; // by corner
  LayerBody Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
LayerBody MakeLayerBody(const LayerPlan& plan, std::size_t layer, const Monitor& monitor)
{
  assert(layer < plan.NumberOfLayers());
  return BodyMaker(plan, layer).Run(monitor);
}
}
