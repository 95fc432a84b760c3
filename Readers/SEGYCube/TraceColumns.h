// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which trace is on which column of the lattice.

#ifndef SeismicHorizonsTraceColumns_h
#define SeismicHorizonsTraceColumns_h

#include "SEGYCube.h"

#include <array>
#include <cstdint>

namespace SeismicHorizons
{
/// The line numbers of traces.
class LineNumbers
{
public:
  /// The table must outlive it.
  LineNumbers(const TraceTable& table, const FieldPair& fields)
    : Table(table)
    , Fields(fields)
  {
  }

  std::int32_t Inline(std::int64_t trace) const { return this->Number(this->Fields.First, trace); }
  std::int32_t Crossline(std::int64_t trace) const { return this->Number(this->Fields.Second, trace); }
  const FieldPair& Bytes() const { return this->Fields; }

  /// False for traces that are on no column.
  bool IsUsed(std::int64_t trace) const { return !IsFiller(this->Table, this->Fields, trace); }

  /// The column of a trace, along i and j.
  std::array<int, 2> Column(const LineNumbering& numbering, std::int64_t trace) const;

  /// The lattice of all traces. Throws InputError where none is used.
  LineNumbering Numbering(const Monitor& monitor) const;

  /// How many columns there are. Throws InputError where they are by far more than traces.
  std::array<int, 2> CountColumns(const LineNumbering& numbering) const;

private:
  std::int32_t Number(int byte, std::int64_t trace) const { return byte == NoField ? 1 : this->Table[byte][trace]; }

  const TraceTable& Table;
  const FieldPair Fields;
};

/// The traces of all columns, and how they are sorted. Throws InputError on two live traces at one place where the rule
/// refuses them.
void FillColumns(SEGYCube& cube, const TraceTable& table, const LineNumbers& lines, DuplicateRule rule);

/// The vertical indices, from the earliest sample of any trace of the columns to the last, where the step from one to
/// the next is known; and the vertical index of the first sample of each column, where they differ. Whole steps are
/// those from the delay of most traces; others are a warning. Throws InputError on duplicates with other delays.
void FindSampling(SEGYCube& cube, const TraceTable& table, DelayRule rule);
}

#endif
