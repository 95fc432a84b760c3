// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a TSurf says of itself before its vertices come. All functions that take a line, which is given behind its
// keyword and with its number, throw InputError.

#ifndef SeismicHorizonsTSurfDescription_h
#define SeismicHorizonsTSurfDescription_h

#include "Common/Survey/TSurf.h"
#include "LineTokens.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// What the header of an object says that is used here: its name and the colour of its triangles.
struct TSurfHeader
{
  std::string Name;
  std::optional<std::array<double, 3>> Colour;

  /// Takes a line "key: value". Keys are free, and so are values: a colour that is none is passed over.
  void Take(std::string_view line);
};

/// The coordinate system and the properties.
class TSurfDescription
{
public:
  VerticalPositive Positive = VerticalPositive::Elevation;
  SurveyDescription Survey;
  std::vector<TSurfProperty> Properties; // without values
  std::vector<double> Nulls; // by property, the number that stands for no value; nan where there is none

  /// Each passes over what it does not know.
  void TakeOfCoordinates(std::string_view keyword, LineTokens& line, std::int64_t number);
  void TakeOfProperties(std::string_view keyword, LineTokens& line, std::int64_t number);

  /// Whether a line of that keyword says what vertices have.
  static bool IsOfProperties(std::string_view keyword);

private:
  void TakeNames(LineTokens& line);
  void TakeSize(std::string_view text, TSurfProperty& property) const;
  void RequireOneEach(std::string_view keyword, std::size_t found) const;

  std::int64_t Line = 0; // the line that is taken
};
}

#endif
