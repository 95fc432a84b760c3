// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What stands before the traces of a SEG-Y file: a text of 40 lines, 400 bytes of numbers, and perhaps more texts.

#ifndef SeismicHorizonsSEGYHeader_h
#define SeismicHorizonsSEGYHeader_h

#include "SEGYSamples.h"

#include <array>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
constexpr int SEGYTextSize = 3200; // bytes
constexpr int SEGYTraceHeaderSize = 240;

/// What the user says of a file, where it is wrong.
struct SEGYHeaderOptions
{
  int FormatCode = 0; // 0: that of the file
  int Samples = 0; // of a trace; 0: found
  bool IgnoreIncompleteTrace = false; // at the end of the file
};

struct SEGYHeader
{
  std::vector<std::string> Text; // 40 lines, without blanks at their ends
  bool IsEbcdic = false;
  ByteOrder Order = ByteOrder::BigEndian;
  SEGYFormat Format = SEGYFormat::IbmFloat;
  int Revision = 0;
  int Samples = 0; // of a trace
  bool HasOwnSamples = true; // false when their number is that of the first trace
  double Interval = 0.0; // milliseconds; 0 where the file has none
  std::string LengthUnit; // "m", "ft", or empty where the file does not say
  int ExtendedTexts = 0;
  std::int64_t FirstTrace = 0; // the byte where it begins
  std::int64_t Traces = 0;
  std::vector<std::string> Warnings; // what is wrong with it

  std::size_t DataSize() const { return std::size_t(this->Samples) * SampleSize(int(this->Format)); }
  std::size_t TraceSize() const { return SEGYTraceHeaderSize + this->DataSize(); }
};

/// Throws InputError where there is no such format; the place is named in the message.
void CheckFormatCode(int code, const char* place);

/// Reads the header of a file of that many bytes. Numbers of samples and of extended texts that the traces contradict
/// are replaced by theirs, with a warning. Throws InputError where it is none of a SEG-Y file, and where the file does
/// not hold whole traces.
SEGYHeader ReadSEGYHeader(std::istream& stream, std::int64_t fileSize, const SEGYHeaderOptions& options = {});

/// Whether a file begins as SEG-Y files do: with a format code there is, in either byte order, and with a number of
/// samples.
bool IsSEGY(std::istream& stream);
}

#endif
