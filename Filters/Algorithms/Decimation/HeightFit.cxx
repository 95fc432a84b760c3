// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightFit.h"

#include "Common/ColumnIndex.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace SeismicHorizons
{
namespace
{
/// The power of each step.
std::vector<double> Powers(FitAim aim)
{
  switch (aim)
  {
    case FitAim::LargestError:
      return { 4.0, 4.0 };
    case FitAim::Mean:
      return { 2.0, 1.5, 1.0 };
    default:
      return { 2.0 };
  }
}

// What an error of a side counts, beside one of a column, for a small mean error: that is of columns alone.
constexpr double PartOfSides = 0.1;

// The least error that a point is weighed by, in parts of how far heights may move: none is without weight.
constexpr double LeastError = 1e-2;

// Heights need not be exact, as each step goes a part of the way.
constexpr double Precision = 1e-3;
constexpr int MostIterations = 100;

/// The part of one triangle in the equations: what its corners weigh together, and with the errors of its points.
struct Element
{
  Eigen::Matrix3d Matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d Right = Eigen::Vector3d::Zero();
};

class HeightFitter
{
public:
  HeightFitter(const HeightMesh& mesh, double reach)
    : Surface(mesh)
    , Mesh(mesh.Triangles())
    , Reach(reach)
    , Inner(mesh.Heights())
  {
    auto next = this->Inner.Points.begin();
    for (PointId first = 0; std::size_t(first) < mesh.VertexMarks().size(); first += PlaceSet::WordBits)
    {
      std::uint64_t bits = 0;
      for (; next != this->Inner.Points.end() && *next - first < PlaceSet::WordBits; ++next)
      {
        bits |= std::uint64_t(1) << (*next - first);
      }
      this->Unknowns.Append(bits);
    }
  }

  InnerHeights Run(const std::vector<double>& powers, const Monitor& monitor)
  {
    for (std::size_t step = 0; step < powers.size() && !this->Inner.Points.empty(); ++step)
    {
      monitor.Progress(double(step) / double(powers.size()));
      this->Improve(powers[step]);
    }
    return std::move(this->Inner);
  }

private:
  using Entries = std::vector<Eigen::Triplet<double>>;

  /// Solves for how far heights have to move, and moves them a part of it.
  void Improve(double power)
  {
    const auto unknowns = Eigen::Index(this->Inner.Points.size());
    Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    {
      // Neither the elements are kept while the matrix is made, nor the entries while it is solved.
      const Entries entries = this->ListEntries(this->MakeElements(power), power, right);
      matrix.setFromTriplets(entries.begin(), entries.end());
    }
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
    solver.setTolerance(Precision);
    solver.setMaxIterations(MostIterations);
    const Eigen::VectorXd moves = solver.compute(matrix).solve(right) / std::max(1.0, power - 1.0);
    for (Eigen::Index n = 0; n < unknowns; ++n)
    {
      const double column = this->Surface.ColumnHeight(this->Inner.Points[n]);
      double& height = this->Inner.Heights[n];
      height = std::clamp(height + moves[n], column - this->Reach, column + this->Reach);
    }
  }

  std::vector<Element> MakeElements(double power) const
  {
    std::vector<Element> elements(std::size_t(this->Mesh.Size()));
    this->Surface.ForEachTriangle(
      Monitor(), [&](TriangleId triangle) { elements[triangle] = this->MakeElement(triangle, power); });
    return elements;
  }

  /// Of the columns that count for a triangle, and its sides.
  Element MakeElement(TriangleId triangle, double power) const
  {
    RaisedTriangle raised = this->Surface.RaisedCorners(triangle);
    for (int corner = 0; corner < 3; ++corner)
    {
      const int unknown = this->UnknownAt(triangle, corner);
      if (unknown >= 0)
      {
        raised[corner].Height = this->Inner.Heights[unknown];
      }
    }
    const double perArea = 1.0 / double(SignedArea(raised[0].Column, raised[1].Column, raised[2].Column));
    const double partOfSides = power > 2.0 ? 1.0 : PartOfSides;
    Element element;
    this->Surface.RasterOf(triangle).ForEachColumn(raised,
      [&](PointId, double error, const std::array<double, 3>& weights)
      {
        if (this->Surface.Owns(triangle, weights))
        {
          const Eigen::Vector3d parts = perArea * Eigen::Map<const Eigen::Vector3d>(weights.data());
          Add(parts, error, this->WeightOf(error, power), element);
        }
      });
    for (int side = 0; side < 3; ++side)
    {
      if (this->Mesh.Neighbour(triangle, side) > triangle) // each inner side once
      {
        const int next = NextCorner(side);
        this->Surface.RasterOf(triangle).ForEachCrossing(raised[side], raised[next],
          [&](const Crossing& crossing)
          {
            Eigen::Vector3d parts = Eigen::Vector3d::Zero();
            parts[side] = 1.0 - crossing.PartOfSide;
            parts[next] = crossing.PartOfSide;
            Add(parts, crossing.Error, partOfSides * this->WeightOf(crossing.Error, power), element);
          });
      }
    }
    return element;
  }

  double WeightOf(double error, double power) const
  {
    return std::pow(std::max(std::abs(error), LeastError * this->Reach), power - 2.0);
  }

  /// Of an error, with the parts that the corners have in it.
  static void Add(const Eigen::Vector3d& parts, double error, double weight, Element& element)
  {
    const Eigen::Vector3d weighted = weight * parts;
    element.Matrix += weighted * parts.transpose();
    element.Right -= error * weighted;
  }

  /// Those of the matrix, of which entries at one place are to be added up; adds to the right-hand side. The columns of
  /// the vertices are among them, which count for no triangle.
  Entries ListEntries(const std::vector<Element>& elements, double power, Eigen::VectorXd& right) const
  {
    Entries entries;
    entries.reserve(9 * elements.size() + this->Inner.Points.size());
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      const Element& element = elements[triangle];
      for (int row = 0; row < 3; ++row)
      {
        const int unknown = this->UnknownAt(triangle, row);
        if (unknown >= 0)
        {
          right[unknown] += element.Right[row];
        }
        for (int column = 0; column < 3 && unknown >= 0; ++column)
        {
          const int other = this->UnknownAt(triangle, column);
          if (other >= 0)
          {
            entries.emplace_back(unknown, other, element.Matrix(row, column));
          }
        }
      }
    }
    for (std::size_t n = 0; n < this->Inner.Points.size(); ++n)
    {
      const double error = this->Inner.Heights[n] - this->Surface.ColumnHeight(this->Inner.Points[n]);
      const double weight = this->WeightOf(error, power);
      entries.emplace_back(int(n), int(n), weight);
      right[Eigen::Index(n)] -= weight * error;
    }
    return entries;
  }

  /// The number of a corner among those that can move, or -1.
  int UnknownAt(TriangleId triangle, int corner) const
  {
    return int(this->Unknowns[this->Mesh.Corner(triangle, corner)]);
  }

  const HeightMesh& Surface;
  const PlaneMesh& Mesh;
  const double Reach;
  InnerHeights Inner;
  PlaceNumbers Unknowns; // by point, its position among these or -1: in far less memory than a number for each
};

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
      { this->IsFar[triangle] = this->Mesh.LargestWithSides(triangle) > this->Error ? 1 : 0; });
  }

  /// The corners of triangles that are too far; false when none of them can go back.
  bool MoveBack()
  {
    bool isMoved = false;
    for (TriangleId triangle = 0; triangle < this->Mesh.Triangles().Size(); ++triangle)
    {
      for (int corner = 0; corner < 3 && this->IsFar[triangle] != 0; ++corner)
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
InnerHeights FitHeights(const HeightMesh& mesh, FitAim aim, double reach, const Monitor& monitor)
{
  return HeightFitter(mesh, reach).Run(Powers(aim), monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void MoveHeightsWithin(HeightMesh& mesh, double error, const InnerHeights& heights)
{
  MoveLimit(mesh, error, heights).Run();
}
}
