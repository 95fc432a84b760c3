// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What errors in a text file say.

#ifndef SeismicHorizonsLineErrors_h
#define SeismicHorizonsLineErrors_h

#include "FileErrors.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// Text of a file as it is fit for an error: clipped after 32 characters, with a question mark for each one that can
/// not be printed.
std::string Excerpt(std::string_view text);

/// The same in quotes.
std::string Quote(std::string_view text);

/// An error whose text begins with the number of the line, counted from 1: "line 17: ".
InputError ErrorAt(std::int64_t line, const std::string& text);

/// The same of a file that ends there, and should not.
FileError CutOffAt(std::int64_t line, const std::string& text);
}

#endif
