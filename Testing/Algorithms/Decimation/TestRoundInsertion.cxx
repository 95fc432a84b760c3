// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points inserted by squares leave the mesh of points inserted one after the other, number by number.

#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/Decimation/RoundInsertion.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"
#include "Tools/TestHorizons.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// A square with random holes, on waves and noise.
BoundedHorizon MakeHorizon(int side, Patches::Random& random)
{
  std::vector<std::string> picture(side, std::string(side, '#'));
  for (int hole = random.Below(6); hole > 0; --hole)
  {
    const int size = 2 + random.Below(side / 5);
    const int x = 2 + random.Below(side - size - 4);
    const int y = 2 + random.Below(side - size - 4);
    std::for_each(
      picture.begin() + y, picture.begin() + y + size, [&](std::string& row) { row.replace(x, size, size, '.'); });
  }
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(Patches::FromPicture(picture)));
  const double noise = random.Chance(0.5) ? 0.0 : 3.0 * random.Fraction();
  const double wave = 0.05 + 0.3 * random.Fraction();
  for (std::size_t point = 0; point < horizon.Height.size(); ++point)
  {
    const PlanePoint& column = horizon.ColumnPlaces()[point];
    horizon.Height[point] =
      std::round(20.0 * std::sin(wave * column.X) * std::cos(0.7 * wave * column.Y) + noise * random.Fraction());
  }
  return horizon;
}

struct Insertion
{
  HeightMesh Mesh;
  std::vector<unsigned char> IsChanged = {};
  std::vector<TriangleId> Changed = {};

  /// Inserts points one after the other.
  void Insert(
    const std::vector<TriangleId>& triangles, const std::vector<std::size_t>& numbers, const PlaneMesh::Room& room)
  {
    std::vector<TriangleId> around;
    for (const std::size_t number : numbers)
    {
      const PointId point = this->Mesh.Error(triangles[number]).Point;
      const VertexId corner = this->Mesh.CornerOf(triangles[number], point);
      around.clear();
      if (corner != NoVertex)
      {
        this->Mesh.PutBack(corner);
        this->Mesh.Triangles().FindRing(corner, triangles[number], around);
      }
      else if (this->IsChanged[triangles[number]] == 0)
      {
        this->Mesh.Insert(point, triangles[number], room.At(number), around);
      }
      for (const TriangleId triangle : around)
      {
        if (this->IsChanged[triangle] == 0)
        {
          this->IsChanged[triangle] = 1;
          this->Changed.push_back(triangle);
        }
      }
    }
  }

  void Round(const std::vector<TriangleId>& triangles, bool isBySquares)
  {
    const PlaneMesh::Room room = this->Mesh.AddRoom(triangles.size());
    this->IsChanged.assign(std::size_t(this->Mesh.Triangles().Size()), 0);
    this->Changed.clear();
    std::vector<std::size_t> numbers(triangles.size());
    for (std::size_t n = 0; n < numbers.size(); ++n)
    {
      numbers[n] = n;
    }
    if (isBySquares)
    {
      numbers = RoundInsertion(this->Mesh, triangles, room, this->IsChanged).Run(this->Changed);
      CHECK(std::is_sorted(numbers.begin(), numbers.end()));
    }
    this->Insert(triangles, numbers, room);
    this->Mesh.CloseGaps(room, this->Changed, this->IsChanged);
    std::sort(this->Changed.begin(), this->Changed.end());
  }
};

bool AreSame(const HeightMesh& one, const HeightMesh& other)
{
  bool areSame = one.Triangles().Size() == other.Triangles().Size() && one.EndOfVertices() == other.EndOfVertices();
  for (TriangleId triangle = 0; areSame && triangle < one.Triangles().Size(); ++triangle)
  {
    areSame = one.Triangles().Corners(triangle) == other.Triangles().Corners(triangle);
    for (int edge = 0; edge < 3; ++edge)
    {
      areSame = areSame && one.Triangles().Neighbour(triangle, edge) == other.Triangles().Neighbour(triangle, edge);
    }
  }
  for (VertexId vertex = 0; areSame && vertex < one.EndOfVertices(); ++vertex)
  {
    areSame = one.SourceOf(vertex) == other.SourceOf(vertex) && one.Height(vertex) == other.Height(vertex);
  }
  return areSame;
}

std::vector<TriangleId> FarTriangles(HeightMesh& mesh, Patches::Random& random)
{
  constexpr double bound = 0.6;
  std::vector<TriangleId> triangles = mesh.AllTriangles();
  mesh.Measure(triangles, ErrorSquares(), bound, Monitor());
  const double least = random.Chance(0.3) ? bound : bound + 0.6 * (mesh.LargestError() - bound);
  const auto isNear = [&](TriangleId triangle) { return mesh.Error(triangle).Largest <= least; };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), isNear), triangles.end());
  mesh.FindPoints(triangles, bound);
  std::vector<double> order(std::size_t(mesh.Triangles().Size()));
  const bool isRandom = random.Chance(0.5); // or by error
  std::for_each(triangles.begin(), triangles.end(),
    [&](TriangleId triangle) { order[triangle] = isRandom ? random.Fraction() : -mesh.Error(triangle).Largest; });
  std::stable_sort(triangles.begin(), triangles.end(), [&](TriangleId a, TriangleId b) { return order[a] < order[b]; });
  return triangles;
}

/// Moves vertices, so that some are to be put back.
void MoveSome(std::vector<Insertion*> insertions, Patches::Random& random)
{
  const HeightMesh& first = insertions.front()->Mesh;
  std::vector<InnerHeights> heights = first.HeightsOf(first.InnerVertices());
  for (double& height : heights.front().Heights)
  {
    height += random.Chance(0.2) ? 4.0 * random.Fraction() : 0.0;
  }
  std::for_each(
    insertions.begin(), insertions.end(), [&](Insertion* insertion) { insertion->Mesh.SetAllHeights(heights); });
}

void TestSame(int side, std::uint64_t seed)
{
  Patches::Random random(seed);
  const BoundedHorizon horizon = MakeHorizon(side, random);
  Insertion plain{ HeightMesh(horizon, Monitor()) };
  Insertion bySquares{ HeightMesh(horizon, Monitor()) };
  std::size_t most = 0;
  for (int round = 0; round < 20; ++round)
  {
    Patches::Random choice(seed + std::uint64_t(round));
    Patches::Random again = choice;
    const std::vector<TriangleId> triangles = FarTriangles(plain.Mesh, choice);
    CHECK((FarTriangles(bySquares.Mesh, again) == triangles));
    most = std::max(most, triangles.size());
    plain.Round(triangles, false);
    bySquares.Round(triangles, true);
    CHECK((plain.Changed == bySquares.Changed));
    CHECK(AreSame(plain.Mesh, bySquares.Mesh));
    if (round % 5 == 4)
    {
      MoveSome({ &plain, &bySquares }, random);
    }
  }
  CHECK(most > 200);
}
}

int TestRoundInsertion(int, char*[])
{
  for (const int threads : { 1, 4 })
  {
    Detail::NumberOfThreads() = threads;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
    {
      TestSame(seed % 4 == 0 ? 200 : 90, seed);
    }
  }
  return Check::Result();
}
