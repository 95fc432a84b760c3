// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSEGYPrinter_h
#define SeismicHorizonsSEGYPrinter_h

#include "CubeGenerator.h"

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Where the columns of a generated cube lie: inlines count along j, crosslines along i; the survey is turned.
struct CubeSurvey
{
  int FirstInline = 1001;
  int FirstCrossline = 2001;
  std::array<double, 2> Origin = { 604321.25, 6079543.5 }; // of column (0, 0), in metres
  std::array<double, 2> ColumnStep = { 21.65, 12.5 }; // to the next crossline
  std::array<double, 2> RowStep = { -12.5, 21.65 }; // to the next inline

  std::array<double, 2> PlaceOf(int i, int j) const
  {
    return { this->Origin[0] + i * this->ColumnStep[0] + j * this->RowStep[0],
      this->Origin[1] + i * this->ColumnStep[1] + j * this->RowStep[1] };
  }
};

/// Writes the traces of a cube as a SEG-Y file of revision 1: big-endian, IEEE floats (format 5), text header in
/// EBCDIC; inline and crossline at bytes 189 and 193, x and y at 181 and 185 with the scalar -100. Missing traces (nan)
/// are not written, dead ones are marked as such. Throws std::runtime_error when the stream does not take it.
void WriteSEGY(const CubeGeneratorOptions& options, const std::vector<float>& traces, const CubeSurvey& survey,
  std::ostream& stream);

/// Writes where the reflectors are, as lines of text: the names of the columns, and then for each reflector and column
/// its number, inline, crossline, x, y, time in ms, place in samples, and -1 or 1 for the side of the fault.
void WriteTruth(const CubeGenerator& cube, const CubeSurvey& survey, std::ostream& stream);
}

#endif
