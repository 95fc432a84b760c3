// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads picks from text files; Documentation/HorizonTextReader.md describes formats and messages.
//
// A few megabytes of the file are in memory at a time, and their blocks are parsed in parallel. Numbers are read
// independently of the locale and rounded correctly. Errors are InputError, with the number of the line: "line 17: ".

#ifndef SeismicHorizonsHorizonTextParser_h
#define SeismicHorizonsHorizonTextParser_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/PickTable.h"
#include "LayoutFinder.h"

#include <istream>

namespace SeismicHorizons
{
TextLayout ReadTextLayout(std::istream& stream, const TextOptions& options);

/// Rewinds the stream. IESX files give no picks.
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
}

#endif
