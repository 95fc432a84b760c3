// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the headers of a SEG-Y file say of its cube: where each trace belongs. Samples are not looked at here.

#ifndef SeismicHorizonsSEGYCube_h
#define SeismicHorizonsSEGYCube_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Survey/SurveyDescription.h"
#include "Common/Survey/SurveyLattice.h"
#include "Common/Survey/VerticalSampling.h"
#include "LineFields.h"
#include "SEGYHeader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Which of several traces at one place counts.
enum class DuplicateRule
{
  Refuse, ///< none: it is an error
  First,
  Last,
  Mean
};

/// What is done with traces whose delay is not whole steps off that of the others.
enum class DelayRule
{
  Interpolate, ///< samples at whole steps, from their neighbours by cubic polynomials
  Nearest ///< samples are moved to the nearest step
};

/// What the user says of a file. Bytes of fields are counted from 1; 0 stands for "found", NoField for "none".
struct SEGYOptions : SEGYHeaderOptions
{
  FieldPair LineFields; // of inline and crossline
  FieldPair PlaceFields; // of x and y
  double Tolerance = 0.25; // how far traces may be off their columns, in columns
  double VerticalStep = 0.0; // 0: that of the file
  DuplicateRule Duplicates = DuplicateRule::Refuse;
  DelayRule Delays = DelayRule::Interpolate;
};

/// Throws InputError, with the names of the reader's properties, on options that cannot be.
void CheckSEGYOptions(const SEGYOptions& options);

/// In the place of the number of a trace.
constexpr std::int32_t NoTrace = -1;
constexpr std::int32_t DeadTrace = -2;

/// A trace at the place of another one, with which its samples are averaged.
struct DuplicateTrace
{
  std::size_t Column;
  std::int32_t Trace;
};

/// Crosslines count along i, inlines along j, and samples along k.
struct SEGYCube
{
  std::string Name; // of the file
  SEGYHeader Header;
  FieldPair LineFields; // where they were found
  FieldPair PlaceFields; // the same; NoField where line numbers stand for places
  SurveyDescription Survey;
  SurveyLattice Lattice;
  double LargestDistance = 0.0; // of a trace to its column, in columns
  VerticalSampling Sampling; // in milliseconds, or what stands in their place
  bool IsCrosslineSorted = false;
  std::int64_t MissingTraces = 0; // columns without one
  std::int64_t DeadTraces = 0; // by their headers
  std::int64_t Fillers = 0; // dead ones without line numbers
  std::int64_t DuplicateTraces = 0; // that do not count, or are averaged
  std::int64_t StrayPlaces = 0; // of traces that are off the lattice of the others
  std::vector<std::string> Warnings; // what users should know
  RawVector<std::int32_t> Traces; // of column (i, j) at i + j * Columns[0]: its number, NoTrace, or DeadTrace
  std::vector<DuplicateTrace> Duplicates; // by column; empty where only one trace of each counts
  std::vector<std::int32_t> Delays; // as Traces, the vertical index of the first sample; empty where all are 0
  /// As Traces, how far the vertical index of Delays is behind the first sample, 0 to 1; empty where all are 0. Samples
  /// are those between it and the next, so that there is one less.
  std::vector<float> Shifts;
  /// As Traces, where each trace is by its own header, nan where there is none; empty but for cubes of one line.
  std::vector<Eigen::Vector2d> Places;

  std::size_t Column(int i, int j) const
  {
    return std::size_t(j) * std::size_t(this->Lattice.Columns[0]) + std::size_t(i);
  }
};

/// Reads the headers of a file. Throws InputError on what is no cube after stacking, nor a line.
SEGYCube ReadSEGYCube(const std::string& name, const SEGYOptions& options, const Monitor& monitor = Monitor());

/// What was found, for people: some lines of text.
std::string Describe(const SEGYCube& cube);

/// All warnings as one text; empty where there is none.
std::string WarningText(const SEGYCube& cube);
}

#endif
