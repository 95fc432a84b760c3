// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TraceColumns.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Survey/LineLattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
// With less of its cells in the file a cube probably has wrong headers, and memory would be many times the file.
constexpr double MostCellsPerSample = 16.0;
// In steps; intervals such as 2/3 ms are rounded.
constexpr double DelayTolerance = 1e-3;

double Delay(const TraceTable& table, std::int64_t trace)
{
  return Scaled(table[TraceByte::Delay][trace], table[TraceByte::TimeScalar][trace]);
}

std::array<double, 2> DelayRange(const SEGYCube& cube, const TraceTable& table)
{
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const std::int32_t trace : cube.Traces)
  {
    if (trace >= 0)
    {
      least = std::min(least, Delay(table, trace));
      most = std::max(most, Delay(table, trace));
    }
  }
  return least <= most ? std::array{ least, most } : std::array{ 0.0, 0.0 };
}

/// Returns a delay that differs by whole steps from the delay of most columns.
double CommonDelay(const SEGYCube& cube, const TraceTable& table, double least)
{
  constexpr int parts = 1000; // per step
  std::array<std::int64_t, parts> counts = {};
  const auto partOf = [&](std::int32_t trace)
  {
    const double index = (Delay(table, trace) - least) / cube.Sampling.Step;
    return std::size_t(std::llround((index - std::floor(index)) * parts) % parts);
  };
  for (const std::int32_t trace : cube.Traces)
  {
    counts[trace >= 0 ? partOf(trace) : 0] += trace >= 0;
  }
  const auto common = std::size_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
  const auto first = std::find_if(
    cube.Traces.begin(), cube.Traces.end(), [&](std::int32_t trace) { return trace >= 0 && partOf(trace) == common; });
  return Delay(table, *first);
}

class DelaySteps
{
public:
  DelaySteps(SEGYCube& cube, DelayRule rule, double common)
    : Cube(cube)
    , Rule(rule)
    , Common(common)
  {
  }

  void Add(std::size_t column, double delay)
  {
    const double index = (delay - this->Common) / this->Cube.Sampling.Step;
    const double off = std::abs(index - std::round(index));
    const bool isShifted = off > DelayTolerance && this->Rule == DelayRule::Interpolate;
    const auto first = std::int32_t(isShifted ? std::ceil(index) : std::round(index));
    this->Cube.Delays[column] = first;
    if (isShifted)
    {
      this->Cube.Shifts.resize(this->Cube.Delays.size(), 0.0f);
      this->Cube.Shifts[column] = float(first - index);
    }
    this->First = std::min(this->First, first);
    this->End = std::max(this->End, first + this->Cube.Header.Samples - int(isShifted));
    if (off > DelayTolerance)
    {
      ++this->Uneven;
      this->Farthest = std::max(this->Farthest, off * this->Cube.Sampling.Step);
    }
  }

  void Finish(double least)
  {
    VerticalSampling& sampling = this->Cube.Sampling;
    const double first = this->Common + this->First * sampling.Step;
    sampling.First = std::abs(first - least) <= DelayTolerance * sampling.Step ? least : first;
    sampling.Indices = this->End - this->First;
    for (std::size_t column = 0; column < this->Cube.Delays.size(); ++column)
    {
      this->Cube.Delays[column] -= this->Cube.Traces[column] >= 0 ? this->First : 0;
    }
    if (this->Uneven > 0)
    {
      std::ostringstream text;
      text << this->Uneven << " traces with delays up to " << this->Farthest << " ms off whole steps of "
           << sampling.Step << " ms from " << this->Common << " (byte 109): "
           << (this->Rule == DelayRule::Nearest ? "moved to the nearest step"
                                                : "their samples are interpolated at whole steps");
      this->Cube.Warnings.push_back(text.str());
    }
  }

private:
  SEGYCube& Cube;
  const DelayRule Rule;
  const double Common;
  std::int32_t First = std::numeric_limits<std::int32_t>::max();
  std::int32_t End = std::numeric_limits<std::int32_t>::min();
  std::int64_t Uneven = 0;
  double Farthest = 0.0; // Distance from a whole step, in milliseconds.
};

void CheckDelaysOfDuplicates(const SEGYCube& cube, const TraceTable& table)
{
  for (const DuplicateTrace& duplicate : cube.Duplicates)
  {
    const std::int32_t first = cube.Traces[duplicate.Column];
    if (Delay(table, first) != Delay(table, duplicate.Trace))
    {
      std::ostringstream text;
      text << "traces " << first + 1 << " and " << duplicate.Trace + 1 << " at one position with delays of "
           << Delay(table, first) << " and " << Delay(table, duplicate.Trace)
           << " ms (byte 109), expected equal ones for a mean; set DuplicatePolicy to First or Last";
      throw InputError(text.str());
    }
  }
}

