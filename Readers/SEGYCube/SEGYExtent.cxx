// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SEGYExtent.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
struct IndexRange
{
  int First, Last;
};

/// The indices of the lines whose numbers are in a range.
IndexRange LinesWithin(const char* name, const std::array<int, 2>& range, double first, double step, int count)
{
  if (range[0] == 0 && range[1] == -1)
  {
    return { 0, count - 1 };
  }
  const double low = std::max(0.0, std::ceil((range[0] - first) / step));
  const double high = std::min(count - 1.0, std::floor((range[1] - first) / step));
  if (low > high)
  {
    std::ostringstream text;
    text.precision(10);
    text << name << ' ' << range[0] << " to " << range[1] << ", expected some of the lines " << first << " to "
         << first + step * (count - 1) << " in steps of " << step << ", or 0 to -1 for all";
    throw InputError(text.str());
  }
  return { int(low), int(high) };
}

IndexRange SamplesWithin(const std::array<int, 2>& range, int count)
{
  if (range[0] < 0 || range[0] >= count || range[1] < -1 || (range[1] >= 0 && range[1] < range[0]))
  {
    std::ostringstream text;
    text << "SampleRange " << range[0] << " to " << range[1] << ", expected a first vertical index from 0 to "
         << count - 1 << ", and a last one that is not less, or -1 for the end";
    throw InputError(text.str());
  }
  return { range[0], range[1] < 0 ? count - 1 : std::min(range[1], count - 1) };
}
}

//----------------------------------------------------------------------------------------------------------------------
CubeExtent FindExtent(const SEGYCube& cube, const SEGYRanges& ranges)
{
  const SurveyLattice& lattice = cube.Lattice;
  const LineNumbering& lines = *lattice.Lines;
  const IndexRange i =
    LinesWithin("CrosslineRange", ranges.Crosslines, lines.FirstCrossline, lines.CrosslineStep, lattice.Columns[0]);
  const IndexRange j =
    LinesWithin("InlineRange", ranges.Inlines, lines.FirstInline, lines.InlineStep, lattice.Columns[1]);
  const IndexRange k = SamplesWithin(ranges.Samples, cube.Sampling.Indices);
  return { i.First, i.Last, j.First, j.Last, k.First, k.Last };
}
}
