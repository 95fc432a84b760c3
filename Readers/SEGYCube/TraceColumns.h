// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTraceColumns_h
#define SeismicHorizonsTraceColumns_h

#include "SEGYCube.h"
#include "TraceTable.h"

#include <array>
#include <cstdint>

namespace SeismicHorizons
{
class LineNumbers
{
public:
  const TraceTable& Table;
  const FieldPair Fields;
  const LineNumbering Numbering;

  /// Throws InputError if all traces are dead without numbers, or the numbers form no lattice.
  LineNumbers(const TraceTable& table, const FieldPair& fields, const Monitor& monitor);

  std::int32_t Inline(std::int64_t trace) const { return this->Number(this->Fields.First, trace); }
  std::int32_t Crossline(std::int64_t trace) const { return this->Number(this->Fields.Second, trace); }

  bool IsUsed(std::int64_t trace) const { return !IsFiller(this->Table, this->Fields, trace); }

  std::array<int, 2> Column(std::int64_t trace) const;

  /// Throws InputError if the columns are far more than the traces.
  std::array<int, 2> CountColumns() const;

private:
  std::int32_t Number(int byte, std::int64_t trace) const { return byte == NoField ? 1 : this->Table[byte][trace]; }
  LineNumbering FindNumbering(const Monitor& monitor) const;
};

void FillColumns(SEGYCube& cube, const LineNumbers& lines, DuplicateRule rule);

/// Finds the vertical indices of all traces and the first index of each column. The grid follows the delay of most
/// traces; fractional delays cause a warning. Throws InputError for duplicates with different delays.
void FindSampling(SEGYCube& cube, const TraceTable& table, DelayRule rule);
}

#endif
