// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The line with the names of columns, among titles, units and dashes above the picks.

#ifndef SeismicHorizonsNameLine_h
#define SeismicHorizonsNameLine_h

#include "TextLayout.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// The lines at the beginning of a file, without their ends.
using TextLines = std::vector<std::string_view>;

/// The names of columns in a line from `first` on, which is no comment; nothing where none has any. Adds to the layout
/// where picks begin, what of these lines may come again, and the unit of z.
std::optional<std::string> FindNameLine(const TextLines& lines, std::size_t first, TextLayout& layout);

/// With names of several words that are one, where blanks separate names: "Two Way Time".
std::string JoinWords(std::string_view names);

/// Names may have blanks in them where anything else separates them.
FieldSeparator SeparatorOfNames(std::string_view names);

/// Whether a field is a number, be it infinite or nan.
bool IsNumber(std::string_view field);
}

#endif
