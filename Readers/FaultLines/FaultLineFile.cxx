// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultLineFile.h"

#include "FaultLineFormats.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
std::vector<NumberedLine> ListLines(std::string_view text)
{
  std::vector<NumberedLine> lines;
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back({ text.substr(0, end), std::int64_t(lines.size()) + 1 });
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

FaultLineFile ReadLines(const std::vector<NumberedLine>& lines)
{
  const auto first =
    std::find_if(lines.begin(), lines.end(), [](const NumberedLine& line) { return !IsSkipped(line.Text); });
  if (first == lines.end())
  {
    throw CutOffAt(std::max<std::int64_t>(1, std::int64_t(lines.size())), "end of file, expected fault lines");
  }
  const std::string_view text = Trim(first->Text);
  return StartsWith(text, "GOCAD") ? ReadPLines(lines)
    : StartsWith(text, "@")        ? ReadZmapLines(lines)
                                   : ReadPlainLines(lines);
}
}

//----------------------------------------------------------------------------------------------------------------------
double ReadFinite(std::string_view field, std::int64_t line, const char* what)
{
  double value = 0.0;
  if (ReadNumber(field, value) != NumberKind::Finite)
  {
    throw ErrorAt(line, Quote(field) + ", expected a finite number, " + what);
  }
  return value;
}

//----------------------------------------------------------------------------------------------------------------------
FaultLineFile ReadFaultLines(std::string text)
{
  const std::vector<NumberedLine> lines = ListLines(WithoutByteOrderMark(text));
  FaultLineFile file = ReadLines(lines);
  if (file.Ends.empty())
  {
    throw CutOffAt(std::int64_t(lines.size()), "end of file, expected a fault line of two points at least");
  }
  return file;
}
}
