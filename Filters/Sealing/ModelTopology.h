// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that enclose bodies, and how they are connected:
//
//    - a line: edges of other than two triangles, or between two surfaces, along which the same faces meet;
//    - a face: triangles of a surface that no line parts, so that each of its sides is in one body;
//    - a corner: a point where other than two edges of lines end, or other faces meet from there on. A line without one
//      gets three.

#ifndef SeismicHorizonsModelTopology_h
#define SeismicHorizonsModelTopology_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/TSurf.h"

#include <utility>

namespace SeismicHorizons
{
struct ClosedModel
{
  struct Surface
  {
    std::string Name;
    int Type; // 0 horizon, 1 fault, 2 wall, 3 top or base
  };
  struct Body
  {
    std::string Name;
    int Layer;
    int Block;
  };
  struct Triangle
  {
    TSurf::Triangle Corners;
    std::size_t Surface;
    std::array<int, 2> Bodies; // where the normal points to, by the right-hand rule, and behind; -1 outside
  };

  std::vector<std::array<double, 3>> Points;
  std::vector<Triangle> Triangles;
  std::vector<Surface> Surfaces;
  std::vector<Body> Bodies;
  SurveyDescription Survey;
};

struct ModelTopology
{
  struct Face
  {
    std::size_t Surface;
    std::array<int, 2> Bodies; // as those of its triangles; the same where a fault dies out in a body
    std::vector<std::size_t> Triangles;
  };
  struct Line
  {
    std::vector<PointId> Points; // from corner to corner
    std::vector<std::pair<std::size_t, bool>>
      Faces; // true if its triangles have the edges of the line in this direction
  };

  std::vector<TSurf::Triangle> Triangles; // those of a face turned alike
  std::vector<Face> Faces; // by surface
  std::vector<Line> Lines;
  std::vector<PointId> Corners;
  std::vector<char> AreLines; // by 3 * triangle + number of the first corner of the edge
  /// By 3 * triangle + corner: equal for corners of a face at one point, unless lines part them.
  std::vector<std::int32_t> Vertices;
};

/// Throws InputError for coordinates that are not finite, numbers out of range, a triangle with a point twice or, unless of
/// a fault, one body on both sides, a body without triangles, and edges where bodies are open.
ModelTopology FindTopology(const ClosedModel& model, const Monitor& monitor = Monitor());
}

#endif
