// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFieldGuess_h
#define SeismicHorizonsFieldGuess_h

#include "TextHeader.h"
#include "TextLayout.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
using Fields = std::vector<std::string_view>;

/// The last field may be empty after a trailing separator.
bool HaveFields(const TextLines& sample, FieldSeparator separator, std::size_t least, std::size_t most);

/// Counts the fields of the first line, and further ones that are empty there, or end in a text, in other lines.
std::size_t CountFields(const TextLines& sample, FieldSeparator separator);

/// The first separator that splits all lines into the same number of fields, at least three; else into at least three;
/// else blanks.
FieldSeparator FindSeparator(const TextLines& sample);

/// Throws InputError if the commas may separate thousands.
bool HaveDecimalCommas(const TextLines& sample, std::int64_t firstLine, std::size_t fewestFields = 3);

struct ColumnValues
{
  bool AreText = false; // No value is a number, and some are not null.
  bool AreNames = false; // In each line a text other than a unit, or at most 20 different whole numbers.
  bool AreAllDifferent = false; // Ids of picks are all different.
  bool AreLines = true; // Whole numbers small enough for line numbers.
};

ColumnValues LookAt(const TextLines& sample, const TextLayout& layout, std::size_t column);

bool FollowLines(const TextLines& sample, const TextLayout& layout, std::size_t lines, std::size_t places);

/// An ignored field of text becomes the name.
void NameByText(TextLayout& layout, const TextLines& sample);

/// The order may be: a name if it is text; x y il xl, il xl x y, il xl or x y; z; attributes. Throws InputError if
/// coordinates would become z.
std::vector<TextColumn> GuessColumns(const TextLines& sample, const TextLayout& layout);

// ---- Doubts ------------------------------------------------------------------------------------------------------
// Fields without names are recognised by their values. Ambiguous fields are refused, since a wrong guess gives a wrong
// horizon.

/// Rows of a grid have many similar fields.
bool IsMatrix(const TextLines& sample, const TextLayout& layout);

/// Throws InputError, which says what to set, if guessed fields may be wrong: places in other fields, numbers that
/// touch or have decimal commas, line numbers that may be places, or a z that is constant or counts lines.
void RefuseDoubtfulColumns(const TextLines& sample, const TextLayout& layout);

std::string DoubtOfColumns(const TextLines& sample, const TextLayout& layout);
}

#endif
