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
/// A vertex that stands at the place of another one, which may come later in the file.
struct Atom
{
  PointId Vertex;
  std::int64_t PlaceId; // the id of the other one
  std::int64_t Line;
  bool HasValues; // of its own; else it has those of the other one
};

/// Gives atoms the places, and the values, of the vertices that they name, which may be atoms themselves. Linear.
/// Throws InputError where there is no such vertex, and where atoms name each other in a circle.
void PlaceAtoms(const std::vector<Atom>& atoms, const VertexIds& ids, TSurf& surface);
}

#endif
