// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A binary grid. Errors start with the offset of the byte, from 0.

#ifndef SeismicHorizonsGridBytes_h
#define SeismicHorizonsGridBytes_h

#include "Common/Base/ByteOrder.h"
#include "Common/Base/Monitor.h"
#include "Common/Text/FileErrors.h"
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
class GridBytes
{
public:
  GridBytes(std::istream& stream, const Monitor& monitor, ByteOrder order);

  std::string Place() const { return "byte " + std::to_string(this->Position); }
  InputError Error(const std::string& text) const { return InputError(this->Place() + ": " + text); }

  void Read(char* bytes, std::size_t count, const std::string& name);
  void Skip(std::int64_t count, const std::string& name);

  template <typename Number>
  Number Read(const std::string& name)
  {
    std::array<char, sizeof(Number)> bytes;
    this->Read(bytes.data(), bytes.size(), name);
    return DecodeNumber<Number>(bytes.data(), this->Order);
  }

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

  /// Null values become nan.
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

  template <typename Number>
  std::vector<double> Values(std::int64_t count, const NullRule& isNull)
  {
    std::vector<double> values;
    values.reserve(this->Room(count, sizeof(Number)));
    this->ReadValues<Number>(count, isNull, values);
    return values;
  }

  /// Limits `count` values of `size` bytes by the length of the file.
  std::size_t Room(std::int64_t count, std::size_t size) const;

  void RequireEnd();

  /// Verifies the checksum of a compressed file.
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
  std::vector<char> Part;
};
}

#endif
