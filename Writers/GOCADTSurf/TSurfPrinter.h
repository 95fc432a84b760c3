// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints triangulated surfaces in GOCAD's text format (Documentation/GOCADTSurf.md). Ids start at 1. Numbers have
// the digits that restore them exactly.

#ifndef SeismicHorizonsTSurfPrinter_h
#define SeismicHorizonsTSurfPrinter_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/TSurf.h"
#include "Common/Text/TextPrinter.h"

#include <array>
#include <cstddef>
#include <ostream>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Omits vertices without triangles. `withBorders` adds FindBorders instead of the surface's own borders. Throws
/// InputError for invalid coordinates, names and units, and if writing fails.
void PrintTSurf(const TSurf& surface, bool withBorders, std::ostream& stream, const Monitor& monitor = Monitor());

/// For objects of GOCAD of any type. Throws InputError for names and units that are not a line, or have quotes.
void PrintCoordinateSystem(const SurveyDescription& survey, bool isDepth, TextPrinter& out);

/// Returns the text. Throws InputError with `what` unless it is one line.
std::string_view RequireLine(const char* what, std::string_view text);

// ---- Order of the file -------------------------------------------------------------------------------------------
/// The vertices and triangles of a TSurf in the order of the file, part by part. Vertices of triangles come by
/// ascending number within a part. A vertex of several parts is repeated in each, with a reference to its first entry.
struct PartMesh
{
  struct Part
  {
    std::size_t LastVertex, LastTriangle; // exclusive; a part begins at the end of the previous one
  };

  std::vector<PointId> Sources;
  std::vector<PointId> Places; // Earlier vertex at the same place, or NoPoint.
  std::vector<TSurf::Triangle> Triangles;
  std::vector<Part> Parts;
};

PartMesh MakePartMesh(const TSurf& surface);

/// Returns the first two vertices of each border loop. Loops run against their triangles, as GOCAD writes them. Time is
/// linear, except for sorting the neighbours of each vertex.
std::vector<std::array<PointId, 2>> FindBorders(
  const std::vector<TSurf::Triangle>& triangles, std::size_t numberOfVertices);
}

#endif
