// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is written beside CGAL's reader of GOCAD files, which takes surfaces of one part. Built where CGAL is installed.

#include "Tools/Check.h"
#include "Writers/GOCADTSurf/TSurfPrinter.h"

#include <CGAL/IO/GOCAD.h>
#include <CGAL/Simple_cartesian.h>

#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

int TestTSurfCgal(int, char*[])
{
  TSurf surface;
  surface.Name = "square";
  surface.Vertices = { { 459621.05127000005, 0, 5 }, { 1, 0, 0.1 }, { 1, 1, 5 }, { 0, 1, -1e-9 } };
  surface.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  surface.Properties = { { "p", "", 2, std::vector<double>(8, 7.0) } };
  std::stringstream stream;
  PrintTSurf(surface, true, stream);

  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
  CHECK(CGAL::IO::read_GOCAD(stream, points, triangles));
  CHECK_EQUAL(points.size(), surface.Vertices.size());
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    CHECK((std::array<double, 3>{ points[n].x(), points[n].y(), points[n].z() } == surface.Vertices[n]));
  }
  CHECK((triangles == std::vector<std::vector<std::size_t>>{ { 0, 1, 2 }, { 0, 2, 3 } }));
  return Check::Result();
}
