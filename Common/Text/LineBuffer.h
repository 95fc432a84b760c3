// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads a stream in pieces of whole lines. The next piece is read, and decompressed, on a thread of its own while one is
// parsed; an incomplete line at the end of a piece moves in front of the next one. Every line ends in a newline, which is
// added to the file if missing, so that parsers need no bounds checks.

#ifndef SeismicHorizonsLineBuffer_h
#define SeismicHorizonsLineBuffer_h

#include "Common/Base/RawVector.h"

#include <cstddef>
#include <cstdint>
#include <future>
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
  /// The stream must outlive the buffer, and nothing else may read it. A line longer than `size` enlarges the buffer.
  /// Read() throws InputError for a line of 2^26 bytes, which a few compressed bytes could produce.
  LineBuffer(std::istream& stream, std::size_t size);
  LineBuffer(const LineBuffer&) = delete;
  LineBuffer& operator=(const LineBuffer&) = delete;

  bool AtEnd() const { return this->Now.IsLast; }

  bool Read();

  const char* First() const { return this->Now.Bytes.data() + this->Now.First; }
  const char* Last() const { return this->First() + this->Complete; }

  /// Fraction of the stream, or 0 if its length is unknown.
  double PartRead() const { return this->Now.Part; }

private:
  struct Piece
  {
    RawVector<char> Bytes; // with room in front for an incomplete line, and behind for a newline
    std::size_t First = 0;
    std::size_t Size = 0;
    bool IsRead = true;
    bool IsLast = false;
    double Part = 0.0; // of the stream, with this piece
  };

  void ReadAhead();
  void ReadNext();
  void TakeNext();
  void MoveInFront(std::size_t rest);
  void Append(std::size_t rest);

  std::istream& Stream;
  const std::int64_t Start; // Bytes before the first one to read.
  const double BytesInStream;
  const std::size_t PieceSize;
  std::size_t BytesRead = 0; // with the next piece
  std::size_t Complete = 0; // bytes of complete lines
  Piece Now;
  Piece Next;
  std::future<void> Ahead; // Destroyed first, as this waits for the thread.
};
}

#endif
