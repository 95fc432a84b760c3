// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsByteOrder_h
#define SeismicHorizonsByteOrder_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace SeismicHorizons
{
enum class ByteOrder
{
  BigEndian,
  LittleEndian
};

/// Numbers have 2, 4 or 8 bytes; Byte is a kind of char.
template <typename Number, typename Byte>
Number DecodeNumber(const Byte* bytes, ByteOrder order)
{
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t,
    std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint16_t>>;
  static_assert(sizeof(Number) == sizeof(Bits) && sizeof(Byte) == 1, "another size");
  Bits bits = 0;
  for (std::size_t n = 0; n < sizeof(Number); ++n)
  {
    const std::size_t byte = order == ByteOrder::BigEndian ? n : sizeof(Number) - 1 - n;
    bits = static_cast<Bits>((bits << 8) | static_cast<unsigned char>(bytes[byte]));
  }
  Number number;
  std::memcpy(&number, &bits, sizeof(Number));
  return number;
}
}

#endif
