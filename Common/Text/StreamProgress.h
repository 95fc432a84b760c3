// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsStreamProgress_h
#define SeismicHorizonsStreamProgress_h

#include <istream>
#include <streambuf>

namespace SeismicHorizons
{
/// For streams that decode a file, so that their length is unknown.
class DecodingBuffer : public std::streambuf
{
public:
  virtual double PartRead() const = 0;
};

/// Returns 0 for unknown lengths.
double CountBytes(std::istream& stream);

/// Fraction of a stream, or 0 for unknown lengths, except for decoding buffers.
double PartRead(const std::istream& stream, double bytesRead, double bytesInStream);
}

#endif
