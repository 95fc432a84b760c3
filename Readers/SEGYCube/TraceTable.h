// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The numbers in the headers of all traces that say where they belong.

#ifndef SeismicHorizonsTraceTable_h
#define SeismicHorizonsTraceTable_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "SEGYHeader.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Fields of a trace header, by the byte where they begin.
namespace TraceByte
{
constexpr int Kind = 29; // 1 seismic data, 2 dead, 3 dummy
constexpr int Offset = 37; // from the source to the receiver
constexpr int PlaceScalar = 71;
constexpr int Delay = 109; // from the shot to the first sample, in milliseconds
constexpr int Samples = 115;
constexpr int TimeScalar = 215;
}

/// A number for each trace. Most fields are the same for all: parts that are take no memory.
class TraceField
{
public:
  static constexpr std::int64_t PartSize = 1 << 12; // traces

  explicit TraceField(std::int64_t traces = 0);

  /// Sets the numbers of a part, whose last one may be shorter. Parts may be set by several threads.
  void SetPart(std::size_t part, const RawVector<std::int32_t>& values);

  std::int32_t operator[](std::int64_t trace) const
  {
    const Part& part = this->Parts[std::size_t(trace / PartSize)];
    return part.Values.empty() ? part.First : part.Values[std::size_t(trace % PartSize)];
  }

  std::int64_t Size() const { return this->Traces; }
  bool IsConstant() const;

private:
  struct Part
  {
    std::int32_t First = 0;
    RawVector<std::int32_t> Values; // empty where all are as the first
  };
  std::vector<Part> Parts;
  std::int64_t Traces = 0;
};

/// Fields of trace headers by the byte where they begin, counted from 1 as the standard does.
struct TraceTable
{
  std::int64_t Traces = 0;
  std::map<int, TraceField> Fields;

  const TraceField& operator[](int byte) const { return this->Fields.at(byte); }

  /// Whether the header of a trace says that there is nothing in it.
  bool IsDead(std::int64_t trace) const;
};

/// A number by its scalar: a negative one divides, and 0 stands for 1.
inline double Scaled(double number, int scalar)
{
  return scalar < 0 ? number / -double(scalar) : scalar > 0 ? number * scalar : number;
}

/// Reads fields of the headers of all traces: those of TraceByte, which have 2 bytes but for Offset, and others of 4.
TraceTable ReadTraceTable(
  const std::string& name, const SEGYHeader& header, const std::vector<int>& fields, const Monitor& monitor);
}

#endif
