// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes a part of a horizon inside a boundary. Some of its edges may be those of other parts, and stay as they are.

#ifndef SeismicHorizonsSurfacePart_h
#define SeismicHorizonsSurfacePart_h

#include "Common/Base/ByteBuffer.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/DroppedPoints.h"
#include "Common/Horizon/Types.h"
#include "PointRows.h"
#include "Surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace SeismicHorizons
{
using PartCorners = std::array<PointId, 3>;

/// In points of the horizon.
struct SurfacePart
{
  std::vector<PartCorners> Triangles;
  std::unordered_map<PointId, double> Heights; // of vertices
  std::unordered_map<std::uint64_t, std::vector<PointId>> Chains; // the boundary between the ends of edges of outlines
  std::unordered_set<PointId> Dropped; // from outlines
  std::unordered_set<PointId> Locked; // of edges of other parts
  std::vector<PointId> AddedToOutlines;

  /// Forgets outlines with these keys, and points that were dropped there, except those that stay.
  void LetGo(const std::vector<std::uint64_t>& edges, const std::set<PointId>& stay);
  void Add(const SurfacePart& other);
  void Write(ByteBuffer& bytes) const;
  static SurfacePart Read(ByteBuffer& bytes);
  /// Moves triangles to the end of another part.
  void MoveTriangles(const std::function<bool(const PartCorners&)>& isChosen, SurfacePart& other);
};

struct PartBoundary
{
  std::vector<Edge> Edges; // with the part to their right
  std::vector<PointId> LoopsOfOne;
  std::set<PointId> Fixed; // points that stay on outlines
  std::map<PointId, double> Locked; // vertices of other parts, with their heights
  std::set<PointId> Dropped; // beside edges that stay
};

class PartMesher
{
public:
  /// Points that several loops share always stay. All must outlive this.
  PartMesher(const PointRows& rows, const SurfaceOptions& options, const SurfaceParameters& parameters,
    const std::unordered_set<PointId>& shared);

  /// Rows around those of the boundary that are needed.
  std::int32_t RowsAround() const { return this->Reach; }
  /// With the rows around.
  PointWindow Read(std::int32_t firstRow, std::int32_t lastRow) const;
  SurfacePart Mesh(PointWindow window, PartBoundary boundary, const Monitor& monitor) const;

private:
  enum class State : unsigned char
  {
    Away,
    Beside, // seen by outlines, and by edges that cross links to it
    Inside
  };

  struct PartPoints
  {
    PointId NumberOf(PointId point) const
    {
      return PointId(std::lower_bound(this->Own.begin(), this->Own.end(), point) - this->Own.begin());
    }

    std::vector<PointId> Own; // points of the horizon, ascending
    std::vector<unsigned char> IsInside;
    std::vector<PlanePoint> Columns;
    std::vector<double> Height;
    DroppedPoints Beside;
  };

  PartPoints Select(const PointWindow& window, const Loops& loops, const std::set<PointId>& dropped) const;
  static SurfacePart ToPart(const PartPoints& points, const Loops& exact, const Surface& made);
  std::vector<State> FindStates(const PointWindow& window, const Loops& loops, const std::set<PointId>& dropped) const;
  void AddBeside(
    const PointWindow& window, const PlanePoint& from, const PlanePoint& to, std::vector<State>& states) const;

  const PointRows& Rows;
  const SurfaceOptions& Options;
  const std::unordered_set<PointId>& Shared;
  const std::int32_t Reach; // of outlines, in columns
};
}

#endif
