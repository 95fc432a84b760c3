// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A grid as bytes. Errors begin with the number of the byte, counted from 0, as hex dumps do.

#ifndef SeismicHorizonsGridBytes_h
#define SeismicHorizonsGridBytes_h

#include "Common/FileErrors.h"
#include "Common/Monitor.h"
#include "GridLayout.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <istream>
#include <string>
#include <type_traits>
#include <vector>

namespace SeismicHorizons
{
enum class ByteOrder
{
  LittleEndian,
  BigEndian
};

/// The number that bytes of a file stand for, whatever the order of this machine.
template <typename Number>
Number DecodeNumber(const char* bytes, ByteOrder order)
{
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t,
    std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint16_t>>;
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

class GridBytes
{
public:
  /// Begins where the stream is.
  GridBytes(std::istream& stream, const Monitor& monitor, ByteOrder order);

  /// What comes next, as "byte 100".
  std::string Place() const { return "byte " + std::to_string(this->Position); }
  InputError Error(const std::string& text) const { return InputError(this->Place() + ": " + text); }

  /// Throws InputError with `name` at the end of the file.
  void Read(char* bytes, std::size_t count, const std::string& name);
  void Skip(std::int64_t count, const std::string& name);

  template <typename Number>
  Number Read(const std::string& name)
  {
    std::array<char, sizeof(Number)> bytes;
    this->Read(bytes.data(), bytes.size(), name);
    return DecodeNumber<Number>(bytes.data(), this->Order);
  }

  /// The same for a finite number.
  template <typename Number>
  double ReadFinite(const std::string& name)
  {
    const std::string place = this->Place();
    const double number = this->Read<Number>(name);
    if (!std::isfinite(number))
    {
      throw InputError(place + ": " + name + " is not finite, expected a finite number");
    }
    return number;
  }

  /// The same for a positive integer.
  template <typename Number>
  int ReadCount(const std::string& name)
  {
    const std::string place = this->Place();
    const Number count = this->Read<Number>(name);
    if (count <= 0)
    {
      throw InputError(place + ": " + name + ' ' + std::to_string(count) + ", expected a positive integer");
    }
    return count;
  }

  /// Appends `count` values, nan where there is none.
  template <typename Number>
  void ReadValues(std::int64_t count, const NullRule& isNull, std::vector<double>& values)
  {
    while (count > 0)
    {
      const std::int64_t part = std::min<std::int64_t>(count, MostBytesAtOnce / sizeof(Number));
      const std::int64_t first = this->Position;
      const char* bytes = this->ReadPart(static_cast<std::size_t>(part) * sizeof(Number));
      for (std::int64_t n = 0; n < part; ++n, bytes += sizeof(Number))
      {
        values.push_back(this->CheckedValue(
          DecodeNumber<Number>(bytes, this->Order), isNull, first + n * std::int64_t(sizeof(Number))));
      }
      count -= part;
    }
  }

  /// How many values of `size` bytes to make room for when a file claims `count`: never more than its length allows.
  std::size_t Room(std::int64_t count, std::size_t size) const;

  /// Throws InputError when there is anything more.
  void RequireEnd();

  /// Reads what is no part of the grid: a compressed file is checked where it ends.
  void ReadRest();

private:
  static constexpr std::int64_t MostBytesAtOnce = 256 * 1024;

  const char* ReadPart(std::size_t count);
  static double CheckedValue(double z, const NullRule& isNull, std::int64_t place)
  {
    if (isNull(z))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    if (std::isinf(z))
    {
      throw InputError("byte " + std::to_string(place) + ": an infinite value, expected a finite number");
    }
    return z;
  }

  std::istream& Stream;
  const Monitor& Work;
  const ByteOrder Order;
  const double BytesInStream;
  std::int64_t Position = 0;
  std::vector<char> Part; // of the values
};
}

#endif
