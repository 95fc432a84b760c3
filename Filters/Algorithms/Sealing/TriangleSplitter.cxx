// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleSplitter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
TriangleSplitter::TriangleSplitter(const std::array<Eigen::Vector2d, 3>& corners, double accuracy)
  : Places(corners.begin(), corners.end())
  , Edges({ 1U | 4U, 1U | 2U, 2U | 4U })
  , Triangles({ { 0, 1, 2 } })
  , Accuracy(accuracy)
{
}

//----------------------------------------------------------------------------------------------------------------------
double TriangleSplitter::Turn(int a, int b, int c) const
{
  if ((this->Edges[std::size_t(a)] & this->Edges[std::size_t(b)] & this->Edges[std::size_t(c)]) != 0)
  {
    return 0.0;
  }
  const Eigen::Vector2d &p = this->Places[std::size_t(a)], &q = this->Places[std::size_t(b)];
  const Eigen::Vector2d& r = this->Places[std::size_t(c)];
  return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
}

//----------------------------------------------------------------------------------------------------------------------
bool TriangleSplitter::IsTriangle(int a, int b, int c) const
{
  const Eigen::Vector2d& p = this->Places[std::size_t(a)];
  const double size = (this->Places[std::size_t(b)] - p).norm() + (this->Places[std::size_t(c)] - p).norm();
  return this->Turn(a, b, c) > this->Accuracy * size;
}

//----------------------------------------------------------------------------------------------------------------------
int TriangleSplitter::Find(int a, int b)
{
  for (std::size_t n = 0; n < this->Triangles.size(); ++n)
  {
    Corners& corners = this->Triangles[n];
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      if (corners[edge] == a && corners[(edge + 1) % 3] == b)
      {
        std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(edge), corners.end());
        return int(n);
      }
    }
  }
  return -1;
}

//----------------------------------------------------------------------------------------------------------------------
int TriangleSplitter::AddOnEdge(int edge, const Eigen::Vector2d& place)
{
  const int point = int(this->Places.size()), next = (edge + 1) % 3;
  this->Places.push_back(place);
  this->Edges.push_back(1U << unsigned(edge));
  const int triangle = this->Find(this->Last[std::size_t(edge)], next);
  const Corners corners = this->Triangles[std::size_t(triangle)];
  this->Triangles[std::size_t(triangle)] = { corners[0], point, corners[2] };
  this->Triangles.push_back({ point, corners[1], corners[2] });
  this->Last[std::size_t(edge)] = point;
  return point;
}

//----------------------------------------------------------------------------------------------------------------------
int TriangleSplitter::AddInside(const Eigen::Vector2d& place)
{
  const int point = int(this->Places.size());
  this->Places.push_back(place);
  this->Edges.push_back(0);
  std::size_t best = 0, bestEdge = 0;
  double most = -1e300;
  for (std::size_t n = 0; n < this->Triangles.size(); ++n)
  {
    const Corners& corners = this->Triangles[n];
    std::array<double, 3> heights; // above the edges
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const int from = corners[edge], to = corners[(edge + 1) % 3];
      heights[edge] =
        this->Turn(from, to, point) / (this->Places[std::size_t(to)] - this->Places[std::size_t(from)]).norm();
    }
    const auto least = std::min_element(heights.begin(), heights.end());
    if (*least > most)
    {
      most = *least;
      best = n;
      bestEdge = std::size_t(least - heights.begin());
    }
  }
  const Corners corners = this->Triangles[best];
  const int a = corners[bestEdge], b = corners[(bestEdge + 1) % 3], c = corners[(bestEdge + 2) % 3];
  if (most > 2.0 * this->Accuracy)
  {
    this->Triangles[best] = { a, b, point };
    this->Triangles.push_back({ b, c, point });
    this->Triangles.push_back({ c, a, point });
    return point;
  }
  const int other = this->Find(b, a);
  if (most < -2.0 * this->Accuracy || other < 0)
  {
    return -1;
  }
  const int d = this->Triangles[std::size_t(other)][2];
  this->Triangles[best] = { b, c, point };
  this->Triangles.push_back({ c, a, point });
  this->Triangles[std::size_t(other)] = { a, d, point };
  this->Triangles.push_back({ d, b, point });
  return point;
}

