// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextHeader_h
#define SeismicHorizonsTextHeader_h

#include "TextLayout.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
using TextLines = std::vector<std::string_view>;

/// The last line may lack its end.
TextLines SplitLines(std::string_view text);

/// Columns is empty without names. HeaderLines is the index of the first line after the header, which begins after the
/// lines to skip.
TextLayout ReadTextHeader(const TextLines& lines, int skippedLines);

// ---- Line of names -----------------------------------------------------------------------------------------------
/// Finds the names of fields among titles, units and dashes above the picks. Adds to the layout where picks begin, which header lines may be repeated, and the unit of z.
std::optional<std::string> FindNameLine(const TextLines& lines, std::size_t first, TextLayout& layout);

/// Joins words that form one name, such as "Two Way Time".
std::string JoinWords(std::string_view names);

FieldSeparator SeparatorOfNames(std::string_view names);
}

#endif
