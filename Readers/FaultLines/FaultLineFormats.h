// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultLineFormats_h
#define SeismicHorizonsFaultLineFormats_h

#include "Common/LineErrors.h"
#include "Common/TextFields.h"
#include "FaultLineFile.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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

/// One for each format. All take all lines.
FaultLineFile ReadPLines(const std::vector<NumberedLine>& lines);
FaultLineFile ReadZmapLines(const std::vector<NumberedLine>& lines);
FaultLineFile ReadPlainLines(const std::vector<NumberedLine>& lines);
}

#endif
