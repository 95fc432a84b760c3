// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLayoutFinder_h
#define SeismicHorizonsLayoutFinder_h

#include "TextHeader.h"
#include "TextLayout.h"

#include <string>

namespace SeismicHorizons
{
/// What a user says about a file.
struct TextOptions
{
  std::string Columns; // what they hold, see ParseColumnList; empty to find out
  std::string NullValues; // besides those that are known, see NullValues
  int HeaderLines = 0; // that are left out whatever is in them, before what else may be a header

  bool operator==(const TextOptions& other) const
  {
    return this->Columns == other.Columns && this->NullValues == other.NullValues &&
      this->HeaderLines == other.HeaderLines;
  }
};

/// Finds out how a file is to be read, from its first lines. Throws InputError where it has no columns of picks.
TextLayout FindTextLayout(const TextLines& lines, const TextOptions& options);
}

#endif
