// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSEGYSamples_h
#define SeismicHorizonsSEGYSamples_h

#include "Common/Base/ByteOrder.h"

#include <cstddef>

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

/// Throws InputError for unsupported codes; `place` follows the code in the message.
void CheckFormatCode(int code, const char* place);

/// Rounds 32-bit integers and doubles; doubles out of range become infinite or 0.
void ToFloats(const unsigned char* bytes, std::size_t samples, SEGYFormat format, ByteOrder order, float* values);
}

#endif
