// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Assigns traces of a SEG-Y file to bins, by their headers alone.

#ifndef SeismicHorizonsSEGYCube_h
#define SeismicHorizonsSEGYCube_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "Common/Survey/SurveyDescription.h"
#include "Common/Survey/SurveyLattice.h"
#include "Common/Survey/VerticalSampling.h"
#include "Common/Text/InputFile.h"
#include "SEGYHeader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
enum class DuplicateRule
{
  Refuse,
  First,
  Last,
  Mean
};

/// Applies to traces whose delays differ by fractions of a step.
enum class DelayRule
{
  Interpolate, ///< Cubic polynomials give the samples at whole steps.
  Nearest ///< Samples move to the nearest step.
};

/// Bytes count from 1; 0 means detect, NoField means none.
struct SEGYOptions : SEGYHeaderOptions
{
  FieldPair LineFields; // inline and crossline
  FieldPair PlaceFields; // x and y
  double Tolerance = 0.25; // Largest distance of a trace from its column, in columns.
  double VerticalStep = 0.0; // 0 keeps the step of the file.
  DuplicateRule Duplicates = DuplicateRule::Refuse;
  DelayRule Delays = DelayRule::Interpolate;
};

void CheckSEGYOptions(const SEGYOptions& options);

/// Values of SEGYCube::Traces.
constexpr std::int32_t NoTrace = -1;
constexpr std::int32_t DeadTrace = -2;

/// Its samples are averaged with another trace of the column.
struct DuplicateTrace
{
  std::size_t Column;
  std::int32_t Trace;
};

/// Crosslines are along i, inlines along j, and samples along k.
struct SEGYCube
{
  std::string Name;
  FileStamp Stamp; // when the headers were read
  SEGYHeader Header;
  FieldPair LineFields;
  FieldPair PlaceFields; // NoField if line numbers replace places.
  SurveyDescription Survey;
  SurveyLattice Lattice;
  double LargestDistance = 0.0; // In columns.
  VerticalSampling Sampling; // Milliseconds, or the unit that the user sets.
  bool IsCrosslineSorted = false;
  std::int64_t MissingTraces = 0; // columns without a trace
  std::int64_t DeadTraces = 0; // dead by their headers
  std::int64_t Fillers = 0; // dead traces without line numbers
  std::int64_t DuplicateTraces = 0; // ignored or averaged
  std::int64_t StrayPlaces = 0;
  std::vector<std::string> Warnings;
  RawVector<std::int32_t> Traces; // Trace of column (i, j) at i + j * Columns[0], or NoTrace or DeadTrace.
  std::vector<DuplicateTrace> Duplicates; // Sorted by column; empty unless traces are averaged.
  std::vector<std::int32_t> Delays; // Vertical index of the first sample, as Traces; empty if all are 0.
  /// Fraction of a step by which Delays is after the first sample, as Traces; empty if all are 0. Interpolation between
  /// samples leaves one sample less.
  std::vector<float> Shifts;
  /// Position of each trace by its own header, as Traces, or nan; empty unless the cube is a single line.
  std::vector<Eigen::Vector2d> Places;

  std::size_t Column(int i, int j) const
  {
    return std::size_t(j) * std::size_t(this->Lattice.Columns[0]) + std::size_t(i);
  }
};

/// Throws InputError unless the file is a post-stack cube or line.
SEGYCube ReadSEGYCube(const std::string& name, const SEGYOptions& options, const Monitor& monitor = Monitor());

/// `survey` has what the user has set.
std::string Describe(const SEGYCube& cube, const SurveyDescription& survey);

std::string WarningText(const SEGYCube& cube);
}

#endif
