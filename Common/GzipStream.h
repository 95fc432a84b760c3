// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGzipStream_h
#define SeismicHorizonsGzipStream_h

#include "StreamProgress.h"

#include <istream>
#include <memory>

namespace SeismicHorizons
{
/// Whether a stream continues with what gzip begins its files with. The stream stays where it is.
bool BeginsAsGzip(std::istream& stream);

/// A file that gzip compressed (RFC 1952), as a stream of what it was made from. Several files of gzip one after the
/// other are one, and zeros may follow the last, as tapes leave them. The stream goes forwards as others do, and back
/// by starting anew, so that a short look ahead costs nothing.
///
/// Throws FileError out of whatever reads it, with the number of the compressed byte from 0, when the data are cut off
/// or damaged, checksums included, or something else follows them. All that comes before the fault is read first, so
/// that only who reads to the end is told.
class GzipStream : public std::istream
{
public:
  /// Begins where `compressed` does.
  explicit GzipStream(std::unique_ptr<std::istream> compressed);

private:
  std::unique_ptr<DecodingBuffer> Buffer;
};
}

#endif
