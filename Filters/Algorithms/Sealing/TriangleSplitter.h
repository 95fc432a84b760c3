// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Divides a triangle by points on its edges and inside, and by segments between these: a constrained Delaunay
// triangulation of few points. Three points of one edge are on a line, whatever their rounding.

#ifndef SeismicHorizonsTriangleSplitter_h
#define SeismicHorizonsTriangleSplitter_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace SeismicHorizons
{
class TriangleSplitter
{
public:
  using Corners = std::array<int, 3>;

  /// Points 0, 1 and 2 are the corners, counter-clockwise. Places are off by up to `accuracy`.
  TriangleSplitter(const std::array<Eigen::Vector2d, 3>& corners, double accuracy);

  /// Adds a point between the last one of the edge from corner `edge` and the next corner. These come first.
  int AddOnEdge(int edge, const Eigen::Vector2d& place);
  /// Returns -1 for a point too near the border to tell its side.
  int AddInside(const Eigen::Vector2d& place);
  /// Makes the segment an edge. Segments only meet at points. Returns false if a point is too near it.
  bool Connect(int from, int to);
  /// Flips other edges until they are Delaunay.
  const std::vector<Corners>& Finish();

private:
  double Turn(int a, int b, int c) const;
  /// Whether the triangle is certainly counter-clockwise.
  bool IsTriangle(int a, int b, int c) const;
  bool Crosses(int a, int b, int c, int d) const;
  bool IsConnected(int a, int b) const;
  /// The triangle with the edge in this direction, turned so that it comes first, or -1.
  int Find(int a, int b);
  bool Flip(int triangle, bool isForced);

  std::vector<Eigen::Vector2d> Places;
  std::vector<unsigned> Edges; // bits of the edges that points are on
  std::vector<Corners> Triangles;
  std::vector<std::array<int, 2>> Segments;
  std::array<int, 3> Last = { 0, 1, 2 };
  double Accuracy;
};
}

#endif
