// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parses some lines of picks. Blocks of lines do not depend on each other, so that several are parsed at a time.

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
/// What is in a block of lines.
struct PickBlock
{
  std::vector<std::vector<double>> Values; // for each column of the layout its numbers; nan where null
  std::vector<std::string> Names; // of horizons, in the order they come
  std::vector<int> Horizon; // of each pick the number of its name; empty where no column has names
  std::vector<PickLine> PickLines; // where picks are: lines from 0
  std::int64_t Lines = 0;
  std::int64_t FirstLine = -1; // the first that is neither empty nor a comment, from 0
  std::int64_t CommentLine = -1; // the first comment of words behind which a pick comes, from 0
  std::int64_t EndLine = -1; // that of an end mark, from 0
  std::int64_t ErrorLine = -1; // from 0; lines behind it are not parsed
  std::string Error; // what is wrong there
};

inline constexpr const char* LinesAfterEnd = "more lines after the end mark, expected none";

/// Text with points for the commas between digits.
std::string WithDecimalPoints(std::string_view text);

/// Parses complete lines: the last character is a newline.
PickBlock ParsePicks(std::string_view lines, const TextLayout& layout);
}

#endif
