// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The header of a SEG-Y file: a text of 40 lines, 400 binary bytes, and optional extended texts.

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
constexpr int SEGYFileHeaderSize = SEGYTextSize + 400; // bytes
constexpr int SEGYTraceHeaderSize = 240; // bytes

/// First bytes of two fields of trace headers, from 1.
struct FieldPair
{
  int First = 0;
  int Second = 0;
};

constexpr int NoField = -1;

struct SEGYHeaderOptions
{
  int FormatCode = 0; // 0 uses the file's code.
  int Samples = 0; // Samples per trace; 0 detects them.
  bool IgnoreIncompleteTrace = false;
};

struct SEGYHeader
{
  std::vector<std::string> Text;
  bool IsEbcdic = false;
  ByteOrder Order = ByteOrder::BigEndian;
  SEGYFormat Format = SEGYFormat::IbmFloat;
  int Revision = 0;
  int Samples = 0;
  bool HasOwnSamples = true; // False if the number comes from the first trace.
  double Interval = 0.0; // Milliseconds; 0 if not stated.
  std::string LengthUnit; // "m", "ft", or empty if not stated.
  int ExtendedTexts = 0;
  int LabelSize = 0; // bytes of a tape label before the text
  std::int64_t FirstTrace = 0; // offset in bytes
  std::int64_t Traces = 0;
  std::vector<std::string> Warnings;

  std::size_t DataSize() const { return std::size_t(this->Samples) * SampleSize(int(this->Format)); }
  std::size_t TraceSize() const { return SEGYTraceHeaderSize + this->DataSize(); }
};

/// Numbers of samples and extended texts that the traces contradict are replaced, with a warning. Throws InputError for
/// other formats and incomplete traces.
SEGYHeader ReadSEGYHeader(std::istream& stream, std::int64_t fileSize, const SEGYHeaderOptions& options = {});

/// Requires a valid format code, in either byte order, and a number of samples.
bool IsSEGY(std::istream& stream);

/// Files without an extension of SEG-Y must also begin with text and have traces.
bool IsSEGYFile(const std::string& path);
}

#endif
