// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hands out a text file as pieces of complete lines. What is left behind the last complete line of a piece, the start
// of a line, is moved to the front of the buffer before more is read behind it.
//
// Every line ends in a newline, also the last one, which gets one when the file lacks it. So a parser can stop at
// newlines, and need not compare every character's place with the end of the piece.

#ifndef SeismicHorizonsLineBuffer_h
#define SeismicHorizonsLineBuffer_h

#include "RawVector.h"

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Cuts lines, each of which ends in a newline, into blocks of at least `size` characters, but for the last.
std::vector<std::string_view> CutLines(std::string_view lines, std::size_t size);

/// How many newlines there are.
std::int64_t CountLines(std::string_view text);

class LineBuffer
{
public:
  /// Begins where the stream is, which must outlive the buffer. `size` is how many bytes are held at a time; a longer
  /// line makes the buffer grow, to the size of the file at most: of a few compressed bytes, one line can be made that
  /// takes all memory. Read() throws InputError for one of 2^26 bytes.
  LineBuffer(std::istream& stream, std::size_t size);

  bool AtEnd() const { return this->Stream.eof(); }

  /// Moves on to the next lines, unless at the end. False when reading failed.
  bool Read();

  /// The complete lines that were read last.
  const char* First() const { return this->Bytes.data(); }
  const char* Last() const { return this->Bytes.data() + this->Complete; }

  /// Which part of the stream was read, 0 to 1. Always 0 when the stream cannot tell (StreamProgress.h).
  double PartRead() const;

private:
  bool ReadMore();

  std::istream& Stream;
  const std::int64_t Start; // bytes before what is read
  const double BytesInStream;
  std::size_t BytesRead = 0;
  RawVector<char> Bytes; // of a small file, few of them are ever touched
  std::size_t Filled = 0; // bytes in use
  std::size_t Complete = 0; // of these, bytes of complete lines
};
}

#endif
