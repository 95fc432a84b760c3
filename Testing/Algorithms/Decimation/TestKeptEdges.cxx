// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines that become sides of a mesh and stay: random ones, beside the same question by trying all sides.

#include "Common/Horizon/MeshChecker.h"
#include "DecimationChecker.h"
#include "Filters/Algorithms/Decimation/HeightMesh.h"
#include "Filters/Algorithms/Decimation/MeshRefiner.h"
#include "Filters/Algorithms/Decimation/PlaneMesh.h"
#include "Tools/Check.h"

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
using Line = std::pair<PointId, PointId>;

int Side(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
{
  const auto turn = MeshChecker::Turn(a, b, p);
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

/// A square of columns with random vertices, and the lines that are kept in it.
class Square
{
public:
  explicit Square(unsigned seed)
    : Random(seed)
    , Columns(Patches::FromPicture(std::vector<std::string>(Width, std::string(Width, '#'))))
    , Mesh(MakeHorizon(), Monitor())
  {
    std::vector<unsigned char> marks(this->Columns.size(), 0);
    for (unsigned char& mark : marks)
    {
      mark = this->Random() % 6 == 0 ? 1 : 0;
    }
    MeshRefiner(this->Mesh, 0, DecimationPriority::LargestError).InsertMarked(marks);
    for (std::size_t point = 0; point < marks.size(); ++point)
    {
      const VertexId vertex = this->VertexOf(PointId(point));
      CHECK((vertex >= 0) == this->Mesh.IsVertex(PointId(point)));
      CHECK((vertex >= 0) == (marks[point] != 0 || (vertex >= 0 && this->Mesh.IsOnLoop(vertex))));
    }
  }

  /// Keeps as many random lines as asked for, and checks each answer.
  void KeepLines(int lines)
  {
    KeptEdges sides(this->Mesh.Triangles(), std::size_t(this->Mesh.EndOfVertices()));
    for (int line = 0; line < lines; ++line)
    {
      const PointId from = this->RandomVertex();
      const PointId to = this->RandomVertex();
      const bool isCrossed = this->IsCrossed(from, to);
      if (from != to && CHECK(sides.Keep(this->VertexOf(from), this->VertexOf(to)) == !isCrossed) && !isCrossed)
      {
        this->AddPieces(from, to);
        this->NumberOfKept += 1;
      }
      this->CrossedLines += isCrossed ? 1 : 0;
      if (isCrossed)
      {
        return; // pieces before the crossing are kept as well, which ones is told by nothing
      }
    }
    this->Mesh.Triangles().MakeDelaunay();
  }

  void InsertPoints()
  {
    std::vector<unsigned char> marks(this->Columns.size(), 0);
    for (unsigned char& mark : marks)
    {
      mark = this->Random() % 20 == 0 ? 1 : 0;
    }
    MeshRefiner(this->Mesh, 0, DecimationPriority::LargestError).InsertMarked(marks);
    this->Mesh.SortByPlace(); // other numbers
    std::vector<Line> before;
    before.swap(this->Kept);
    for (const Line& line : before)
    {
      this->AddPieces(line.first, line.second); // new points cut some
    }
  }

  /// All kept lines are sides, and all others are Delaunay; triangles turn to the left and fill the square.
  void Check(bool isDelaunay) const
  {
    const PlaneMesh& mesh = this->Mesh.Triangles();
    std::set<Line> sides;
    std::int64_t area = 0;
    for (TriangleId triangle = 0; triangle < mesh.Size(); ++triangle)
    {
      const auto at = [&](int corner) { return mesh.Place(mesh.Corner(triangle, corner)); };
      CHECK(Side(at(0), at(1), at(2)) > 0);
      area += std::int64_t(MeshChecker::Turn(at(0), at(1), at(2)));
      for (int side = 0; side < 3; ++side)
      {
        sides.insert(std::minmax(this->PointAt(triangle, side), this->PointAt(triangle, NextCorner(side))));
        const bool isInner = mesh.Neighbour(triangle, side) != NoTriangle;
        if (isDelaunay && isInner && !this->IsKeptLine(triangle, side))
        {
          const PlanePoint beyond = mesh.Place(mesh.Beyond(triangle, side));
          CHECK(MeshChecker::SideOfCircle(at(0), at(1), at(2), beyond) <= 0);
        }
      }
    }
    CHECK_EQUAL(area, 2 * (Width - 1) * (Width - 1));
    for (const Line& line : this->Kept)
    {
      CHECK(sides.count(std::minmax(line.first, line.second)) > 0);
      CHECK(mesh.IsKept(this->VertexOf(line.first), this->VertexOf(line.second)));
    }
  }

  std::size_t NumberOfKept = 0;
  int CrossedLines = 0;

private:
  static constexpr int Width = 14;

  BoundedHorizon MakeHorizon() const { return TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(this->Columns)); }

  const PlanePoint& At(PointId point) const { return this->Columns[std::size_t(point)]; }

  PointId RandomVertex()
  {
    PointId point = PointId(this->Random() % this->Columns.size());
    while (!this->Mesh.IsVertex(point))
    {
      point = PointId(this->Random() % this->Columns.size());
    }
    return point;
  }

  VertexId VertexOf(PointId point) const
  {
    VertexId vertex = this->Mesh.EndOfVertices() - 1;
    while (vertex >= 0 && this->Mesh.SourceOf(vertex) != point)
    {
      --vertex;
    }
    return vertex;
  }

  PointId PointAt(TriangleId triangle, int corner) const
  {
    return this->Mesh.SourceOf(this->Mesh.Triangles().Corner(triangle, corner));
  }

  bool IsCrossed(PointId from, PointId to) const
  {
    return std::any_of(this->Kept.begin(), this->Kept.end(),
      [&](const Line& line)
      {
        return Side(this->At(from), this->At(to), this->At(line.first)) *
            Side(this->At(from), this->At(to), this->At(line.second)) <
          0 &&
          Side(this->At(line.first), this->At(line.second), this->At(from)) *
            Side(this->At(line.first), this->At(line.second), this->At(to)) <
          0;
      });
  }

  /// Cut where vertices are on it.
  void AddPieces(PointId from, PointId to)
  {
    std::vector<PointId> on;
    const PlanePoint& a = this->At(from);
    const PlanePoint& b = this->At(to);
    const auto along = [&](PointId point)
    { return (this->At(point).X - a.X) * (b.X - a.X) + (this->At(point).Y - a.Y) * (b.Y - a.Y); };
    for (std::size_t point = 0; point < this->Columns.size(); ++point)
    {
      const auto id = PointId(point);
      if (this->Mesh.IsVertex(id) && Side(a, b, this->At(id)) == 0 && along(id) >= 0 && along(id) <= along(to))
      {
        on.push_back(id);
      }
    }
    std::sort(on.begin(), on.end(), [&](PointId one, PointId other) { return along(one) < along(other); });
    for (std::size_t n = 1; n < on.size(); ++n)
    {
      this->Kept.emplace_back(on[n - 1], on[n]);
    }
  }

  bool IsKeptLine(TriangleId triangle, int side) const
  {
    const Line line = std::minmax(this->PointAt(triangle, side), this->PointAt(triangle, NextCorner(side)));
    return std::any_of(this->Kept.begin(), this->Kept.end(),
      [&](const Line& kept) { return Line(std::minmax(kept.first, kept.second)) == line; });
  }

  std::mt19937 Random;
  const Patches::Columns Columns;
  HeightMesh Mesh;
  std::vector<Line> Kept;
};
}

int TestKeptEdges(int, char*[])
{
  std::size_t kept = 0;
  int crossed = 0;
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    Square square(seed);
    square.Check(true);
    square.KeepLines(1 + int(seed % 6));
    square.Check(square.CrossedLines == 0);
    if (square.CrossedLines == 0)
    {
      square.InsertPoints();
      square.Check(true);
    }
    kept += square.NumberOfKept;
    crossed += square.CrossedLines;
  }
  CHECK(kept > 100);
  CHECK(crossed > 20);
  return Check::Result();
}
