// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ModelPrinters.h"

#include "Common/Text/TextPrinter.h"
#include "Writers/HorizonMesh/MeshPrinter.h"

#include <cmath>
#include <unordered_map>

namespace SeismicHorizons
{
namespace
{
/// Gmsh takes numbers from 1. A negative one turns what is around an entity.
using SignedNumbers = std::vector<std::int64_t>;

std::int64_t SignedNumber(std::size_t n, bool isTurned)
{
  return isTurned ? -std::int64_t(n) - 1 : std::int64_t(n) + 1;
}

void PrintModelNames(const ClosedModel& model, TextPrinter& out)
{
  out.Print("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n");
  out.PrintLine("", model.Surfaces.size() + model.Bodies.size());
  int dimension = 2;
  for (const std::vector<std::string>& names :
    { NameDifferently(model.Surfaces, ""), NameDifferently(model.Bodies, "") })
  {
    for (std::size_t n = 0; n < names.size(); ++n)
    {
      out.PrintLine(" ", dimension, n + 1, '"' + names[n] + '"');
    }
    ++dimension;
  }
  out.Print("$EndPhysicalNames\n");
}

/// All but corners share one bounding box.
void PrintModelEntities(
  const ClosedModel& model, const ModelTopology& topology, const std::vector<std::int64_t>& corners, TextPrinter& out)
{
  std::array<double, 6> box = { HUGE_VAL, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (const std::array<double, 3>& point : model.Points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box[axis] = std::min(box[axis], point[axis]);
      box[3 + axis] = std::max(box[3 + axis], point[axis]);
    }
  }
  const auto print = [&](std::size_t entity, const std::string& physical, const SignedNumbers& around)
  {
    out.Print(std::int64_t(entity) + 1);
    std::for_each(box.begin(), box.end(), [&](double value) { out.Print(" ", value); });
    out.Print(physical, " ", around.size());
    std::for_each(around.begin(), around.end(), [&](std::int64_t number) { out.Print(" ", number); });
    out.Print("\n");
  };
  std::vector<SignedNumbers> ofFaces(topology.Faces.size());
  std::vector<SignedNumbers> ofBodies(model.Bodies.size());
  out.Print("$Entities\n");
  out.PrintLine(" ", topology.Corners.size(), topology.Lines.size(), topology.Faces.size(), model.Bodies.size());
  for (std::size_t n = 0; n < topology.Corners.size(); ++n)
  {
    const std::array<double, 3>& place = model.Points[std::size_t(topology.Corners[n])];
    out.PrintLine(" ", n + 1, place[0], place[1], place[2], 0);
  }
  for (std::size_t n = 0; n < topology.Lines.size(); ++n)
  {
    const std::vector<PointId>& points = topology.Lines[n].Points;
    print(n, " 0", { corners[std::size_t(points.front())], -corners[std::size_t(points.back())] });
    for (const auto& [face, isAlong] : topology.Lines[n].Faces)
    {
      ofFaces[face].push_back(SignedNumber(n, !isAlong));
    }
  }
  for (std::size_t n = 0; n < topology.Faces.size(); ++n)
  {
    print(n, " 1 " + std::to_string(topology.Faces[n].Surface + 1), ofFaces[n]);
    for (const std::size_t side : { 0, 1 })
    {
      const std::array<int, 2>& bodies = topology.Faces[n].Bodies;
      if (const int body = bodies[side]; body >= 0 && body != bodies[1 - side]) // Faults in a body do not bound it.
      {
        ofBodies[std::size_t(body)].push_back(SignedNumber(n, side == 0));
      }
    }
  }
  for (std::size_t n = 0; n < model.Bodies.size(); ++n)
  {
    print(n, " 1 " + std::to_string(n + 1), ofBodies[n]);
  }
  out.Print("$EndEntities\n");
}

/// Each node belongs to the entity of fewest dimensions.
void PrintModelNodes(const ClosedModel& model, const ModelTopology& topology, TextPrinter& out)
{
  std::vector<char> arePrinted(model.Points.size());
  std::vector<std::pair<std::array<std::size_t, 2>, std::vector<PointId>>> blocks; // by dimension and number
  const auto add = [&](std::size_t dimension, std::size_t n, const auto& points)
  {
    blocks.push_back({ { dimension, n + 1 }, {} });
    for (const PointId point : points)
    {
      if (!std::exchange(arePrinted[std::size_t(point)], 1))
      {
        blocks.back().second.push_back(point);
      }
    }
    if (blocks.back().second.empty())
    {
      blocks.pop_back();
    }
  };
  for (std::size_t n = 0; n < topology.Corners.size(); ++n)
  {
    add(0, n, std::array<PointId, 1>{ topology.Corners[n] });
  }
  for (std::size_t n = 0; n < topology.Lines.size(); ++n)
  {
    add(1, n, topology.Lines[n].Points);
  }
  for (std::size_t n = 0; n < topology.Faces.size(); ++n)
  {
    std::vector<PointId> points;
    for (const std::size_t triangle : topology.Faces[n].Triangles)
    {
      points.insert(points.end(), topology.Triangles[triangle].begin(), topology.Triangles[triangle].end());
    }
    add(2, n, points);
  }
  out.Print("$Nodes\n");
  out.PrintLine(" ", blocks.size(), std::count(arePrinted.begin(), arePrinted.end(), 1), 1, model.Points.size());
  for (const auto& [entity, points] : blocks)
  {
    out.PrintLine(" ", entity[0], entity[1], 0, points.size());
    std::for_each(points.begin(), points.end(), [&](PointId point) { out.PrintLine("", point + 1); });
    for (const PointId point : points)
    {
      const std::array<double, 3>& place = model.Points[std::size_t(point)];
      out.PrintLine(" ", place[0], place[1], place[2]);
    }
  }
  out.Print("$EndNodes\n");
}

void PrintModelElements(const ModelTopology& topology, const Monitor& monitor, TextPrinter& out)
{
  std::size_t count = topology.Triangles.size();
  for (const ModelTopology::Line& line : topology.Lines)
  {
    count += line.Points.size() - 1;
  }
  out.Print("$Elements\n");
  out.PrintLine(" ", topology.Lines.size() + topology.Faces.size(), count, 1, count);
  std::size_t element = 0;
  for (std::size_t n = 0; n < topology.Lines.size(); ++n)
  {
    const std::vector<PointId>& points = topology.Lines[n].Points;
    out.PrintLine(" ", 1, n + 1, 1, points.size() - 1);
    for (std::size_t end = 1; end < points.size(); ++end)
    {
      out.PrintLine(" ", ++element, points[end - 1] + 1, points[end] + 1);
    }
  }
  for (std::size_t n = 0; n < topology.Faces.size(); ++n)
  {
    monitor.Progress(double(n) / double(topology.Faces.size()));
    out.PrintLine(" ", 2, n + 1, 2, topology.Faces[n].Triangles.size());
    for (const std::size_t triangle : topology.Faces[n].Triangles)
    {
      const TSurf::Triangle& corners = topology.Triangles[triangle];
      out.PrintLine(" ", ++element, corners[0] + 1, corners[1] + 1, corners[2] + 1);
    }
  }
  out.Print("$EndElements\n");
}
}

//----------------------------------------------------------------------------------------------------------------------
void PrintModelGmsh(
  const ClosedModel& model, const ModelTopology& topology, std::ostream& stream, const Monitor& monitor)
{
  std::vector<std::int64_t> corners(model.Points.size()); // numbers by point
  for (std::size_t n = 0; n < topology.Corners.size(); ++n)
  {
    corners[std::size_t(topology.Corners[n])] = std::int64_t(n) + 1;
  }
  TextPrinter out(stream);
  PrintModelNames(model, out);
  PrintModelEntities(model, topology, corners, out);
  PrintModelNodes(model, topology, out);
  PrintModelElements(topology, monitor.Step(0.5, 1.0), out);
  out.Flush();
  monitor.Progress(1.0);
}

//----------------------------------------------------------------------------------------------------------------------
void PrintModelSTL(
  const ClosedModel& model, const ModelTopology& topology, std::ostream& stream, const Monitor& monitor)
{
  for (std::size_t body = 0; body < model.Bodies.size(); ++body)
  {
    monitor.Progress(double(body) / double(model.Bodies.size()));
    TSurf solid;
    solid.Name = model.Bodies[body].Name;
    std::unordered_map<PointId, PointId> vertices;
    for (const ModelTopology::Face& face : topology.Faces)
    {
      const bool isInside = face.Bodies[0] == int(body); // The normals point into the body.
      for (std::size_t n = 0; isInside != (face.Bodies[1] == int(body)) && n < face.Triangles.size(); ++n)
      {
        TSurf::Triangle corners = topology.Triangles[face.Triangles[n]];
        std::swap(corners[1], corners[isInside ? 2 : 1]);
        for (PointId& corner : corners)
        {
          const auto [vertex, isNew] = vertices.try_emplace(corner, PointId(vertices.size()));
          if (isNew)
          {
            solid.Vertices.push_back(model.Points[std::size_t(corner)]);
          }
          corner = vertex->second;
        }
        solid.Triangles.push_back(corners);
      }
    }
    PrintSTL(solid, stream);
  }
  monitor.Progress(1.0);
}
}
