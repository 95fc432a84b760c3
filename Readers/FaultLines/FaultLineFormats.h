// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultLineFormats_h
#define SeismicHorizonsFaultLineFormats_h

#include "Common/LineErrors.h"
#include "Common/TextFields.h"
#include "FaultLineFile.h"

#include <cstdint>
#include <memory>
#include <string_view>

namespace SeismicHorizons
{
/// A line of a file, without what ends it, and its number from 1.
struct NumberedLine
{
  std::string_view Text;
  std::int64_t Number = 0;
};

/// A field as a finite number; `what` it is follows in the error.
double ReadFinite(std::string_view field, std::int64_t line, const char* what);

/// What takes the lines of a file of one format, one after the other, from the first that says anything on.
class FaultLineParser
{
public:
  virtual ~FaultLineParser() = default;
  virtual void Take(const NumberedLine& line) = 0;

  /// The polylines, behind the last line.
  virtual FaultLineFile Finish() = 0;
};

std::unique_ptr<FaultLineParser> MakePLineParser();
std::unique_ptr<FaultLineParser> MakeZmapLineParser();
std::unique_ptr<FaultLineParser> MakePlainLineParser();
}

#endif
