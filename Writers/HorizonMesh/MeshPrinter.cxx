// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshPrinter.h"

#include "Common/Text/TextPrinter.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
using Vertex = std::array<double, 3>;

void RequireFiniteVertices(const TSurf& surface)
{
  for (std::size_t vertex = 0; vertex < surface.Vertices.size(); ++vertex)
  {
    RequireFinitePoint(surface.Vertices[vertex], std::int64_t(vertex));
  }
}

template <typename Print>
void PrintTriangles(const TSurf& surface, const Monitor& monitor, Print&& print)
{
  constexpr std::size_t betweenReports = 1 << 14;
  std::size_t number = 0;
  for (const TSurf::Triangle& triangle : surface.Triangles)
  {
    if (number++ % betweenReports == 0)
    {
      monitor.Progress(double(number) / double(surface.Triangles.size()));
    }
    print(triangle);
  }
}

void PrintVertex(const Vertex& vertex, TextPrinter& out)
{
  for (const double coordinate : vertex)
  {
    out.Print(' ', coordinate);
  }
  out.Print('\n');
}

/// Returns a unit vector, or 0 for a triangle without area.
Vertex NormalOf(const Vertex& a, const Vertex& b, const Vertex& c)
{
  const Vertex u = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const Vertex v = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  Vertex normal = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
  const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  for (double& coordinate : normal)
  {
    coordinate = length > 0.0 ? coordinate / length + 0.0 : 0.0; // Avoids -0.
  }
  return normal;
}

template <typename Value>
void PrintBytes(const Value* values, std::size_t count, TextPrinter& out)
{
  out.Print(std::string_view(reinterpret_cast<const char*>(values), count * sizeof(Value)));
}

bool IsLittleEndian()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

std::string LineOf(std::string name)
{
  for (char& c : name)
  {
    c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return name;
}
}

//----------------------------------------------------------------------------------------------------------------------
void PrintSTL(const TSurf& surface, std::ostream& stream, const Monitor& monitor)
{
  RequireFiniteVertices(surface);
  TextPrinter out(stream);
  out.Print("solid " + LineOf(surface.Name) + '\n');
  PrintTriangles(surface, monitor,
    [&](const TSurf::Triangle& triangle)
    {
      const auto at = [&](int corner) { return surface.Vertices[std::size_t(triangle[std::size_t(corner)])]; };
      out.Print(" facet normal");
      PrintVertex(NormalOf(at(0), at(1), at(2)), out);
      out.Print("  outer loop\n");
      for (int corner = 0; corner < 3; ++corner)
      {
        out.Print("   vertex");
        PrintVertex(at(corner), out);
      }
      out.Print("  endloop\n endfacet\n");
    });
  out.Print("endsolid " + LineOf(surface.Name) + '\n');
  out.Flush();
}

//----------------------------------------------------------------------------------------------------------------------
void PrintPLY(const TSurf& surface, std::ostream& stream, const Monitor& monitor)
{
  RequireFiniteVertices(surface);
  TextPrinter out(stream);
  out.Print(std::string("ply\nformat binary_") + (IsLittleEndian() ? "little" : "big") + "_endian 1.0\ncomment " +
    LineOf(surface.Name) + "\nelement vertex " + std::to_string(surface.Vertices.size()) +
    "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
    std::to_string(surface.Triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n");
  for (const Vertex& vertex : surface.Vertices)
  {
    PrintBytes(vertex.data(), vertex.size(), out);
  }
  PrintTriangles(surface, monitor,
    [&](const TSurf::Triangle& triangle)
    {
      const std::array<std::int32_t, 3> corners = { std::int32_t(triangle[0]), std::int32_t(triangle[1]),
        std::int32_t(triangle[2]) };
      out.Print(char(corners.size()));
      PrintBytes(corners.data(), corners.size(), out);
    });
  out.Flush();
}

//----------------------------------------------------------------------------------------------------------------------
void PrintOBJ(const TSurf& surface, std::ostream& stream, const Monitor& monitor)
{
  RequireFiniteVertices(surface);
  TextPrinter out(stream);
  out.Print("o " + LineOf(surface.Name) + '\n');
  for (const Vertex& vertex : surface.Vertices)
  {
    out.Print('v');
    PrintVertex(vertex, out);
  }
  PrintTriangles(surface, monitor,
    [&](const TSurf::Triangle& triangle)
    {
      out.Print('f');
      for (const PointId corner : triangle)
      {
        out.Print(' ', std::int64_t(corner) + 1);
      }
      out.Print('\n');
    });
  out.Flush();
}
}
