// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultLineFormats_h
#define SeismicHorizonsFaultLineFormats_h

#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"
#include "FaultColumns.h"
#include "FaultLineFile.h"

#include <cstdint>
#include <memory>
#include <string_view>

namespace SeismicHorizons
{
/// IRAP and RMS end a polyline with "999.0 999.0 999.0".
constexpr double EndOfPart = 999.0;

struct NumberedLine
{
  std::string_view Text;
  std::int64_t Number = 0;
};

/// Throws InputError with `what` at its end unless the number is finite.
double ReadFinite(std::string_view field, std::int64_t line, const char* what);

/// Parses the lines of one format, from the first that is neither empty nor a comment.
class FaultLineParser
{
public:
  virtual ~FaultLineParser() = default;
  virtual void Take(const NumberedLine& line) = 0;

  virtual FaultLineFile Finish() = 0;
};

std::unique_ptr<FaultLineParser> MakePLineParser();
std::unique_ptr<FaultLineParser> MakeZmapLineParser();
/// Points whose z is among the nulls are left out.
std::unique_ptr<FaultLineParser> MakePlainLineParser(const FaultColumns& columns, const NullValues& nulls);
std::unique_ptr<FaultLineParser> MakeIesxLineParser();
}

#endif
