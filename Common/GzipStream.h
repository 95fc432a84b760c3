// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that gzip compressed, as streams of what they were made from. They go forwards as other streams do, and back by
// starting anew, so that a short look ahead costs nothing.

#ifndef SeismicHorizonsGzipStream_h
#define SeismicHorizonsGzipStream_h

#include "GzipDecoder.h"
#include "StreamProgress.h"

#include <cstddef>
#include <future>
#include <istream>
#include <memory>
#include <vector>

namespace SeismicHorizons
{
/// Decodes block by block, and the next block on a thread of its own while the one at hand is read. Two blocks of some
/// megabytes are in memory.
class GzipBuffer : public DecodingBuffer
{
public:
  explicit GzipBuffer(std::unique_ptr<std::istream> compressed);

  double PartRead() const override { return this->Current.PartRead; }

protected:
  int_type underflow() override;
  pos_type seekoff(off_type offset, std::ios_base::seekdir way, std::ios_base::openmode which) override;
  pos_type seekpos(pos_type position, std::ios_base::openmode which) override;

private:
  struct Block
  {
    std::vector<char> Bytes;
    std::size_t Count = 0; // of the bytes that are in use
    double PartRead = 0.0; // of the file, with this block
  };

  Block Decode(std::vector<char> bytes, std::size_t size);
  void DecodeAhead(std::vector<char> bytes);
  void Rewind();

  GzipDecoder Decoder;
  Block Current;
  off_type BytesBefore = 0; // the block at hand
  std::future<Block> Next; // uses the decoder, and waits when it is destroyed: before the decoder
};

/// Throws InputError out of whatever reads it when something is wrong with the compressed data.
class GzipStream : public std::istream
{
public:
  /// Begins where `compressed` does.
  explicit GzipStream(std::unique_ptr<std::istream> compressed);

private:
  GzipBuffer Buffer;
};
}

#endif
