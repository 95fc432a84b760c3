// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The bytes of SEG-Y files as numbers.

#ifndef SeismicHorizonsSEGYSamples_h
#define SeismicHorizonsSEGYSamples_h

#include <cstddef>
#include <cstdint>

namespace SeismicHorizons
{
/// How a sample is stored. The values are the codes of SEG-Y.
enum class SEGYFormat
{
  IbmFloat = 1,
  Integer32 = 2,
  Integer16 = 3,
  IeeeFloat = 5,
  IeeeDouble = 6,
  Integer24 = 7,
  Integer8 = 8,
  Unsigned32 = 10,
  Unsigned16 = 11,
  Unsigned24 = 15,
  Unsigned8 = 16
};

/// The bytes of a sample; 0 for a code that is none of these, among them 4 (fixed point with gain) and the integers of
/// 64 bits.
std::size_t SampleSize(int code);

/// A format for people: "IBM float".
const char* FormatName(SEGYFormat format);

/// Which byte of a number comes first.
enum class ByteOrder
{
  BigEndian,
  LittleEndian
};

/// Whole numbers at a place in memory.
std::uint32_t ReadUnsigned(const unsigned char* bytes, std::size_t size, ByteOrder order); // of 1 to 4 bytes
std::int32_t ReadInteger32(const unsigned char* bytes, ByteOrder order);
std::int32_t ReadInteger16(const unsigned char* bytes, ByteOrder order);
double ReadDouble(const unsigned char* bytes, ByteOrder order);

/// Turns samples into floats. Exact but for integers of 32 bits and doubles, which are rounded, and for numbers beyond
/// the range of a float, which become infinite or 0.
void ToFloats(const unsigned char* bytes, std::size_t samples, SEGYFormat format, ByteOrder order, float* values);
}

#endif
