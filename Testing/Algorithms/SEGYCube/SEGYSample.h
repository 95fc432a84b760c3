// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes SEG-Y files of every kind, whose samples tell where they belong.

#ifndef SeismicHorizonsSEGYSample_h
#define SeismicHorizonsSEGYSample_h

#include "Readers/SEGYCube/SEGYSamples.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace SEGYSample
{
using namespace SeismicHorizons;

class Bytes
{
public:
  Bytes(std::size_t size, ByteOrder order)
    : Text(size, '\0')
    , Order(order)
  {
  }

  /// Writes a whole number of some bytes from a byte on, counted from 1.
  void Put(int byte, int size, std::int64_t number)
  {
    for (int n = 0; n < size; ++n)
    {
      const int shift = 8 * (this->Order == ByteOrder::BigEndian ? size - 1 - n : n);
      this->Text[std::size_t(byte - 1 + n)] = char(std::uint64_t(number) >> shift & 0xff);
    }
  }

  std::string Text;

private:
  const ByteOrder Order;
};

/// A trace, by what its header says.
struct Trace
{
  int Inline = 0;
  int Crossline = 0;
  int Kind = 1;
  int Delay = 0; // ms
  int Offset = 0;
  int Samples = -1; // in its header; -1: what the file has
  bool IsZero = false;
  int Extra = 0; // added to its samples
};

/// A file. Without changes a cube of 3 inlines (10, 12, 14) and 4 crosslines (100, 101, 102, 103) of 5 samples.
struct File
{
  SEGYFormat Format = SEGYFormat::IbmFloat;
  ByteOrder Order = ByteOrder::BigEndian;
  int Samples = 5;
  int SamplesInHeader = -1; // -1: Samples
  int Interval = 4000; // microseconds, in the header
  int TraceInterval = 0; // in the headers of traces
  int Revision = 1;
  int ExtendedTexts = 0;
  int ExtendedTextsInHeader = 0;
  int Unit = 1;
  bool IsEbcdic = true;
  int InlineByte = 189, CrosslineByte = 193, XByte = 181, YByte = 185;
  int PlaceScalar = -100;
  std::vector<Trace> Traces;
  // World x and y of lines, as stored: with the scalar applied.
  std::function<double(const Trace&)> X = [](const Trace& t) { return 500000.0 + 25.0 * (t.Crossline - 100); };
  std::function<double(const Trace&)> Y = [](const Trace& t) { return 6000000.0 + 50.0 * (t.Inline - 10); };
  std::function<void(const Trace&, Bytes&)> Change; // of the header of a trace, by whatever else is in it

  File()
  {
    for (const int inlineNumber : { 10, 12, 14 })
    {
      for (const int crossline : { 100, 101, 102, 103 })
      {
        this->Traces.push_back({ inlineNumber, crossline });
      }
    }
  }
};

/// 300 traces on 10 inlines and 30 crosslines, so that a few that are wrong do not count.
inline File LargeFile()
{
  File file;
  file.Traces.clear();
  for (int n = 0; n < 300; ++n)
  {
    file.Traces.push_back({ 10 + n / 30, 100 + n % 30 });
  }
  file.X = [](const Trace& t) { return 500000.0 + 12.5 * (t.Crossline - 100); };
  file.Y = [](const Trace& t) { return 6000000.0 + 25.0 * (t.Inline - 10); };
  return file;
}

/// The sample of a trace: whole, between 1 and 127, and different for neighbours.
inline int Value(int inlineNumber, int crossline, int sample)
{
  return 1 + (7 * inlineNumber + 31 * crossline + 3 * sample + inlineNumber * crossline) % 127;
}

/// The bits of a float of IBM that is nearest to a number, or of a whole number or float of IEEE.
inline std::int64_t Bits(double value, SEGYFormat format)
{
  if (format == SEGYFormat::IeeeFloat)
  {
    const float single = float(value);
    std::int32_t bits;
    std::memcpy(&bits, &single, 4);
    return bits;
  }
  if (format == SEGYFormat::IeeeDouble)
  {
    std::int64_t bits;
    std::memcpy(&bits, &value, 8);
    return bits;
  }
  if (format != SEGYFormat::IbmFloat)
  {
    return std::int64_t(value);
  }
  if (value == 0.0)
  {
    return 0;
  }
  int exponent = 0;
  double fraction = std::abs(value);
  for (; fraction >= 1.0; fraction /= 16.0)
  {
    ++exponent;
  }
  for (; fraction < 1.0 / 16.0; fraction *= 16.0)
  {
    --exponent;
  }
  const auto digits = std::int64_t(std::llround(fraction * (1 << 24)));
  return (value < 0.0 ? std::int64_t(1) << 31 : 0) | std::int64_t(64 + exponent) << 24 | digits;
}

/// A text in letters of EBCDIC or ASCII: blanks, capitals and digits.
inline std::string Encode(std::string text, bool isEbcdic)
{
  for (char& c : text)
  {
    const int letter = c - 'A';
    const int code = c == ' ' ? 0x40
      : c >= '0' && c <= '9'  ? 0xf0 + (c - '0')
      : letter < 9            ? 0xc1 + letter
      : letter < 18           ? 0xd1 + letter - 9
                              : 0xe2 + letter - 18;
    c = isEbcdic ? char(code) : c;
  }
  return text;
}

inline std::string MakeText(const File& file)
{
  std::string text;
  for (int line = 1; line <= 40; ++line)
  {
    std::string words = "C" + std::to_string(line) + " LINE OF TEXT";
    words.resize(80, ' ');
    text += words;
  }
  return Encode(text, file.IsEbcdic);
}

inline std::string MakeHeader(const File& file)
{
  Bytes header(400, file.Order);
  header.Put(17, 2, file.Interval);
  header.Put(21, 2, file.SamplesInHeader < 0 ? file.Samples : file.SamplesInHeader);
  header.Put(25, 2, int(file.Format));
  header.Put(29, 2, 4);
  header.Put(55, 2, file.Unit);
  header.Put(301, 1, file.Revision);
  header.Put(305, 2, file.ExtendedTextsInHeader != 0 ? file.ExtendedTextsInHeader : file.ExtendedTexts);
  return header.Text;
}

/// The bytes of a sample.
inline int SizeOf(SEGYFormat format)
{
  switch (format)
  {
    case SEGYFormat::IeeeDouble:
      return 8;
    case SEGYFormat::Integer24:
    case SEGYFormat::Unsigned24:
      return 3;
    case SEGYFormat::Integer16:
    case SEGYFormat::Unsigned16:
      return 2;
    case SEGYFormat::Integer8:
    case SEGYFormat::Unsigned8:
      return 1;
    default:
      return 4;
  }
}

inline std::string MakeTrace(const File& file, const Trace& trace, int number)
{
  Bytes header(240, file.Order);
  const auto stored = [&file](double place)
  {
    const int scalar = file.PlaceScalar;
    return std::llround(scalar < 0 ? place * -scalar : scalar > 0 ? place / scalar : place);
  };
  header.Put(1, 4, number);
  header.Put(29, 2, trace.Kind);
  header.Put(37, 4, trace.Offset);
  header.Put(71, 2, file.PlaceScalar);
  header.Put(109, 2, trace.Delay);
  header.Put(115, 2, trace.Samples < 0 ? file.Samples : trace.Samples);
  header.Put(117, 2, file.TraceInterval);
  header.Put(file.XByte, 4, stored(file.X(trace)));
  header.Put(file.YByte, 4, stored(file.Y(trace)));
  header.Put(file.InlineByte, 4, trace.Inline);
  header.Put(file.CrosslineByte, 4, trace.Crossline);
  if (file.Change)
  {
    file.Change(trace, header);
  }
  const int size = SizeOf(file.Format);
  Bytes samples(std::size_t(size * file.Samples), file.Order);
  for (int sample = 0; sample < file.Samples; ++sample)
  {
    const double value = trace.IsZero ? 0.0 : Value(trace.Inline, trace.Crossline, sample) + trace.Extra;
    samples.Put(1 + size * sample, size, Bits(value, file.Format));
  }
  return header.Text + samples.Text;
}

inline std::string Make(const File& file)
{
  std::string bytes = MakeText(file) + MakeHeader(file);
  for (int text = 1; text <= file.ExtendedTexts; ++text)
  {
    const bool isLast = text == file.ExtendedTexts;
    std::string words = isLast && !file.IsEbcdic ? "((SEG: EndText))" : "MORE TEXT";
    words.resize(3200, ' ');
    bytes += isLast && !file.IsEbcdic ? words : Encode(words, file.IsEbcdic);
  }
  int number = 0;
  for (const Trace& trace : file.Traces)
  {
    bytes += MakeTrace(file, trace, ++number);
  }
  return bytes;
}
}

#endif
