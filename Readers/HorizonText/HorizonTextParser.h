// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads picks of horizons from text files: Documentation/HorizonTextReader.md has the formats and all messages.
//
// Some megabytes of a file are in memory at a time, beside the result, and blocks of them are parsed on all threads.
// Numbers are read independently of the locale and rounded correctly. A file that breaks its format gives an
// InputError whose text starts with the number of the line, as "line 17: ".

#ifndef SeismicHorizonsHorizonTextParser_h
#define SeismicHorizonsHorizonTextParser_h

#include "Common/Monitor.h"
#include "Common/Survey/PickTable.h"
#include "LayoutFinder.h"

#include <istream>

namespace SeismicHorizons
{
/// Looks at the beginning of a file, and goes back there.
TextLayout ReadTextLayout(std::istream& stream, const TextOptions& options);

/// The picks of the beginning of a file, to which it goes back; none of IESX, which are only looked at. Throws
/// InputError where they are not as its layout says.
PickTable ReadFirstPicks(std::istream& stream, const TextLayout& layout);

/// How a file is cut into pieces. They do not matter for what is read.
struct TextPieces
{
  std::size_t Buffer = 8 * 1024 * 1024; // bytes in memory at a time
  std::size_t Block = 256 * 1024; // bytes that a thread parses at a time
};

/// Reads the picks of a file with its layout, from the beginning. Progress is by bytes.
PickTable ReadPicks(std::istream& stream, const TextLayout& layout, const Monitor& monitor = Monitor(),
  const TextPieces& pieces = TextPieces());
}

#endif
