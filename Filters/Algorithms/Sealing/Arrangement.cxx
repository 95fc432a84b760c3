// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Arrangement.h"

#include "BoxTree.h"
#include "Common/Base/Parallel.h"
#include "TriangleSplitter.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace SeismicHorizons
{
namespace
{
struct CutEdge
{
  double Part; // of the way from the end with the lesser number
  SealId Vertex;
};

/// Where two triangles meet.
struct SheetCut
{
  std::array<SealId, 2> Triangles;
  std::array<SealId, 2> Ends;
  std::vector<CutEdge> Between; // vertices of three triangles
};

/// A triangle's plane, for what is in it.
struct TriangleView
{
  Eigen::Vector3d Origin;
  Eigen::Matrix<double, 2, 3> Axes;

  Eigen::Vector2d At(const Eigen::Vector3d& place) const { return this->Axes * (place - this->Origin); }
};

class Arranger
{
public:
  explicit Arranger(const std::vector<Sheet>& sheets)
    : Sheets(sheets)
  {
    for (std::size_t n = 0; n < sheets.size(); ++n)
    {
      const auto first = SealId(this->Result.Vertices.size());
      this->Begins.push_back(SealId(this->Triangles.size()));
      this->Result.Vertices.insert(this->Result.Vertices.end(), sheets[n].Vertices.begin(), sheets[n].Vertices.end());
      for (const SheetCorners& corners : sheets[n].Triangles)
      {
        this->Triangles.push_back({ { corners[0] + first, corners[1] + first, corners[2] + first }, SealId(n) });
      }
    }
    this->Begins.push_back(SealId(this->Triangles.size()));
    this->CutsOf.resize(this->Triangles.size());
    for (std::size_t sheet = 0; sheet < sheets.size(); ++sheet)
    {
      std::vector<BoxTree::Entry> entries;
      for (SealId n = this->Begins[sheet]; n < this->Begins[sheet + 1]; ++n)
      {
        entries.push_back({ n, this->BoxOf(n) });
      }
      this->Trees.emplace_back(entries);
    }
    constexpr double rounding = 1e-14;
    for (const Eigen::Vector3d& vertex : this->Result.Vertices)
    {
      this->Accuracy = std::max(this->Accuracy, rounding * vertex.cwiseAbs().maxCoeff());
    }
  }

  void CutPair(std::size_t a, std::size_t b)
  {
    if (this->Sheets[a].Triangles.size() > this->Sheets[b].Triangles.size())
    {
      std::swap(a, b);
    }
    for (SealId n = this->Begins[b]; n < this->Begins[b + 1]; ++n)
    {
      this->Trees[a].Any(this->BoxOf(n),
        [&](SealId triangle)
        {
          this->Meet(triangle, n);
          return false;
        });
    }
  }

  Arrangement Finish()
  {
    this->FindTriples();
    this->SortEdges();
    for (std::size_t n = 0; n < this->Cuts.size(); ++n)
    {
      const std::vector<SealId> chain = this->ChainOf(SealId(n));
      for (std::size_t next = 1; next < chain.size(); ++next)
      {
        this->Result.Lines.insert(KeyOf(chain[next - 1], chain[next]));
      }
    }
    constexpr std::int64_t grain = 64;
    std::vector<std::vector<SheetCorners>> parts(this->Triangles.size());
    ParallelFor(std::int64_t(parts.size()), grain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          parts[std::size_t(n)] = this->Divide(SealId(n));
        }
      });
    for (std::size_t n = 0; n < parts.size(); ++n)
    {
      for (const SheetCorners& corners : parts[n])
      {
        this->Result.Triangles.push_back({ corners, this->Triangles[n].Sheet });
      }
    }
    return std::move(this->Result);
  }

private:
  Eigen::AlignedBox3d BoxOf(SealId triangle) const
  {
    Eigen::AlignedBox3d box;
    for (const SealId corner : this->Triangles[std::size_t(triangle)].Corners)
    {
      box.extend(this->At(corner));
    }
    return box;
  }

  const Eigen::Vector3d& At(SealId vertex) const { return this->Result.Vertices[std::size_t(vertex)]; }

  /// The volume of a tetrahedron, if its sign is certain (Shewchuk 1997, "Adaptive precision floating-point arithmetic
  /// and fast robust geometric predicates", the first of its filters).
  double Volume(SealId a, SealId b, SealId c, SealId d) const
  {
    const Eigen::Vector3d p = this->At(a) - this->At(d), q = this->At(b) - this->At(d), r = this->At(c) - this->At(d);
    const double volume = p.dot(q.cross(r));
    const Eigen::Vector3d u = p.cwiseAbs(), v = q.cwiseAbs(), w = r.cwiseAbs();
    const double sum = u.x() * (v.y() * w.z() + v.z() * w.y()) + u.y() * (v.z() * w.x() + v.x() * w.z()) +
      u.z() * (v.x() * w.y() + v.y() * w.x());
    constexpr double rounding = 1e-15;
    if (!(std::abs(volume) > rounding * sum))
    {
      throw Undecided{ this->At(d) };
    }
    return volume;
  }

  const Sheet& SheetOf(SealId triangle) const
  {
    return this->Sheets[std::size_t(this->Triangles[std::size_t(triangle)].Sheet)];
  }

  SealId AddVertex(Eigen::Vector3d place, std::initializer_list<SealId> triangles)
  {
    for (const SealId triangle : triangles)
    {
      const Sheet& sheet = this->SheetOf(triangle);
      if (sheet.LevelAxis)
      {
        place[*sheet.LevelAxis] = sheet.Level();
      }
    }
    this->Result.Vertices.push_back(place);
    return SealId(this->Result.Vertices.size() - 1);
  }

  void Meet(SealId a, SealId b)
  {
    const SheetCorners& p = this->Triangles[std::size_t(a)].Corners;
    const SheetCorners& q = this->Triangles[std::size_t(b)].Corners;
    std::array<double, 3> ofP, ofQ;
    for (std::size_t n = 0; n < 3; ++n)
    {
      ofP[n] = this->Volume(q[0], q[1], q[2], p[n]);
    }
    if ((ofP[0] > 0.0) == (ofP[1] > 0.0) && (ofP[1] > 0.0) == (ofP[2] > 0.0))
    {
      return;
    }
    for (std::size_t n = 0; n < 3; ++n)
    {
      ofQ[n] = this->Volume(p[0], p[1], p[2], q[n]);
    }
    if ((ofQ[0] > 0.0) == (ofQ[1] > 0.0) && (ofQ[1] > 0.0) == (ofQ[2] > 0.0))
    {
      return;
    }
    SheetCut cut;
    cut.Triangles = { a, b };
    std::size_t found = 0;
    this->PierceEdges(a, b, ofP, cut, found);
    this->PierceEdges(b, a, ofQ, cut, found);
    if (found == 2)
    {
      this->CutsOf[std::size_t(a)].push_back(SealId(this->Cuts.size()));
      this->CutsOf[std::size_t(b)].push_back(SealId(this->Cuts.size()));
      this->Cuts.push_back(cut);
    }
    else if (found != 0)
    {
      throw Undecided{ this->At(p[0]) };
    }
  }

  /// Adds vertices where edges of triangle `a` pierce triangle `b`.
  void PierceEdges(SealId a, SealId b, const std::array<double, 3>& heights, SheetCut& cut, std::size_t& found)
  {
    const SheetCorners& p = this->Triangles[std::size_t(a)].Corners;
    const SheetCorners& q = this->Triangles[std::size_t(b)].Corners;
    for (std::size_t n = 0; n < 3; ++n)
    {
      std::size_t from = n, to = (n + 1) % 3;
      if ((heights[from] > 0.0) == (heights[to] > 0.0))
      {
        continue;
      }
      if (p[from] > p[to])
      {
        std::swap(from, to);
      }
      const bool first = this->Volume(p[from], p[to], q[0], q[1]) > 0.0;
      if (first != (this->Volume(p[from], p[to], q[1], q[2]) > 0.0) ||
        first != (this->Volume(p[from], p[to], q[2], q[0]) > 0.0))
      {
        continue;
      }
      const auto [place, isNew] = this->Pierced.try_emplace({ KeyOf(p[from], p[to]), b }, 0);
      if (isNew)
      {
        const double part = heights[from] / (heights[from] - heights[to]);
        place->second = this->AddVertex(this->At(p[from]) + part * (this->At(p[to]) - this->At(p[from])), { a, b });
        this->OnEdge[KeyOf(p[from], p[to])].push_back({ part, place->second });
      }
      if (found < 2)
      {
        cut.Ends[found] = place->second;
      }
      ++found;
    }
  }

  TriangleView ViewOf(SealId triangle) const
  {
    const SheetCorners& corners = this->Triangles[std::size_t(triangle)].Corners;
    TriangleView view;
    view.Origin = this->At(corners[0]);
    const Eigen::Vector3d along = (this->At(corners[1]) - view.Origin).normalized();
    const Eigen::Vector3d other = this->At(corners[2]) - view.Origin;
    view.Axes.row(0) = along;
    view.Axes.row(1) = (other - other.dot(along) * along).normalized();
    return view;
  }

  void FindTriples()
  {
    for (std::size_t n = 0; n < this->Triangles.size(); ++n)
    {
      const std::vector<SealId>& cuts = this->CutsOf[n];
      if (cuts.size() < 2)
      {
        continue;
      }
      const TriangleView view = this->ViewOf(SealId(n));
      std::vector<std::array<Eigen::Vector2d, 2>> segments;
      for (const SealId cut : cuts)
      {
        const std::array<SealId, 2>& ends = this->Cuts[std::size_t(cut)].Ends;
        segments.push_back({ view.At(this->At(ends[0])), view.At(this->At(ends[1])) });
      }
      for (std::size_t one = 0; one < cuts.size(); ++one)
      {
        for (std::size_t two = 0; two < one; ++two)
        {
          this->Cross(SealId(n), cuts[one], cuts[two], segments[one], segments[two]);
        }
      }
    }
  }

  SealId OtherOf(SealId cut, SealId triangle) const
  {
    const std::array<SealId, 2>& both = this->Cuts[std::size_t(cut)].Triangles;
    return both[0] == triangle ? both[1] : both[0];
  }

  void Cross(SealId triangle, SealId one, SealId two, const std::array<Eigen::Vector2d, 2>& p,
    const std::array<Eigen::Vector2d, 2>& q)
  {
    const SealId a = this->OtherOf(one, triangle), b = this->OtherOf(two, triangle);
    if (this->Triangles[std::size_t(a)].Sheet == this->Triangles[std::size_t(b)].Sheet ||
      std::max(p[0].x(), p[1].x()) < std::min(q[0].x(), q[1].x()) ||
      std::max(q[0].x(), q[1].x()) < std::min(p[0].x(), p[1].x()) ||
      std::max(p[0].y(), p[1].y()) < std::min(q[0].y(), q[1].y()) ||
      std::max(q[0].y(), q[1].y()) < std::min(p[0].y(), p[1].y()))
    {
      return;
    }
    const auto turn = [this, triangle](const Eigen::Vector2d& u, const Eigen::Vector2d& v, const Eigen::Vector2d& w)
    {
      const Eigen::Vector2d d = v - u, e = w - u;
      const double area = d.x() * e.y() - d.y() * e.x();
      if (!(std::abs(area) > this->Accuracy * (d.norm() + e.norm())))
      {
        throw Undecided{ this->At(this->Triangles[std::size_t(triangle)].Corners[0]) };
      }
      return area;
    };
    const double fromP = turn(q[0], q[1], p[0]), toP = turn(q[0], q[1], p[1]);
    if ((fromP > 0.0) == (toP > 0.0))
    {
      return;
    }
    const double fromQ = turn(p[0], p[1], q[0]), toQ = turn(p[0], p[1], q[1]);
    if ((fromQ > 0.0) == (toQ > 0.0))
    {
      return;
    }
    std::array<SealId, 3> key = { triangle, a, b };
    std::sort(key.begin(), key.end());
    const auto [place, isNew] = this->Triples.try_emplace(key, 0);
    const auto partOf = [](double from, double to) { return from / (from - to); };
    if (isNew)
    {
      const std::array<SealId, 2>& ends = this->Cuts[std::size_t(one)].Ends;
      const Eigen::Vector3d from = this->At(ends[0]), to = this->At(ends[1]);
      place->second = this->AddVertex(from + partOf(fromP, toP) * (to - from), { triangle, a, b });
    }
    this->AddBetween(one, partOf(fromP, toP), place->second);
    this->AddBetween(two, partOf(fromQ, toQ), place->second);
  }

  void AddBetween(SealId cut, double part, SealId vertex)
  {
    std::vector<CutEdge>& between = this->Cuts[std::size_t(cut)].Between;
    if (std::none_of(between.begin(), between.end(), [&](const CutEdge& other) { return other.Vertex == vertex; }))
    {
      between.push_back({ part, vertex });
    }
  }

  void Sort(std::vector<CutEdge>& vertices) const
  {
    std::sort(vertices.begin(), vertices.end(), [](const CutEdge& a, const CutEdge& b) { return a.Part < b.Part; });
    constexpr double rounding = 1e-10;
    for (std::size_t n = 0; n < vertices.size(); ++n)
    {
      const double before = n > 0 ? vertices[n - 1].Part : 0.0;
      const double after = n + 1 < vertices.size() ? 1.0 : 1.0 - rounding;
      if (!(vertices[n].Part - before > rounding) || !(vertices[n].Part < after))
      {
        throw Undecided{ this->At(vertices[n].Vertex) };
      }
    }
  }

  void SortEdges()
  {
    for (auto& [edge, vertices] : this->OnEdge)
    {
      this->Sort(vertices);
    }
    for (SheetCut& cut : this->Cuts)
    {
      this->Sort(cut.Between);
    }
  }

  std::vector<SheetCorners> Divide(SealId triangle) const
  {
    const SheetCorners& corners = this->Triangles[std::size_t(triangle)].Corners;
    std::array<const std::vector<CutEdge>*, 3> onEdges = { nullptr, nullptr, nullptr };
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const auto found = this->OnEdge.find(KeyOf(corners[edge], corners[(edge + 1) % 3]));
      onEdges[edge] = found != this->OnEdge.end() ? &found->second : nullptr;
    }
    if (this->CutsOf[std::size_t(triangle)].empty() && !onEdges[0] && !onEdges[1] && !onEdges[2])
    {
      return { corners };
    }
    const TriangleView view = this->ViewOf(triangle);
    TriangleSplitter splitter(
      { view.At(this->At(corners[0])), view.At(this->At(corners[1])), view.At(this->At(corners[2])) }, this->Accuracy);
    std::vector<SealId> vertices(corners.begin(), corners.end());
    std::unordered_map<SealId, int> points;
    const auto add = [&](SealId vertex, int point)
    {
      if (point < 0)
      {
        throw Undecided{ this->At(vertex) };
      }
      vertices.push_back(vertex);
      points[vertex] = point;
    };
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const bool isForward = corners[edge] < corners[(edge + 1) % 3];
      const std::size_t count = onEdges[edge] ? onEdges[edge]->size() : 0;
      for (std::size_t n = 0; n < count; ++n)
      {
        const SealId vertex = (*onEdges[edge])[isForward ? n : count - 1 - n].Vertex;
        add(vertex, splitter.AddOnEdge(int(edge), view.At(this->At(vertex))));
      }
    }
    for (const SealId number : this->CutsOf[std::size_t(triangle)])
    {
      for (const SealId vertex : this->ChainOf(number))
      {
        if (points.count(vertex) == 0)
        {
          add(vertex, splitter.AddInside(view.At(this->At(vertex))));
        }
      }
    }
    this->Connect(triangle, points, splitter);
    std::vector<SheetCorners> parts;
    for (const auto& [a, b, c] : splitter.Finish())
    {
      parts.push_back({ vertices[std::size_t(a)], vertices[std::size_t(b)], vertices[std::size_t(c)] });
    }
    return parts;
  }

  std::vector<SealId> ChainOf(SealId number) const
  {
    const SheetCut& cut = this->Cuts[std::size_t(number)];
    std::vector<SealId> chain = { cut.Ends[0] };
    for (const CutEdge& between : cut.Between)
    {
      chain.push_back(between.Vertex);
    }
    chain.push_back(cut.Ends[1]);
    return chain;
  }

  void Connect(SealId triangle, const std::unordered_map<SealId, int>& points, TriangleSplitter& splitter) const
  {
    for (const SealId number : this->CutsOf[std::size_t(triangle)])
    {
      const std::vector<SealId> chain = this->ChainOf(number);
      for (std::size_t n = 1; n < chain.size(); ++n)
      {
        if (!splitter.Connect(points.at(chain[n - 1]), points.at(chain[n])))
        {
          throw Undecided{ this->At(chain[n]) };
        }
      }
    }
  }

  struct PairHash
  {
    std::size_t operator()(const std::pair<EdgeKey, SealId>& key) const
    {
      return std::hash<EdgeKey>()(key.first * 0x9E3779B97F4A7C15U + std::uint64_t(key.second));
    }
  };

  const std::vector<Sheet>& Sheets;
  double Accuracy = 0.0; // of the places of vertices on lines
  Arrangement Result;
  std::vector<ArrangedTriangle> Triangles;
  std::vector<SealId> Begins; // the first triangle of a sheet
  std::vector<BoxTree> Trees; // by sheet
  std::vector<SheetCut> Cuts;
  std::vector<std::vector<SealId>> CutsOf; // by triangle
  std::unordered_map<std::pair<EdgeKey, SealId>, SealId, PairHash> Pierced;
  std::unordered_map<EdgeKey, std::vector<CutEdge>> OnEdge;
  std::map<std::array<SealId, 3>, SealId> Triples;
};
}

//----------------------------------------------------------------------------------------------------------------------
Arrangement Arrange(
  const std::vector<Sheet>& sheets, const std::vector<std::pair<int, int>>& pairs, const Monitor& monitor)
{
  Arranger arranger(sheets);
  for (std::size_t n = 0; n < pairs.size(); ++n)
  {
    monitor.Progress(double(n) / double(pairs.size()));
    arranger.CutPair(std::size_t(pairs[n].first), std::size_t(pairs[n].second));
  }
  return arranger.Finish();
}
}
