// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSEGYSamples_h
#define SeismicHorizonsSEGYSamples_h

#include "Common/Base/ByteOrder.h"

#include <cstddef>
#include <cstdint>

namespace SeismicHorizons
{
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

/// Returns 0 for unsupported codes, including 4 (fixed point with gain) and 64-bit integers.
std::size_t SampleSize(int code);

const char* FormatName(SEGYFormat format);

std::uint32_t ReadUnsigned(const unsigned char* bytes, std::size_t size, ByteOrder order); // `size` is 1 to 4.

/// Rounds 32-bit integers and doubles; doubles out of range become infinite or 0.
void ToFloats(const unsigned char* bytes, std::size_t samples, SEGYFormat format, ByteOrder order, float* values);
}

#endif
