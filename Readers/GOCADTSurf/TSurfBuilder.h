// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a TSurf from the lines of its object, which are passed after their keyword. Functions throw InputError with the
// number of the line.

#ifndef SeismicHorizonsTSurfBuilder_h
#define SeismicHorizonsTSurfBuilder_h

#include "Common/Survey/TSurf.h"
#include "LineTokens.h"
#include "VertexIds.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
struct TSurfHeader
{
  std::string Name;
  std::optional<std::array<double, 3>> Colour;

  /// Takes "key: value"; unknown keys and invalid colours are ignored.
  void Take(std::string_view line);
};

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

class TSurfBuilder
{
public:
  /// Returns false unless the line is a vertex, triangle or border.
  bool TakeGeometry(std::string_view keyword, LineTokens& line, std::int64_t number);

  /// Unknown lines are ignored.
  void TakeOfCoordinates(std::string_view keyword, LineTokens& line, std::int64_t number);
  void TakeOfProperties(std::string_view keyword, LineTokens& line, std::int64_t number);

  TSurf Finish(TSurfHeader header);

private:
  void TakeNames(LineTokens& line);
  void TakeSize(std::string_view text, TSurfProperty& property) const;
  void RequireOneEach(std::string_view keyword, std::size_t found) const;
  void TakeVertex(LineTokens& line, bool hasValues);
  void TakeAtom(LineTokens& line, bool hasValues);
  void TakeTriangle(LineTokens& line);
  void TakeBorder(LineTokens& line);
  void StartPart();

  std::int64_t ReadId(LineTokens& line) const;
  PointId ReadVertex(LineTokens& line) const;
  double ReadNumber(std::string_view what, LineTokens& line, bool mayBeNan) const;
  void ReadValues(LineTokens& line);
  void AddVertex(std::int64_t id);
  void RequireEnd(LineTokens& line) const;
  void SkipFlags(LineTokens& line) const;
  void CompleteValues();

  TSurf Surface;
  std::vector<double> Nulls; // Null value per property, or nan.
  VertexIds Ids;
  std::vector<Atom> Atoms;
  std::int64_t Line = 0;
  std::string_view Keyword;
  std::int32_t Part = -1; // current TFACE; -1 before the first
};
}

#endif
