// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// IBM floats may be unnormalised: some programs write 0 with an exponent, or fractions with leading zeros.

#include "SEGYSamples.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>
#include <type_traits>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t SampleBufferSize = 256; // samples

struct FormatFacts
{
  SEGYFormat Format;
  std::size_t Size; // bytes of a sample
  const char* Name;
};

constexpr std::array<FormatFacts, 11> SampleFormats = { { { SEGYFormat::IbmFloat, 4, "IBM float" },
  { SEGYFormat::Integer32, 4, "32-bit integer" }, { SEGYFormat::Integer16, 2, "16-bit integer" },
  { SEGYFormat::IeeeFloat, 4, "IEEE float" }, { SEGYFormat::IeeeDouble, 8, "IEEE double" },
  { SEGYFormat::Integer24, 3, "24-bit integer" }, { SEGYFormat::Integer8, 1, "8-bit integer" },
  { SEGYFormat::Unsigned32, 4, "32-bit integer without sign" },
  { SEGYFormat::Unsigned16, 2, "16-bit integer without sign" },
  { SEGYFormat::Unsigned24, 3, "24-bit integer without sign" },
  { SEGYFormat::Unsigned8, 1, "8-bit integer without sign" } } };

const FormatFacts* FindFacts(int code)
{
  const auto* const facts = std::find_if(
    SampleFormats.begin(), SampleFormats.end(), [code](const FormatFacts& f) { return int(f.Format) == code; });
  return facts == SampleFormats.end() ? nullptr : facts;
}

template <std::size_t Size>
using BitsOf = std::conditional_t<Size == 8, std::uint64_t, std::uint32_t>;

template <std::size_t Size, ByteOrder Order>
BitsOf<Size> Load(const unsigned char* bytes)
{
  BitsOf<Size> number = 0;
  for (std::size_t n = 0; n < Size; ++n)
  {
    const std::size_t shift = 8 * (Order == ByteOrder::BigEndian ? Size - 1 - n : n);
    number |= BitsOf<Size>(bytes[n]) << shift;
  }
  return number;
}

template <typename To, typename From>
To CopyBits(From bits)
{
  static_assert(sizeof(To) == sizeof(From), "another size");
  To value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

/// The format has a sign, an exponent to the base 16 and a fraction of 24 bits; a double holds all values.
float FromIbm(std::uint32_t bits)
{
  constexpr int Bias = 4 * 64 + 24; // in powers of 2, with the fraction as an integer
  constexpr int DoubleBias = 1023;
  constexpr int DoubleDigits = 52;
  const auto exponent = std::uint64_t(4 * int(bits >> 24 & 0x7f) - Bias + DoubleBias);
  const double power = CopyBits<double>(exponent << DoubleDigits);
  const auto size = float(double(std::int32_t(bits & 0x00ffffff)) * power);
  return CopyBits<float>(CopyBits<std::uint32_t>(size) | (bits & 0x80000000));
}

template <std::size_t Size>
std::int32_t ExtendSign(std::uint32_t bits)
{
  constexpr int Unused = 32 - 8 * int(Size);
  return std::int32_t(bits << Unused) >> Unused;
}

template <std::size_t Size, ByteOrder Order, typename FromBits>
void Convert(const unsigned char* bytes, std::size_t samples, float* values, FromBits&& fromBits)
{
  // The buffer avoids aliasing of bytes and values, which would prevent vectorisation.
  std::array<BitsOf<Size>, SampleBufferSize> bits;
  for (std::size_t first = 0; first < samples; first += SampleBufferSize)
  {
    const std::size_t count = std::min(SampleBufferSize, samples - first);
    for (std::size_t n = 0; n < count; ++n)
    {
      bits[n] = Load<Size, Order>(bytes + Size * (first + n));
    }
    for (std::size_t n = 0; n < count; ++n)
    {
      values[first + n] = fromBits(bits[n]);
    }
  }
}

template <std::size_t Size, ByteOrder Order>
void ConvertSigned(const unsigned char* bytes, std::size_t samples, float* values)
{
  Convert<Size, Order>(bytes, samples, values, [](std::uint32_t bits) { return float(ExtendSign<Size>(bits)); });
}

template <std::size_t Size, ByteOrder Order>
void ConvertUnsigned(const unsigned char* bytes, std::size_t samples, float* values)
{
  Convert<Size, Order>(bytes, samples, values, [](std::uint32_t bits) { return float(bits); });
}

template <ByteOrder Order>
void ToFloatsOf(const unsigned char* bytes, std::size_t samples, SEGYFormat format, float* values)
{
  switch (format)
  {
    case SEGYFormat::IbmFloat:
      return Convert<4, Order>(bytes, samples, values, [](std::uint32_t bits) { return FromIbm(bits); });
    case SEGYFormat::IeeeFloat:
      return Convert<4, Order>(bytes, samples, values, [](std::uint32_t bits) { return CopyBits<float>(bits); });
    case SEGYFormat::IeeeDouble:
      return Convert<8, Order>(
        bytes, samples, values, [](std::uint64_t bits) { return float(CopyBits<double>(bits)); });
    case SEGYFormat::Integer32:
      return ConvertSigned<4, Order>(bytes, samples, values);
    case SEGYFormat::Integer24:
      return ConvertSigned<3, Order>(bytes, samples, values);
    case SEGYFormat::Integer16:
      return ConvertSigned<2, Order>(bytes, samples, values);
    case SEGYFormat::Integer8:
      return ConvertSigned<1, Order>(bytes, samples, values);
    case SEGYFormat::Unsigned32:
      return ConvertUnsigned<4, Order>(bytes, samples, values);
    case SEGYFormat::Unsigned24:
      return ConvertUnsigned<3, Order>(bytes, samples, values);
    case SEGYFormat::Unsigned16:
      return ConvertUnsigned<2, Order>(bytes, samples, values);
    case SEGYFormat::Unsigned8:
      return ConvertUnsigned<1, Order>(bytes, samples, values);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t SampleSize(int code)
{
  const FormatFacts* const facts = FindFacts(code);
  return facts ? facts->Size : 0;
}

//----------------------------------------------------------------------------------------------------------------------
const char* FormatName(SEGYFormat format)
{
  const FormatFacts* const facts = FindFacts(int(format));
  return facts ? facts->Name : "unknown";
}

//----------------------------------------------------------------------------------------------------------------------
void CheckFormatCode(int code, const char* place)
{
  if (SampleSize(code) == 0)
  {
    std::ostringstream text;
    text << "format code " << code << place
         << ", expected 1 (IBM float), 2, 3, 7, 8 (integers of 32, 16, 24, 8 bits), 5, 6 (IEEE float, double) or 10, "
            "11, 15, 16 (integers without a sign)";
    throw InputError(text.str());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ToFloats(const unsigned char* bytes, std::size_t samples, SEGYFormat format, ByteOrder order, float* values)
{
  if (order == ByteOrder::BigEndian)
  {
    ToFloatsOf<ByteOrder::BigEndian>(bytes, samples, format, values);
  }
  else
  {
    ToFloatsOf<ByteOrder::LittleEndian>(bytes, samples, format, values);
  }
}
}
