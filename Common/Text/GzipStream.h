// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGzipStream_h
#define SeismicHorizonsGzipStream_h

#include "StreamProgress.h"

#include <istream>
#include <memory>

namespace SeismicHorizons
{
bool BeginsAsGzip(std::istream& stream);

/// Decodes a gzip file (RFC 1952). Concatenated gzip files are one, and zeros may follow, as on tapes. Seeking
/// backwards restarts decoding, which is cheap near the start.
///
/// Throws FileError, with the offset of the compressed byte, if the data are truncated or damaged (including
/// checksums), or other data follow. All bytes before the fault are read first.
class GzipStream : public std::istream
{
public:
  explicit GzipStream(std::unique_ptr<std::istream> compressed);

private:
  std::unique_ptr<DecodingBuffer> Buffer;
};
}

#endif
