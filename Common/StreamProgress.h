// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far reading of a stream has come.

#ifndef SeismicHorizonsStreamProgress_h
#define SeismicHorizonsStreamProgress_h

#include <istream>
#include <streambuf>

namespace SeismicHorizons
{
/// The buffer of a stream whose bytes are made from those of a file, so that their number is not known before the end.
class DecodingBuffer : public std::streambuf
{
public:
  /// Which part of the file was used, 0 to 1.
  virtual double PartRead() const = 0;
};

/// The bytes of a stream from where it is to its end, or 0 when it cannot tell.
double CountBytes(std::istream& stream);

/// Which part of a stream was read, 0 to 1, after so many of the bytes that CountBytes() gave. Always 0 when the stream
/// cannot tell its length, unless its bytes are decoded.
double PartRead(const std::istream& stream, double bytesRead, double bytesInStream);
}

#endif
