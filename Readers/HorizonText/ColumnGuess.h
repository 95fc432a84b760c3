// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the columns of a table hold, by their values.

#ifndef SeismicHorizonsColumnGuess_h
#define SeismicHorizonsColumnGuess_h

#include "TextHeader.h"
#include "TextLayout.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
using Fields = std::vector<std::string_view>;

Fields Split(std::string_view line, FieldSeparator separator);

/// Whether all lines have so many fields. The last one may be empty behind a separator at the end.
bool HaveFields(const TextLines& sample, FieldSeparator separator, std::size_t count);

/// How many fields lines have: those of the first, and one more that is empty there where others have it.
std::size_t CountFields(const TextLines& sample, FieldSeparator separator);

/// What the values of a column are like.
struct ColumnValues
{
  bool AreText = false; // none of them is a number, and some are not null
  bool AreNames = false; // texts that are no units, or a few whole numbers
  bool AreAllDifferent = false; // as ids of picks are
  bool AreLines = true; // whole, and as small as line numbers are
};

ColumnValues LookAt(const TextLines& sample, const TextLayout& layout, std::size_t column);

/// Whether two columns hold line numbers, and two others the places that belong to them.
bool FollowLines(const TextLines& sample, const TextLayout& layout, std::size_t lines, std::size_t places);

/// The first column of text that is left out has the names of horizons, where no other one has.
void NameByText(TextLayout& layout, const TextLines& sample);

/// Columns without names, by their values: a name first where it is text; x y il xl, il xl x y, il xl or x y; z, and
/// attributes. Throws InputError where coordinates would become z.
std::vector<TextColumn> GuessColumns(const TextLines& sample, const TextLayout& layout);
}

#endif
