// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLineErrors_h
#define SeismicHorizonsLineErrors_h

#include "FileErrors.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// Text is limited to 32 characters; question marks replace control characters.
std::string Excerpt(std::string_view text);

std::string Quote(std::string_view text);

InputError ErrorAt(std::int64_t line, const std::string& text);

FileError CutOffAt(std::int64_t line, const std::string& text);
}

#endif
