// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parses blocks of lines, which are independent, in parallel.

#ifndef SeismicHorizonsPickBlock_h
#define SeismicHorizonsPickBlock_h

#include "Common/Survey/PickTable.h"
#include "TextLayout.h"

#include <cstdint>
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
  std::int64_t FirstLine = -1; // The first that is neither empty nor a comment.
  std::int64_t CommentLine = -1; // The first comment in words that a pick follows.
  std::int64_t EndLine = -1; // The line of an end mark.
  std::int64_t ErrorLine = -1; // Later lines are not parsed.
  std::string Error;
};

inline constexpr const char* LinesAfterEnd = "more lines after the end mark, expected none";

std::string WithDecimalPoints(std::string_view text);

PickBlock ParsePicks(std::string_view lines, const TextLayout& layout);
}

#endif