void CheckTraceCells(const SEGYCube& cube, double indices)
{
  const std::array<int, 2>& columns = cube.Lattice.Columns;
  const double samples = double(cube.Header.Traces) * cube.Header.Samples;
  if (!(double(columns[0]) * columns[1] * indices <= MostCellsPerSample * samples))
  {
    std::ostringstream text;
    text << "a cube of " << columns[1] << " inlines (" << FieldText(cube.LineFields.First) << "), " << columns[0]
         << " crosslines (" << FieldText(cube.LineFields.Second) << ") and " << indices << " vertical indices for "
         << cube.Header.Traces << " traces of " << cube.Header.Samples << " samples, expected at most "
         << MostCellsPerSample << " times as many cells";
    throw InputError(text.str());
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
LineNumbers::LineNumbers(const TraceTable& table, const FieldPair& fields, const Monitor& monitor)
  : Table(table)
  , Fields(fields)
  , Numbering(this->FindNumbering(monitor))
{
}

//----------------------------------------------------------------------------------------------------------------------
std::array<int, 2> LineNumbers::Column(std::int64_t trace) const
{
  const Eigen::Vector2d index = LineIndex(this->Numbering, this->Crossline(trace), this->Inline(trace));
  return { int(std::lround(index.x())), int(std::lround(index.y())) };
}

//----------------------------------------------------------------------------------------------------------------------
LineNumbering LineNumbers::FindNumbering(const Monitor& monitor) const
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
      " traces, all dead and without line numbers, expected live ones");
  }
  return FindLineNumbering(crosslines, inlines, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
std::array<int, 2> LineNumbers::CountColumns() const
{
  Eigen::Vector2d last = Eigen::Vector2d::Zero();
  for (std::int64_t trace = 0; trace < this->Table.Traces; ++trace)
  {
    if (this->IsUsed(trace))
    {
      last = last.cwiseMax(LineIndex(this->Numbering, this->Crossline(trace), this->Inline(trace)));
    }
  }
  const double columns = (last.x() + 1.0) * (last.y() + 1.0);
  if (!(columns <= MostCellsPerSample * double(this->Table.Traces)) || last.maxCoeff() >= MostColumnsPerSide)
  {
    std::ostringstream text;
    text << std::llround(last.y()) + 1 << " inlines (" << FieldText(this->Fields.First) << ") and "
         << std::llround(last.x()) + 1 << " crosslines (" << FieldText(this->Fields.Second) << ") for "
         << this->Table.Traces << " traces, expected a grid that is at least one sixteenth full";
    throw InputError(text.str());
  }
  return { int(std::lround(last.x())) + 1, int(std::lround(last.y())) + 1 };
}

//----------------------------------------------------------------------------------------------------------------------
void FindSampling(SEGYCube& cube, const TraceTable& table, DelayRule rule)
{
  CheckDelaysOfDuplicates(cube, table);
  const std::array<double, 2> range = DelayRange(cube, table);
  cube.Sampling.First = range[0];
  cube.Sampling.Indices = cube.Header.Samples;
  const double indices = std::ceil((range[1] - range[0]) / cube.Sampling.Step) + cube.Header.Samples;
  CheckTraceCells(cube, indices);
  if (range[0] == range[1])
  {
    return;
  }
  cube.Delays.assign(cube.Traces.size(), 0);
  DelaySteps steps(cube, rule, CommonDelay(cube, table, range[0]));
  for (std::size_t column = 0; column < cube.Traces.size(); ++column)
  {
    if (cube.Traces[column] >= 0)
    {
      steps.Add(column, Delay(table, cube.Traces[column]));
    }
  }
  steps.Finish(range[0]);
}

//----------------------------------------------------------------------------------------------------------------------
void FillColumns(SEGYCube& cube, const LineNumbers& lines, DuplicateRule rule)
{
  const TraceTable& table = lines.Table;
  const std::size_t columns = std::size_t(cube.Lattice.Columns[0]) * std::size_t(cube.Lattice.Columns[1]);
  cube.Traces.assign(columns, NoTrace);
  cube.MissingTraces = std::int64_t(columns);
  std::array<int, 2> previous = { 0, 0 };
  std::int64_t alongCrosslines = 0; // Steps between traces along crosslines, minus steps along inlines.
  for (std::int64_t trace = 0; trace < table.Traces; ++trace)
  {
    if (!lines.IsUsed(trace))
    {
      ++cube.Fillers;
      continue;
    }
    const std::array<int, 2> place = lines.Column(trace);
    alongCrosslines += (place[0] == previous[0]) - (place[1] == previous[1]);
    previous = place;
    const std::size_t column = cube.Column(place[0], place[1]);
    std::int32_t& number = cube.Traces[column];
    const bool isDead = table.IsDead(trace);
    const std::int32_t own = isDead ? DeadTrace : std::int32_t(trace);
    if (number == NoTrace)
    {
      number = own;
      --cube.MissingTraces;
      continue;
    }
    ++cube.DuplicateTraces; // Dead traces are ignored where another one exists.
    if (!isDead && number != DeadTrace && rule == DuplicateRule::Refuse)
    {
      std::ostringstream text;
      text << "trace " << trace + 1 << " at inline " << lines.Inline(trace) << " (" << FieldText(lines.Fields.First)
           << ") and crossline " << lines.Crossline(trace) << " (" << FieldText(lines.Fields.Second)
           << "), where there is another one, expected one trace for each inline and crossline; set DuplicatePolicy to "
              "read the first, the last or the mean of several";
      throw InputError(text.str());
    }
    if (!isDead && number >= 0 && rule == DuplicateRule::Mean)
    {
      cube.Duplicates.push_back({ column, own });
    }
    else if (!isDead && (number == DeadTrace || rule == DuplicateRule::Last))
    {
      number = own;
    }
  }
  cube.IsCrosslineSorted = alongCrosslines > 0;
  cube.DeadTraces = std::count(cube.Traces.begin(), cube.Traces.end(), DeadTrace);
  std::stable_sort(cube.Duplicates.begin(), cube.Duplicates.end(),
    [](const DuplicateTrace& a, const DuplicateTrace& b) { return a.Column < b.Column; });
}
}
