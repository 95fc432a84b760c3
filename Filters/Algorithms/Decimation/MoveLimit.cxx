// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MoveLimit.h"

#include <vector>

namespace SeismicHorizons
{
namespace
{
// What part of its way a vertex moves at least, if it moves.
constexpr double LeastPart = 0.25;

class MoveLimit
{
public:
  MoveLimit(HeightMesh& mesh, double error, const InnerHeights& heights)
    : Mesh(mesh)
    , Error(error)
    , Before(mesh.Heights())
    , After(heights)
    , Heights(heights)
    , Parts(heights.Points.size(), 1.0)
  {
  }

  /// What one vertex moves less can put a triangle beside it off: all is measured until nothing is off.
  void Run()
  {
    do
    {
      this->Mesh.SetHeights(this->Heights);
      this->FindFar();
    } while (this->MoveBack());
  }

private:
  void FindFar()
  {
    this->IsFar.resize(std::size_t(this->Mesh.Triangles().Size()));
    this->Mesh.ForEachTriangle(Monitor(),
      [this](TriangleId triangle)
      { this->IsFar[std::size_t(triangle)] = this->Mesh.LargestWithSides(triangle) > this->Error ? 1 : 0; });
  }

  /// The corners of triangles that are too far; false when none of them can go back.
  bool MoveBack()
  {
    bool isMoved = false;
    for (TriangleId triangle = 0; triangle < this->Mesh.Triangles().Size(); ++triangle)
    {
      for (int corner = 0; corner < 3 && this->IsFar[std::size_t(triangle)] != 0; ++corner)
      {
        const bool isCornerMoved = this->MoveBack(this->Mesh.Triangles().Corner(triangle, corner));
        isMoved = isMoved || isCornerMoved;
      }
    }
    return isMoved;
  }

  bool MoveBack(PointId point)
  {
    const std::size_t n = this->Heights.Find(point);
    if (n == InnerHeights::None || this->Heights.Heights[n] == this->Before.Heights[n])
    {
      return false;
    }
    const double before = this->Before.Heights[n];
    this->Parts[n] *= 0.5;
    this->Heights.Heights[n] =
      this->Parts[n] < LeastPart ? before : before + this->Parts[n] * (this->After.Heights[n] - before);
    return true;
  }

  HeightMesh& Mesh;
  const double Error;
  const InnerHeights Before; // of the same vertices as those below
  const InnerHeights& After;
  InnerHeights Heights;
  std::vector<double> Parts;
  std::vector<unsigned char> IsFar; // by triangle
};
}

//----------------------------------------------------------------------------------------------------------------------
void MoveHeightsWithin(HeightMesh& mesh, double error, const InnerHeights& heights)
{
  MoveLimit(mesh, error, heights).Run();
}
}
