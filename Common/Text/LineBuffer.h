// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An incomplete line at the end of a piece moves to the front of the buffer before more is read. Every line ends in a
// newline, which is added to the file if missing, so that parsers need no bounds checks.

#ifndef SeismicHorizonsLineBuffer_h
#define SeismicHorizonsLineBuffer_h

#include "Common/Base/RawVector.h"

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
std::vector<std::string_view> CutLines(std::string_view lines, std::size_t size);

std::int64_t CountLines(std::string_view text);

class LineBuffer
{
public:
  /// The stream must outlive the buffer. A line longer than `size` enlarges the buffer. Read() throws InputError for a
  /// line of 2^26 bytes, which a few compressed bytes could produce.
  LineBuffer(std::istream& stream, std::size_t size);

  bool AtEnd() const { return this->Stream.eof(); }

  bool Read();

  const char* First() const { return this->Bytes.data(); }
  const char* Last() const { return this->Bytes.data() + this->Complete; }

  /// Fraction of the stream, or 0 if its length is unknown.
  double PartRead() const;

private:
  bool ReadMore();

  std::istream& Stream;
  const std::int64_t Start; // Bytes before the first one to read.
  const double BytesInStream;
  std::size_t BytesRead = 0;
  RawVector<char> Bytes;
  std::size_t Filled = 0; // bytes in use
  std::size_t Complete = 0; // bytes of complete lines
};
}

#endif