//----------------------------------------------------------------------------------------------------------------------
bool TriangleSplitter::Crosses(int a, int b, int c, int d) const
{
  if (a == c || a == d || b == c || b == d)
  {
    return false;
  }
  // Segments on one line do not cross, whatever rounding says.
  const auto parts = [this](int from, int to, int left, int right)
  { return this->IsTriangle(from, to, left) && this->IsTriangle(to, from, right); };
  return (parts(a, b, c, d) || parts(a, b, d, c)) && (parts(c, d, a, b) || parts(c, d, b, a));
}

//----------------------------------------------------------------------------------------------------------------------
bool TriangleSplitter::IsConnected(int a, int b) const
{
  return std::any_of(this->Segments.begin(), this->Segments.end(),
    [&](const std::array<int, 2>& segment)
    { return (segment[0] == a && segment[1] == b) || (segment[0] == b && segment[1] == a); });
}

//----------------------------------------------------------------------------------------------------------------------
// Flips the first edge of the triangle, if the square is convex; if not forced, only one that is not Delaunay.
bool TriangleSplitter::Flip(int triangle, bool isForced)
{
  const Corners first = this->Triangles[std::size_t(triangle)];
  const auto [x, y, p] = first;
  const int other = this->Find(y, x);
  if (other < 0 || this->IsConnected(x, y))
  {
    return false;
  }
  const int q = this->Triangles[std::size_t(other)][2];
  if (!this->IsTriangle(x, q, p) || !this->IsTriangle(q, y, p))
  {
    return false;
  }
  if (!isForced)
  {
    const Eigen::Vector2d xp = this->Places[std::size_t(x)] - this->Places[std::size_t(p)];
    const Eigen::Vector2d yp = this->Places[std::size_t(y)] - this->Places[std::size_t(p)];
    const Eigen::Vector2d xq = this->Places[std::size_t(x)] - this->Places[std::size_t(q)];
    const Eigen::Vector2d yq = this->Places[std::size_t(y)] - this->Places[std::size_t(q)];
    const auto cosine = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    { return a.dot(b) / (a.norm() * b.norm()); };
    constexpr double same = 1e-9;
    if (cosine(xp, yp) + cosine(xq, yq) > -same)
    {
      return false;
    }
  }
  this->Triangles[std::size_t(triangle)] = { x, q, p };
  this->Triangles[std::size_t(other)] = { q, y, p };
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
// Crossed edges are flipped until none is left (Sloan 1993, "A fast algorithm for generating constrained Delaunay
// triangulations").
bool TriangleSplitter::Connect(int from, int to)
{
  std::deque<std::array<int, 2>> crossed;
  for (const Corners& corners : this->Triangles)
  {
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const int a = corners[edge], b = corners[(edge + 1) % 3];
      if (a < b && this->Crosses(from, to, a, b))
      {
        crossed.push_back({ a, b });
      }
    }
  }
  const std::size_t most = 16 + 8 * crossed.size() * crossed.size();
  for (std::size_t round = 0; !crossed.empty(); ++round)
  {
    const auto [x, y] = crossed.front();
    crossed.pop_front();
    const int triangle = this->Find(x, y);
    const int other = this->Find(y, x);
    if (round > most || triangle < 0 || other < 0)
    {
      return false;
    }
    const int p = this->Triangles[std::size_t(triangle)][2], q = this->Triangles[std::size_t(other)][2];
    if (!this->Flip(triangle, true))
    {
      crossed.push_back({ x, y });
    }
    else if (this->Crosses(from, to, p, q))
    {
      crossed.push_back({ p, q });
    }
  }
  this->Segments.push_back({ from, to });
  return this->Find(from, to) >= 0 || this->Find(to, from) >= 0;
}

//----------------------------------------------------------------------------------------------------------------------
const std::vector<TriangleSplitter::Corners>& TriangleSplitter::Finish()
{
  bool isFlipped = true;
  for (int round = 0; isFlipped && round < 100; ++round)
  {
    isFlipped = false;
    for (std::size_t n = 0; n < this->Triangles.size(); ++n)
    {
      for (int turn = 0; turn < 3; ++turn)
      {
        std::rotate(this->Triangles[n].begin(), this->Triangles[n].begin() + 1, this->Triangles[n].end());
        isFlipped = this->Flip(int(n), false) || isFlipped;
      }
    }
  }
  return this->Triangles;
}
}
