// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parsers of lines of picks: blocks of rows, which are independent, in parallel, and IESX in order.

#ifndef SeismicHorizonsPickBlock_h
#define SeismicHorizonsPickBlock_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/PickTable.h"
#include "TextLayout.h"

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Lines count from 0; -1 means none.
struct PickBlock
{
  std::vector<std::vector<double>> Values; // Numbers per field of the layout; nan for null values.
  std::vector<std::string> Names;
  std::vector<int> Horizon; // Index of the name per pick; empty without a field of names.
  std::vector<double> Nulls; // z that usually mean that there is none, of picks.
  std::vector<PickLine> PickLines;
  std::int64_t Lines = 0;
  std::int64_t OtherLines = 0; // Left out by TextLayout::IsChosen.
  std::int64_t FirstLine = -1; // The first that is neither empty nor a comment.
  std::int64_t CommentLine = -1; // The first comment in words that a pick follows.
  std::int64_t EndLine = -1; // The line of an end mark.
  std::int64_t ErrorLine = -1; // Later lines are not parsed.
  std::string Error;
};

inline constexpr const char* LinesAfterEnd = "more lines after the end mark, expected none";

std::string WithDecimalPoints(std::string_view text);

PickBlock ParsePicks(std::string_view lines, const TextLayout& layout);

/// Reads all objects of type VSet from GOCAD's text format.
PickTable ReadVSets(std::istream& stream, const NullValues& nulls, const Monitor& monitor);

// ---- IESX --------------------------------------------------------------------------------------------------------
// IESX, also called GeoQuest: a line PROFILE with the name of a horizon, a line per pick with numbers at fixed
// positions, and EOD at the end. Newer versions of OpendTect write EOD before each pick but the first, and after each
// pick a line that starts with a tab and has z and the attribute with all digits.

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
