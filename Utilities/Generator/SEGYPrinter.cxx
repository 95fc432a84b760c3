// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SEGYPrinter.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t TextSize = 3200;
constexpr std::size_t BinarySize = 400;
constexpr std::size_t TraceHeaderSize = 240;
constexpr int CoordinateScale = 100;

/// Bytes in which numbers are written big-endian; positions count from 1, as in the standard.
template <std::size_t Size>
class Header
{
public:
  void Put16(std::size_t position, std::int64_t value) { this->Put(position, value, 2); }
  void Put32(std::size_t position, std::int64_t value) { this->Put(position, value, 4); }
  const char* Data() const { return this->Bytes.data(); }

private:
  void Put(std::size_t position, std::int64_t value, std::size_t bytes)
  {
    for (std::size_t n = 0; n < bytes; ++n)
    {
      this->Bytes[position - 1 + n] = char(std::uint64_t(value) >> (8 * (bytes - 1 - n)) & 0xFFU);
    }
  }

  std::array<char, Size> Bytes = {};
};

/// The EBCDIC code of a letter, digit, blank or sign of punctuation that the text needs.
char ToEbcdic(char letter)
{
  static const std::string ascii =
    " .<(+|&!$*);-/,%_>?:#@'=\"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  static const std::string ebcdic =
    "\x40\x4B\x4C\x4D\x4E\x4F\x50\x5A\x5B\x5C\x5D\x5E\x60\x61\x6B\x6C\x6D\x6E\x6F\x7A\x7B\x7C\x7D\x7E\x7F"
    "\x81\x82\x83\x84\x85\x86\x87\x88\x89\x91\x92\x93\x94\x95\x96\x97\x98\x99\xA2\xA3\xA4\xA5\xA6\xA7\xA8\xA9"
    "\xC1\xC2\xC3\xC4\xC5\xC6\xC7\xC8\xC9\xD1\xD2\xD3\xD4\xD5\xD6\xD7\xD8\xD9\xE2\xE3\xE4\xE5\xE6\xE7\xE8\xE9"
    "\xF0\xF1\xF2\xF3\xF4\xF5\xF6\xF7\xF8\xF9";
  const std::size_t position = ascii.find(letter);
  return ebcdic[position == std::string::npos ? 0 : position];
}

/// 40 lines of 80 letters.
std::string MakeText(const CubeGeneratorOptions& options)
{
  const std::array<std::string, 5> lines = { "SYNTHETIC CUBE OF SEISMICHORIZONS, SEED " + std::to_string(options.Seed),
    "INLINE 189-192, CROSSLINE 193-196, X 181-184, Y 185-188, SCALAR -100 IN 71-72",
    std::to_string(options.Size[1]) + " INLINES, " + std::to_string(options.Size[0]) + " CROSSLINES, " +
      std::to_string(options.Size[2]) + " SAMPLES, IEEE FLOATS",
    "SEG Y REV1", "END TEXTUAL HEADER" };
  constexpr std::size_t width = 80;
  std::string text;
  for (std::size_t n = 0; n < TextSize / width; ++n)
  {
    const std::size_t line = n < 3 ? n : n == 38 ? 3 : n == 39 ? 4 : lines.size();
    std::string row = std::string(n < 9 ? "C " : "C") + std::to_string(n + 1) + " ";
    row += line < lines.size() ? lines[line] : "";
    row.resize(width, ' ');
    text += row;
  }
  for (char& letter : text)
  {
    letter = ToEbcdic(letter);
  }
  return text;
}

std::string ToBytes(const float* trace, int samples)
{
  std::string bytes;
  bytes.reserve(std::size_t(samples) * 4);
  for (int sample = 0; sample < samples; ++sample)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, trace + sample, sizeof(bits));
    for (const int shift : { 24, 16, 8, 0 })
    {
      bytes.push_back(char(bits >> shift & 0xFFU));
    }
  }
  return bytes;
}

Header<BinarySize> MakeBinaryHeader(const CubeGeneratorOptions& options)
{
  Header<BinarySize> header;
  header.Put32(1, 1); // job
  header.Put16(13, 1); // traces per ensemble
  header.Put16(17, std::lround(1000.0 * options.SampleInterval)); // microseconds
  header.Put16(21, options.Size[2]);
  header.Put16(25, 5); // IEEE floats
  header.Put16(29, 4); // horizontally stacked
  header.Put16(55, 1); // metres
  header.Put16(301, 0x0100); // revision 1
  header.Put16(303, 1); // all traces are as long
  return header;
}

Header<TraceHeaderSize> MakeTraceHeader(
  const CubeGeneratorOptions& options, const CubeSurvey& survey, int i, int j, int number, bool isDead)
{
  const auto [x, y] = survey.PlaceOf(i, j);
  Header<TraceHeaderSize> header;
  header.Put32(1, number);
  header.Put32(5, number);
  header.Put32(21, i + 1 + std::int64_t(j) * options.Size[0]); // ensemble
  header.Put32(25, 1);
  header.Put16(29, isDead ? 2 : 1);
  header.Put16(71, -CoordinateScale);
  header.Put16(89, 1); // length
  header.Put16(115, options.Size[2]);
  header.Put16(117, std::lround(1000.0 * options.SampleInterval));
  header.Put32(181, std::llround(x * CoordinateScale));
  header.Put32(185, std::llround(y * CoordinateScale));
  header.Put32(189, survey.FirstInline + j);
  header.Put32(193, survey.FirstCrossline + i);
  return header;
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteSEGY(
  const CubeGeneratorOptions& options, const std::vector<float>& traces, const CubeSurvey& survey, std::ostream& stream)
{
  const CubeReflectors reflectors(options);
  stream << MakeText(options);
  stream.write(MakeBinaryHeader(options).Data(), BinarySize);
  const auto [nX, nY, nZ] = options.Size;
  int number = 0;
  for (int j = 0; j < nY; ++j)
  {
    for (int i = 0; i < nX; ++i)
    {
      if (!reflectors.IsMissing(i, j))
      {
        const auto header = MakeTraceHeader(options, survey, i, j, ++number, reflectors.IsDead(i, j));
        stream.write(header.Data(), TraceHeaderSize);
        stream << ToBytes(traces.data() + (std::size_t(j) * std::size_t(nX) + std::size_t(i)) * std::size_t(nZ), nZ);
      }
    }
  }
  if (!stream.flush())
  {
    throw std::runtime_error("cannot be written");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WriteTruth(const CubeGenerator& cube, const CubeSurvey& survey, std::ostream& stream)
{
  const auto [nX, nY, nZ] = cube.Options().Size;
  const CubeReflectors& truth = cube.Truth();
  stream << "Horizon Inline Crossline X Y Z Sample Side\n";
  for (int n = 0; n < truth.Size(); ++n)
  {
    for (int j = 0; j < nY; ++j)
    {
      for (int i = 0; i < nX; ++i)
      {
        const double place = truth.Place(n, i, j);
        if (!(place == place) || truth.IsMissing(i, j))
        {
          continue;
        }
        const auto [x, y] = survey.PlaceOf(i, j);
        std::array<char, 160> line;
        std::snprintf(line.data(), line.size(), "%d %d %d %.2f %.2f %.4f %.4f %d\n", n + 1, survey.FirstInline + j,
          survey.FirstCrossline + i, x, y, place * cube.Options().SampleInterval, place,
          truth.FaultDistance(i, j, place) > 0.0 ? 1 : -1);
        stream << line.data();
      }
    }
  }
  if (!stream.flush())
  {
    throw std::runtime_error("cannot be written");
  }
}
}
