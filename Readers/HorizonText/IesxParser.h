// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// IESX, also called GeoQuest: a line PROFILE with the name of a horizon, a line per pick with numbers at fixed
// positions, and EOD at the end. Newer versions of OpendTect write EOD before each pick but the first, and after each
// pick a line that starts with a tab and has z and the attribute with all digits.

#ifndef SeismicHorizonsIesxParser_h
#define SeismicHorizonsIesxParser_h

#include "Common/Survey/PickTable.h"
#include "TextLayout.h"

#include <cstdint>
#include <string_view>

namespace SeismicHorizons
{
class IesxParser
{
public:
  explicit IesxParser(const TextLayout& layout)
    : Nulls(layout.Nulls)
    , Line(layout.HeaderLines)
  {
  }

  /// Lines must be complete.
  void Parse(std::string_view lines);

  /// An attribute without values is dropped. Throws InputError if the file ended too early.
  PickTable Take();

private:
  void ParseLine(std::string_view line);
  void ParseProfile(std::string_view line);
  void ParsePick(std::string_view line);
  void ParseDigits(std::string_view line);
  double Number(std::string_view line, std::size_t first, std::size_t last, const char* name) const;
  double OrNull(double value) const;

  const NullValues& Nulls;
  PickTable Table;
  std::vector<double> Amplitudes;
  std::int64_t Line;
  int Profile = -1;
  bool HasEnded = false;
};
}

#endif
