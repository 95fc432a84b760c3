// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AtomPlaces.h"

#include "Common/Text/LineErrors.h"

#include <algorithm>
#include <string>

namespace SeismicHorizons
{
namespace
{
class AtomPlacer
{
public:
  AtomPlacer(const std::vector<Atom>& atoms, const VertexIds& ids, TSurf& surface)
    : Atoms(atoms)
    , Ids(ids)
    , Surface(surface)
    , AtomOfVertex(surface.Vertices.size(), None)
  {
    for (std::size_t atom = 0; atom < atoms.size(); ++atom)
    {
      this->AtomOfVertex[std::size_t(atoms[atom].Vertex)] = atom;
    }
  }

  /// Follows atoms to a vertex with a place, and copies the place to all of them.
  void Place(std::size_t atom)
  {
    std::vector<std::size_t> chain;
    while (atom != None)
    {
      chain.push_back(atom);
      if (chain.size() > this->Atoms.size())
      {
        throw ErrorAt(this->Atoms[chain.front()].Line,
          "an ATOM that refers to itself, expected the id of a vertex with coordinates");
      }
      atom = this->AtomOfVertex[this->PlaceOf(atom)];
    }
    for (auto next = chain.rbegin(); next != chain.rend(); ++next)
    {
      this->Copy(this->PlaceOf(*next), this->Atoms[*next]);
      this->AtomOfVertex[std::size_t(this->Atoms[*next].Vertex)] = None;
    }
  }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  std::size_t PlaceOf(std::size_t atom) const
  {
    const PointId place = this->Ids.Find(this->Atoms[atom].PlaceId);
    if (place == NoPoint)
    {
      throw ErrorAt(this->Atoms[atom].Line,
        "ATOM at vertex " + std::to_string(this->Atoms[atom].PlaceId) + ", expected the id of a vertex of the object");
    }
    return std::size_t(place);
  }

  void Copy(std::size_t from, const Atom& atom)
  {
    const auto to = std::size_t(atom.Vertex);
    this->Surface.Vertices[to] = this->Surface.Vertices[from];
    for (TSurfProperty& property : this->Surface.Properties)
    {
      if (!atom.HasValues)
      {
        const auto first = property.Values.begin() + std::ptrdiff_t(from * property.Size);
        std::copy_n(first, property.Size, property.Values.begin() + std::ptrdiff_t(to * property.Size));
      }
    }
  }

  const std::vector<Atom>& Atoms;
  const VertexIds& Ids;
  TSurf& Surface;
  std::vector<std::size_t> AtomOfVertex; // None for vertices that have a place.
};
}

//----------------------------------------------------------------------------------------------------------------------
void PlaceAtoms(const std::vector<Atom>& atoms, const VertexIds& ids, TSurf& surface)
{
  if (atoms.empty())
  {
    return;
  }
  AtomPlacer placer(atoms, ids, surface);
  for (std::size_t atom = 0; atom < atoms.size(); ++atom)
  {
    placer.Place(atom);
  }
}
}
