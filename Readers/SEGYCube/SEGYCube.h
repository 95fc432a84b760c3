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
/// What the user says of a file. Bytes of fields are counted from 1; 0 stands for "found", NoField for "none".
struct SEGYOptions
{
  int FormatCode = 0; // 0: that of the file
  FieldPair LineFields; // of inline and crossline
  FieldPair PlaceFields; // of x and y
  double Tolerance = 0.25; // how far traces may be off their columns, in columns
  double VerticalStep = 0.0; // 0: that of the file
};

/// Throws InputError, with the names of the reader's properties, on options that can not be.
void CheckSEGYOptions(const SEGYOptions& options);

/// In the place of the number of a trace.
constexpr std::int32_t NoTrace = -1;
constexpr std::int32_t DeadTrace = -2;

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
  std::string Warning; // what users should know; empty where there is nothing
  RawVector<std::int32_t> Traces; // of column (i, j) at i + j * Columns[0]: its number, NoTrace, or DeadTrace
  std::vector<std::int32_t> Delays; // in the same order, the vertical index of the first sample; empty where all are 0

  std::size_t Column(int i, int j) const
  {
    return std::size_t(j) * std::size_t(this->Lattice.Columns[0]) + std::size_t(i);
  }
};

/// Reads the headers of a file. Throws InputError on what is no cube after stacking, nor a line.
SEGYCube ReadSEGYCube(const std::string& name, const SEGYOptions& options, const Monitor& monitor = Monitor());

/// What was found, for people: some lines of text.
std::string Describe(const SEGYCube& cube);
}

#endif
