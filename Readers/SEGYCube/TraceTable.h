// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads headers of traces, and finds the fields of line numbers and places, on which programs do not agree.
//
// Fields form a grid if both vary and repeat, at most 5 % of the traces share a bin, and at least 10 % of the bins have
// traces. Among pairs within 0.15 of the fullest grid the first of the usual pairs is used; the fields of x and y only
// with numbers up to 99,999. A line has one constant field and another that differs for each trace.

#ifndef SeismicHorizonsTraceTable_h
#define SeismicHorizonsTraceTable_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "SEGYHeader.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Bytes count from 1.
namespace TraceByte
{
constexpr int Kind = 29; // 1 seismic data, 2 dead, 3 dummy.
constexpr int Offset = 37;
constexpr int PlaceScalar = 71;
constexpr int PlaceUnit = 89; // 1 length, 2 seconds of arc, 3 degrees, 4 degrees, minutes and seconds.
constexpr int Delay = 109; // Milliseconds from the shot to the first sample.
constexpr int Samples = 115;
constexpr int TimeScalar = 215;
// Behind the header: numbers of rows and columns of a lattice of x and y, for want of line numbers.
constexpr int LatticeRow = 241;
constexpr int LatticeColumn = 245;
}

/// Stores one number per trace, and constant parts without memory.
class TraceField
{
public:
  static constexpr std::int64_t PartSize = 1 << 12; // traces

  explicit TraceField(std::int64_t traces = 0);

  void SetPart(std::size_t part, const RawVector<std::int32_t>& values);

  std::int32_t operator[](std::int64_t trace) const
  {
    const Part& part = this->Parts[std::size_t(trace / PartSize)];
    return part.Values.empty() ? part.First : part.Values[std::size_t(trace % PartSize)];
  }

  bool IsConstant() const;

private:
  struct Part
  {
    std::int32_t First = 0;
    RawVector<std::int32_t> Values; // Empty if all equal First.
  };
  std::vector<Part> Parts;
};

struct TraceTable
{
  std::int64_t Traces = 0;
  std::map<int, TraceField> Fields;

  const TraceField& operator[](int byte) const { return this->Fields.at(byte); }

  /// Dead and dummy traces.
  bool IsDead(std::int64_t trace) const;
};

/// A negative scalar divides, and 0 means 1.
inline double Scaled(double number, int scalar)
{
  return scalar < 0 ? number / -double(scalar) : scalar > 0 ? number * scalar : number;
}

/// Each thread needs its own object.
class SEGYFile
{
public:
  SEGYFile(const std::string& name, const SEGYHeader& header);

  /// Reads bytes from the beginning of a trace, which may extend over the next ones.
  void Read(std::int64_t trace, std::size_t size, unsigned char* bytes);

private:
  std::ifstream Stream;
  const std::int64_t FirstTrace;
  const std::int64_t TraceSize;
};

/// Fields of TraceByte have 2 bytes, except Offset; all other fields have 4.
TraceTable ReadTraceTable(
  const std::string& name, const SEGYHeader& header, const std::vector<int>& fields, const Monitor& monitor);

// ---- Fields of lines and places -------------------------------------------------------------------------------------
// The preferred fields of x and y come first.
constexpr std::array<FieldPair, 3> PlacePairs = { { { 181, 185 }, { 73, 77 }, { 81, 85 } } };

std::vector<int> ListFields();

std::string FieldText(int byte);

bool AreSame(const TraceTable& table, const FieldPair& fields);

/// Returns the pair of the user, or the usual ones that are not constant.
std::vector<FieldPair> ListPlaceFields(const TraceTable& table, const FieldPair& given);

/// Some programs pad files with dead traces without line numbers.
bool IsFiller(const TraceTable& table, const FieldPair& lines, std::int64_t trace);

/// Finds fields of a grid or a line. `mayRepeat` allows 50 % of the traces to share a bin. Throws InputError for
/// different offsets (pre-stack data).
std::optional<FieldPair> FindLineFields(
  const TraceTable& table, bool mayRepeat = false, const Monitor& monitor = Monitor());

/// `other` is a candidate.
std::string OtherLinesText(const std::optional<FieldPair>& other);

bool IsPlacePair(const FieldPair& pair);

std::optional<FieldPair> FindAnyGrid(const TraceTable& table);

/// Throws InputError; `other` is a candidate.
[[noreturn]] void RefuseLines(const TraceTable& table, const std::optional<FieldPair>& other);
}

#endif
