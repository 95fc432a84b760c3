// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a TSurf of the lines of its object in a file. All functions that take a line, which is given behind its keyword
// and with its number, throw InputError.

#ifndef SeismicHorizonsTSurfBuilder_h
#define SeismicHorizonsTSurfBuilder_h

#include "AtomPlaces.h"
#include "TSurfDescription.h"
#include "VertexIds.h"

#include <string_view>

namespace SeismicHorizons
{
class TSurfBuilder
{
public:
  /// Takes a line of vertices, triangles or borders; false when it is none.
  bool TakeGeometry(std::string_view keyword, LineTokens& line, std::int64_t number);

  /// Take a line of the coordinate system, and any other line. Each passes over what it does not know.
  void TakeOfCoordinates(std::string_view keyword, LineTokens& line, std::int64_t number);
  void TakeOfProperties(std::string_view keyword, LineTokens& line, std::int64_t number);

  /// The surface, after the last line of the object.
  TSurf Finish(TSurfHeader header);

private:
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
  TSurfDescription Description;
  VertexIds Ids;
  std::vector<Atom> Atoms;
  std::int64_t Line = 0; // the line that is taken
  std::string_view Keyword; // its first word
  std::int32_t Part = -1; // the TFACE that lines belong to
};
}

#endif
