// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Collects the description of a TSurf before its vertices. Lines are passed after their keyword; functions throw
// InputError with the number of the line.

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
struct TSurfHeader
{
  std::string Name;
  std::optional<std::array<double, 3>> Colour;

  /// Takes "key: value"; unknown keys and invalid colours are ignored.
  void Take(std::string_view line);
};

class TSurfDescription
{
public:
  VerticalPositive Positive = VerticalPositive::Elevation;
  bool HasPositive = false; // the file states it
  SurveyDescription Survey;
  std::vector<TSurfProperty> Properties;
  std::vector<double> Nulls; // Null value per property, or nan.

  /// Unknown lines are ignored.
  void TakeOfCoordinates(std::string_view keyword, LineTokens& line, std::int64_t number);
  void TakeOfProperties(std::string_view keyword, LineTokens& line, std::int64_t number);

  static bool IsOfProperties(std::string_view keyword);

private:
  void TakeNames(LineTokens& line);
  void TakeSize(std::string_view text, TSurfProperty& property) const;
  void RequireOneEach(std::string_view keyword, std::size_t found) const;

  std::int64_t Line = 0;
};
}

#endif
