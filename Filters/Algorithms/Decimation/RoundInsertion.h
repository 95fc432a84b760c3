// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inserts the points of a round in all squares of the plane at the same time, with the result of one after the other.
//
// A point reaches the triangle it lies in, those whose circles hold it, which its insertion changes, and the neighbours of
// these. After other insertions, it reaches no more than it did and they do: circles of a Delaunay mesh that hold a point
// are those that held it before, or belong to new triangles. So points of a square can be inserted in their order, except
// those that reach beyond the square and those that reach what an earlier one of these may reach. They wait for squares
// elsewhere, and the last ones for the caller.

#ifndef SeismicHorizonsRoundInsertion_h
#define SeismicHorizonsRoundInsertion_h

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "HeightMesh.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
class RoundInsertion
{
public:
  static constexpr std::size_t LeastPoints = 64; // Fewer are left to the caller.

  /// The points of the errors of these triangles, which they contain, are inserted into a Delaunay mesh without kept
  /// edges; vertices are put back. Point n has number n of the room. Triangles that change are marked.
  RoundInsertion(HeightMesh& mesh, const std::vector<TriangleId>& triangles, const PlaneMesh::Room& room,
    std::vector<unsigned char>& isChanged);

  /// Returns the points that wait, ascending, and adds triangles that changed. Points whose triangles changed are left out.
  std::vector<std::size_t> Run(std::vector<TriangleId>& changed);

  bool IsAnyPutBack() const { return this->HasPutBack; }

private:
  struct Reached
  {
    const TriangleId* First = nullptr;
    const TriangleId* Last = nullptr;

    const TriangleId* begin() const { return this->First; }
    const TriangleId* end() const { return this->Last; }
  };
  struct Point
  {
    std::size_t Number = 0;
    std::int64_t Square = 0;
    bool IsInside = false; // its square
    Reached Reach;
  };
  struct Square
  {
    std::vector<std::size_t> Waiting;
    std::vector<TriangleId> Changed;
    bool HasPutBack = false;
  };
  struct Squares
  {
    PlanePoint Origin;
    std::int32_t Side;
    std::int32_t Across;
    std::int32_t Down;

    PlaneBox BoxAt(const PlanePoint& place) const;
    std::int64_t NumberAt(const PlanePoint& place) const;
  };
  struct Scratch
  {
    std::vector<std::pair<TriangleId, TriangleId>> InCircle; // triangles, and where each is reached from
    std::vector<TriangleId> Reach;
    std::vector<TriangleId> Around;
  };

  PointId PointOf(std::size_t number) const { return this->Mesh.Error(this->Triangles[number]).Point; }
  const PlanePoint& PlaceOf(std::size_t number) const { return this->Mesh.Column(this->PointOf(number)); }
  bool IsDone(std::size_t number) const;
  PlaneBox FindBox() const;
  Squares MakeSquares(std::size_t points) const;
  void InsertBySquares(std::vector<std::size_t>& waiting, std::vector<TriangleId>& changed);
  std::vector<Point> FindPoints(
    const std::vector<std::size_t>& numbers, const Squares& squares, std::vector<std::vector<TriangleId>>& reached);
  bool Insert(const Point& point, Scratch& scratch, Square& square);
  void AddReach(std::size_t number, Scratch& scratch, std::vector<TriangleId>& reach) const;
  bool Contains(const PlaneBox& square, const Reached& reach) const;
  std::uint32_t RankOf(std::size_t number) const;
  void Reserve(const Reached& triangles, std::uint32_t rank);
  std::uint32_t RankAt(const Reached& triangles) const;

  HeightMesh& Mesh;
  const std::vector<TriangleId>& Triangles;
  const PlaneMesh::Room Room;
  const PlaneBox Box; // of all points
  std::vector<unsigned char>& IsChanged;
  std::vector<std::atomic<std::uint32_t>> Ranks; // by triangle, of the first waiting point that may reach it
  std::uint32_t Pass = 0;
  bool HasPutBack = false;
};
}

#endif
