// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsAtomPlaces_h
#define SeismicHorizonsAtomPlaces_h

#include "Common/Survey/TSurf.h"
#include "VertexIds.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A vertex at the place of another one, which may follow in the file.
struct Atom
{
  PointId Vertex;
  std::int64_t PlaceId; // id of the other vertex
  std::int64_t Line;
  bool HasValues; // Without own values the atom takes the other vertex's values.
};

/// Copies places and values of vertices, which may be atoms themselves, in linear time. Throws InputError for missing
/// vertices and cycles.
void PlaceAtoms(const std::vector<Atom>& atoms, const VertexIds& ids, TSurf& surface);
}

#endif
