// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TraceColumns.h"

#include "Common/Errors.h"
#include "Common/Lattice.h"
#include "Common/Survey/LineLattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
// A cube that has less of its cells in the file is taken for one whose headers are wrong: memory for it would be many
// times the size of the file.
constexpr double MostCellsPerSample = 16.0;
// How far delays may be off whole steps, in steps: intervals such as 2/3 ms are known to some digits only.
constexpr double DelayTolerance = 1e-3;

double Delay(const TraceTable& table, std::int64_t trace)
{
  return Scaled(table[TraceByte::Delay][trace], table[TraceByte::TimeScalar][trace]);
}

/// The range of the delays of all traces that are not dead.
std::array<double, 2> DelayRange(const TraceTable& table, const LineNumbers& lines)
{
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::int64_t trace = 0; trace < table.Traces; ++trace)
  {
    if (!table.IsDead(trace) && lines.IsUsed(trace))
    {
      least = std::min(least, Delay(table, trace));
      most = std::max(most, Delay(table, trace));
    }
  }
  return least <= most ? std::array<double, 2>{ least, most } : std::array<double, 2>{ 0.0, 0.0 };
}

int DelayIndex(const SEGYCube& cube, const TraceTable& table, std::int64_t trace)
{
  const double delay = Delay(table, trace);
  const double index = (delay - cube.Sampling.First) / cube.Sampling.Step;
  if (std::abs(index - std::round(index)) > DelayTolerance)
  {
    std::ostringstream text;
    text << "trace " << trace + 1 << " with a delay of " << delay << " ms (byte 109), expected whole steps of "
         << cube.Sampling.Step << " ms from the least one, " << cube.Sampling.First;
    throw InputError(text.str());
  }
  return int(std::lround(index));
}

void CheckCells(const SEGYCube& cube, double indices)
{
  const std::array<int, 2>& columns = cube.Lattice.Columns;
  const double samples = double(cube.Header.Traces) * cube.Header.Samples;
  if (!(double(columns[0]) * columns[1] * indices <= MostCellsPerSample * samples))
  {
    std::ostringstream text;
    text << "a cube of " << columns[1] << " inlines (byte " << cube.LineFields.First << "), " << columns[0]
         << " crosslines (byte " << cube.LineFields.Second << ") and " << indices << " vertical indices for "
         << cube.Header.Traces << " traces of " << cube.Header.Samples << " samples, expected at most "
         << MostCellsPerSample << " times as many cells";
    throw InputError(text.str());
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::array<int, 2> LineNumbers::Column(const LineNumbering& numbering, std::int64_t trace) const
{
  const Eigen::Vector2d index = LineIndex(numbering, this->Crossline(trace), this->Inline(trace));
  return { int(std::lround(index.x())), int(std::lround(index.y())) };
}

//----------------------------------------------------------------------------------------------------------------------
LineNumbering LineNumbers::Numbering(const Monitor& monitor) const
{
  std::vector<double> crosslines, inlines;
  for (std::int64_t trace = 0; trace < this->Table.Traces; ++trace)
  {
    if (this->IsUsed(trace))
    {
      crosslines.push_back(this->Crossline(trace));
      inlines.push_back(this->Inline(trace));
    }
  }
  if (crosslines.empty())
  {
    throw InputError(std::to_string(this->Table.Traces) +
      " traces that are all dead and without line numbers, expected some that are not");
  }
  return FindLineNumbering(crosslines, inlines, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
std::array<int, 2> LineNumbers::CountColumns(const LineNumbering& numbering) const
{
  Eigen::Vector2d last = Eigen::Vector2d::Zero();
  for (std::int64_t trace = 0; trace < this->Table.Traces; ++trace)
  {
    if (this->IsUsed(trace))
    {
      last = last.cwiseMax(LineIndex(numbering, this->Crossline(trace), this->Inline(trace)));
    }
  }
  const double columns = (last.x() + 1.0) * (last.y() + 1.0);
  if (!(columns <= MostCellsPerSample * double(this->Table.Traces)) || last.maxCoeff() >= MostColumnsPerSide)
  {
    std::ostringstream text;
    text << std::llround(last.y()) + 1 << " inlines (byte " << this->Fields.First << ") and "
         << std::llround(last.x()) + 1 << " crosslines (byte " << this->Fields.Second << ") for " << this->Table.Traces
         << " traces, expected a grid that is full to a sixteenth at least";
    throw InputError(text.str());
  }
  return { int(std::lround(last.x())) + 1, int(std::lround(last.y())) + 1 };
}

//----------------------------------------------------------------------------------------------------------------------
void FindSampling(SEGYCube& cube, const TraceTable& table, const LineNumbers& lines)
{
  const std::array<double, 2> range = DelayRange(table, lines);
  cube.Sampling.First = range[0];
  const double indices = std::round((range[1] - range[0]) / cube.Sampling.Step) + cube.Header.Samples;
  CheckCells(cube, indices);
  cube.Sampling.Indices = int(indices);
  if (range[0] == range[1])
  {
    return;
  }
  cube.Delays.assign(std::size_t(cube.Lattice.Columns[0]) * std::size_t(cube.Lattice.Columns[1]), 0);
  for (std::int64_t trace = 0; trace < table.Traces; ++trace)
  {
    if (!table.IsDead(trace) && lines.IsUsed(trace))
    {
      const auto [i, j] = lines.Column(*cube.Lattice.Lines, trace);
      cube.Delays[cube.Column(i, j)] = DelayIndex(cube, table, trace);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void FillColumns(SEGYCube& cube, const TraceTable& table, const LineNumbers& lines)
{
  const std::size_t columns = std::size_t(cube.Lattice.Columns[0]) * std::size_t(cube.Lattice.Columns[1]);
  cube.Traces.assign(columns, NoTrace);
  cube.MissingTraces = std::int64_t(columns);
  std::array<int, 2> previous = { 0, 0 };
  std::int64_t alongCrosslines =
    0; // steps from a trace to the next on the same crossline, less those on the same inline
  for (std::int64_t trace = 0; trace < table.Traces; ++trace)
  {
    if (!lines.IsUsed(trace))
    {
      ++cube.Fillers;
      continue;
    }
    const std::array<int, 2> place = lines.Column(*cube.Lattice.Lines, trace);
    alongCrosslines += (place[0] == previous[0]) - (place[1] == previous[1]);
    previous = place;
    std::int32_t& number = cube.Traces[cube.Column(place[0], place[1])];
    if (number != NoTrace)
    {
      std::ostringstream text;
      text << "trace " << trace + 1 << " at inline " << lines.Inline(trace) << " (byte " << lines.Bytes().First
           << ") and crossline " << lines.Crossline(trace) << " (byte " << lines.Bytes().Second
           << "), where there is another one, expected one trace for each inline and crossline";
      throw InputError(text.str());
    }
    const bool isDead = table.IsDead(trace);
    number = isDead ? DeadTrace : std::int32_t(trace);
    cube.DeadTraces += isDead;
    --cube.MissingTraces;
  }
  cube.IsCrosslineSorted = alongCrosslines > 0;
}
}
