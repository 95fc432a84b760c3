// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineLattice.h"

#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
constexpr double Decimals = 1000.0; // Line numbers are multiples of 1 / Decimals.
// Deviation from such a multiple, as a fraction of it.
constexpr double LineRounding = 1e-3;
constexpr double LargestLine = 1e12;

/// Units are 1 / Decimals; Step is the greatest common divisor of all differences.
struct LineRange
{
  std::int64_t First = std::numeric_limits<std::int64_t>::max();
  std::int64_t Last = std::numeric_limits<std::int64_t>::min();
  std::int64_t Step = 0;

  void Add(std::int64_t line)
  {
    if (this->First > this->Last)
    {
      this->First = this->Last = line;
    }
    this->Step = std::gcd(this->Step, line - this->First);
    this->First = std::min(this->First, line);
    this->Last = std::max(this->Last, line);
  }

  void Add(const LineRange& other)
  {
    this->Add(other.First);
    this->Add(other.Last);
    this->Step = std::gcd(this->Step, other.Step);
  }
};

std::int64_t ToParts(const char* name, double line)
{
  const double parts = line * Decimals;
  if (!(std::abs(line) <= LargestLine) || std::abs(parts - std::round(parts)) > LineRounding)
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << name << ' ' << line << ", expected a line number with at most three decimals";
    throw InputError(text.str());
  }
  return std::llround(parts);
}

struct LineSteps
{
  double First = 0.0;
  double Step = 1.0; // 1 for a single line.
};

LineSteps FindLineSteps(const char* name, const std::vector<double>& lines, const Monitor& monitor)
{
  const auto all = AddUpChunks<LineRange>(std::int64_t(lines.size()), ChunkSize, monitor,
    [&](LineRange& range, std::int64_t first, std::int64_t last)
    {
      for (auto n = std::size_t(first); n < std::size_t(last); ++n)
      {
        range.Add(ToParts(name, lines[n]));
      }
    });
  return { double(all.First) / Decimals, all.Step == 0 ? 1.0 : double(all.Step) / Decimals };
}
}

//----------------------------------------------------------------------------------------------------------------------
LineNumbering FindLineNumbering(
  const std::vector<double>& crosslines, const std::vector<double>& inlines, const Monitor& monitor)
{
  const LineSteps along = FindLineSteps("crossline", crosslines, monitor.Step(0.0, 0.5));
  const LineSteps across = FindLineSteps("inline", inlines, monitor.Step(0.5, 1.0));
  return { along.First, along.Step, across.First, across.Step };
}
}
