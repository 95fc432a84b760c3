// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTraceTable_h
#define SeismicHorizonsTraceTable_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "SEGYHeader.h"

#include <cstdint>
#include <map>
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
constexpr int Delay = 109; // Milliseconds from the shot to the first sample.
constexpr int Samples = 115;
constexpr int TimeScalar = 215;
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

  std::int64_t Size() const { return this->Traces; }
  bool IsConstant() const;

private:
  struct Part
  {
    std::int32_t First = 0;
    RawVector<std::int32_t> Values; // Empty if all equal First.
  };
  std::vector<Part> Parts;
  std::int64_t Traces = 0;
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

/// Fields of TraceByte have 2 bytes, except Offset; all other fields have 4.
TraceTable ReadTraceTable(
  const std::string& name, const SEGYHeader& header, const std::vector<int>& fields, const Monitor& monitor);
}

#endif
