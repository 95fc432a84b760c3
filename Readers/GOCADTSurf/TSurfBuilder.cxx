// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TSurfBuilder.h"

#include "Common/Survey/NullValue.h"
#include "Common/Text/LineErrors.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

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

constexpr std::array<std::string_view, 3> CoordinateNames = { "x", "y", "z" };
constexpr auto MostTSurfVertices = static_cast<std::size_t>(std::numeric_limits<PointId>::max());

/// Flags such as CNXYZ mark fixed coordinates of a vertex.
bool AtFlag(const LineTokens& line)
{
  return (line.Here()[0] == 'C' && line.Here()[1] == 'N') || (line.Here()[0] == 'c' && line.Here()[1] == 'n');
}
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

//----------------------------------------------------------------------------------------------------------------------
bool TSurfBuilder::TakeGeometry(std::string_view keyword, LineTokens& line, std::int64_t number)
{
  this->Line = number;
  this->Keyword = keyword;
  if (keyword == "TRGL")
  {
    this->TakeTriangle(line);
  }
  else if (keyword == "VRTX" || keyword == "PVRTX")
  {
    this->TakeVertex(line, keyword[0] == 'P');
  }
  else if (keyword == "ATOM" || keyword == "PATOM")
  {
    this->TakeAtom(line, keyword[0] == 'P');
  }
  else if (keyword == "TFACE")
  {
    this->StartPart();
  }
  else if (keyword == "BSTONE")
  {
    this->Surface.BorderStones.push_back(this->ReadVertex(line));
    this->RequireEnd(line);
  }
  else if (keyword == "BORDER")
  {
    this->TakeBorder(line);
  }
  else
  {
    return false;
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::TakeVertex(LineTokens& line, bool hasValues)
{
  this->AddVertex(this->ReadId(line));
  for (std::size_t n = 0; n < CoordinateNames.size(); ++n)
  {
    this->Surface.Vertices.back()[n] = this->ReadNumber(CoordinateNames[n], line, false);
  }
  if (hasValues || !(line.AtEnd() || AtFlag(line) || this->Surface.Properties.empty()))
  {
    this->ReadValues(line); // Some programs write values after VRTX, too.
  }
  this->SkipFlags(line);
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::TakeAtom(LineTokens& line, bool hasValues)
{
  this->AddVertex(this->ReadId(line));
  const auto vertex = static_cast<PointId>(this->Surface.Vertices.size() - 1);
  this->Atoms.push_back({ vertex, this->ReadId(line), this->Line, hasValues });
  if (hasValues)
  {
    this->ReadValues(line);
  }
  this->SkipFlags(line);
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::TakeTriangle(LineTokens& line)
{
  TSurf::Triangle& triangle = this->Surface.Triangles.emplace_back();
  for (PointId& vertex : triangle)
  {
    vertex = this->ReadVertex(line);
  }
  this->RequireEnd(line);
  if (this->Part > 0)
  {
    this->Surface.Parts.resize(this->Surface.Triangles.size(), this->Part);
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// The id of the border is not used.
void TSurfBuilder::TakeBorder(LineTokens& line)
{
  this->ReadId(line);
  const PointId first = this->ReadVertex(line);
  this->Surface.Borders.push_back({ first, this->ReadVertex(line) });
  this->RequireEnd(line);
}

//----------------------------------------------------------------------------------------------------------------------
/// Triangles have parts from the second TFACE on.
void TSurfBuilder::StartPart()
{
  ++this->Part;
  if (this->Part == 1)
  {
    this->Surface.Parts.assign(this->Surface.Triangles.size(), 0);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t TSurfBuilder::ReadId(LineTokens& line) const
{
  const std::string_view token = line.Next();
  std::int64_t id = -1;
  const char* const last = token.data() + token.size();
  const auto [end, error] = std::from_chars(token.data(), last, id);
  if (error != std::errc() || end != last || id < 0)
  {
    throw ErrorAt(this->Line, std::string(this->Keyword) + " id " + Quote(token) + ", expected an integer from 0 on");
  }
  return id;
}

//----------------------------------------------------------------------------------------------------------------------
PointId TSurfBuilder::ReadVertex(LineTokens& line) const
{
  const std::int64_t id = this->ReadId(line);
  const PointId vertex = this->Ids.Find(id);
  if (vertex == NoPoint)
  {
    throw ErrorAt(this->Line,
      std::string(this->Keyword) + " of vertex " + std::to_string(id) + ", expected the id of a vertex above");
  }
  return vertex;
}

//----------------------------------------------------------------------------------------------------------------------
double TSurfBuilder::ReadNumber(std::string_view what, LineTokens& line, bool mayBeNan) const
{
  double value = 0.0;
  if (const char* const plainEnd = ReadPlainNumber(line.Here(), value))
  {
    line.MoveTo(plainEnd);
    return value;
  }
  const std::string_view token = line.Next();
  const NumberKind kind = ReadAnyNumber(token, value);
  if (kind == NumberKind::NotANumber || (kind == NumberKind::NotFinite && !(mayBeNan && std::isnan(value))))
  {
    throw ErrorAt(this->Line,
      std::string(this->Keyword) + " value " + Quote(token) + " of " + Quote(what) +
        (kind == NumberKind::NotANumber ? ", expected a number" : ", expected a finite number"));
  }
  return value;
}

//----------------------------------------------------------------------------------------------------------------------
/// Reads the values of the last vertex; earlier vertices without values get nan.
void TSurfBuilder::ReadValues(LineTokens& line)
{
  const std::size_t vertex = this->Surface.Vertices.size() - 1;
  for (std::size_t n = 0; n < this->Surface.Properties.size(); ++n)
  {
    TSurfProperty& property = this->Surface.Properties[n];
    property.Values.resize(vertex * property.Size, NoValue);
    for (std::size_t component = 0; component < property.Size; ++component)
    {
      const double value = this->ReadNumber(property.Name, line, true);
      property.Values.push_back(IsNullValue(value, this->Nulls[n]) ? NoValue : value);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::AddVertex(std::int64_t id)
{
  if (this->Surface.Vertices.size() == MostTSurfVertices)
  {
    throw ErrorAt(this->Line, "more than " + std::to_string(MostTSurfVertices) + " vertices, expected fewer");
  }
  if (!this->Ids.Add(id))
  {
    throw ErrorAt(this->Line,
      std::string(this->Keyword) + " with the id " + std::to_string(id) + " of a vertex above, expected unique ids");
  }
  this->Surface.Vertices.emplace_back();
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::RequireEnd(LineTokens& line) const
{
  if (!line.AtEnd())
  {
    throw ErrorAt(
      this->Line, Quote(line.Next()) + " after " + std::string(this->Keyword) + ", expected the end of the line");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::SkipFlags(LineTokens& line) const
{
  while (AtFlag(line))
  {
    line.Next();
  }
  this->RequireEnd(line);
}

//----------------------------------------------------------------------------------------------------------------------
/// Drops properties without any value.
void TSurfBuilder::CompleteValues()
{
  std::vector<TSurfProperty>& properties = this->Surface.Properties;
  properties.erase(std::remove_if(properties.begin(), properties.end(),
                     [](const TSurfProperty& property) { return property.Values.empty(); }),
    properties.end());
  for (TSurfProperty& property : properties)
  {
    property.Values.resize(this->Surface.Vertices.size() * property.Size, NoValue);
  }
}

//----------------------------------------------------------------------------------------------------------------------
TSurf TSurfBuilder::Finish(TSurfHeader header)
{
  this->CompleteValues();
  this->Surface.Name = std::move(header.Name);
  this->Surface.Colour = header.Colour;
  PlaceAtoms(this->Atoms, this->Ids, this->Surface);
  return std::move(this->Surface);
}
}
