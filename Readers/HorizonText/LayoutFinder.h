// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLayoutFinder_h
#define SeismicHorizonsLayoutFinder_h

#include "TextHeader.h"
#include "TextLayout.h"

#include <string>

namespace SeismicHorizons
{
/// Numbers for no value that several programs write. They do not apply to formats and files with a number of their own.
constexpr const char* DefaultNulls = "-999.25 -99999 9999900";

struct TextOptions
{
  std::string Columns; // See ParseColumnList; empty to detect the fields.
  std::string NullValues; // Added to the usual values, see NullValues.
  int HeaderLines = 0; // Skipped before any other header.

  bool operator==(const TextOptions& other) const
  {
    return this->Columns == other.Columns && this->NullValues == other.NullValues &&
      this->HeaderLines == other.HeaderLines;
  }
};

TextLayout FindTextLayout(const TextLines& lines, const TextOptions& options);
}

#endif
