// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compressed data for tests.

#ifndef SeismicHorizonsGzip_h
#define SeismicHorizonsGzip_h

#include "Common/Text/GzipStream.h"

#include <zlib.h>

#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

namespace Gzip
{
/// What gzip makes of a text.
inline std::string Compress(const std::string& text)
{
  constexpr int gzipOnly = 16;
  constexpr int usualMemory = 8;
  z_stream stream = {};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS + gzipOnly, usualMemory, Z_DEFAULT_STRATEGY) !=
    Z_OK)
  {
    throw std::runtime_error("zlib cannot be used");
  }
  std::string compressed(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(compressed.data());
  stream.avail_out = static_cast<uInt>(compressed.size());
  deflate(&stream, Z_FINISH);
  compressed.resize(stream.total_out);
  deflateEnd(&stream);
  return compressed;
}

/// A stream of what compressed data were made from.
inline std::unique_ptr<std::istream> Open(const std::string& compressed)
{
  return std::make_unique<SeismicHorizons::GzipStream>(std::make_unique<std::istringstream>(compressed));
}
}

#endif
