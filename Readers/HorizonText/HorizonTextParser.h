// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads picks from text files; Documentation/HorizonText.md describes formats and messages.
//
// A few megabytes of the file are in memory at a time, and their blocks are parsed in parallel. Numbers are read
// independently of the locale and rounded correctly. Errors are InputError, with the number of the line: "line 17: ".

#ifndef SeismicHorizonsHorizonTextParser_h
#define SeismicHorizonsHorizonTextParser_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/PickTable.h"
#include "TextHeader.h"
#include "TextLayout.h"

#include <cstddef>
#include <istream>
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
  std::string Where; // See ChooseLines; empty to read all lines.

  bool operator==(const TextOptions& other) const
  {
    return this->Columns == other.Columns && this->NullValues == other.NullValues &&
      this->HeaderLines == other.HeaderLines && this->Where == other.Where;
  }
};

TextLayout FindTextLayout(const TextLines& lines, const TextOptions& options);

TextLayout ReadTextLayout(std::istream& stream, const TextOptions& options);

/// Rewinds the stream. Files of IESX and GOCAD give no picks.
PickTable ReadFirstPicks(std::istream& stream, const TextLayout& layout);

/// Sizes do not change the result.
struct TextPieces
{
  std::size_t Buffer = 8 * 1024 * 1024; // bytes in memory at a time
  std::size_t Block = 256 * 1024; // bytes per task
};

/// Progress is by bytes.
PickTable ReadPicks(std::istream& stream, const TextLayout& layout, const Monitor& monitor = Monitor(),
  const TextPieces& pieces = TextPieces());

// Programs that open files ask this of every file, so that tables and other formats must not be taken for picks.
/// Rewinds the stream. With an extension of picks, or none, ambiguous fields are accepted. Others need a recognised
/// format, or picks on a lattice without header or below complete names, in the first 256 kilobytes.
bool ArePicks(std::istream& stream, const std::string& extension);
}

#endif
