// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickBlock.h"

#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::string_view EndMark = "EOD";
}

//----------------------------------------------------------------------------------------------------------------------
void IesxParser::Parse(std::string_view lines)
{
  while (!lines.empty())
  {
    const std::size_t end = lines.find('\n');
    ++this->Line;
    this->ParseLine(lines.substr(0, end));
    lines.remove_prefix(end + 1);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void IesxParser::ParseLine(std::string_view line)
{
  const std::string_view text = Trim(line);
  if (text.empty() || StartsWith(text, "SNAPPING"))
  {
    return;
  }
  if (text == EndMark)
  {
    this->HasEnded = true;
    return;
  }
  if (StartsWith(text, "PROFILE"))
  {
    this->ParseProfile(text);
  }
  else if (this->Profile < 0)
  {
    throw ErrorAt(this->Line, Quote(text) + ", expected a line PROFILE before the first pick");
  }
  else if (line.front() == '\t')
  {
    this->ParseDigits(text);
  }
  else
  {
    this->ParsePick(StartsWith(line, EndMark) ? line.substr(EndMark.size()) : line);
  }
  this->HasEnded = false;
}

//----------------------------------------------------------------------------------------------------------------------
/// A line is "PROFILE Segment          TYPE 1  4                 3d_ci7m.ifdf     m ms".
void IesxParser::ParseProfile(std::string_view line)
{
  constexpr std::size_t keyword = 7;
  const std::size_t type = line.find(" TYPE ");
  if (type == std::string_view::npos || type < keyword || line.substr(type + 6, 1) != "1")
  {
    throw ErrorAt(this->Line, Quote(line) + ", expected a profile of type 1, a horizon");
  }
  const std::string name(Trim(line.substr(keyword, type - keyword)));
  const auto found = std::find(this->Table.Names.begin(), this->Table.Names.end(), name);
  this->Profile = int(found - this->Table.Names.begin());
  if (found == this->Table.Names.end())
  {
    this->Table.Names.push_back(name);
  }
  const std::size_t unit = line.find_last_of(" \t");
  const std::string_view vertical = line.substr(unit + 1);
  const std::string_view before = Trim(line.substr(0, unit));
  const std::string_view horizontal = before.substr(before.find_last_of(" \t") + 1);
  if (horizontal == "m" || horizontal == "ft")
  {
    const bool isTime = vertical == "ms" || vertical == "s";
    this->Table.Survey.HorizontalUnit = std::string(horizontal);
    this->Table.Survey.VerticalUnit = std::string(vertical);
    this->Table.Survey.VerticalDomain = isTime ? "time" : "depth";
  }
}

//----------------------------------------------------------------------------------------------------------------------
double IesxParser::Number(std::string_view line, std::size_t first, std::size_t last, const char* name) const
{
  const std::string_view field = Trim(line.substr(std::min(first - 1, line.size()), last - first + 1));
  double value = 0.0;
  if (field.empty() || ReadAnyNumber(field, value) != NumberKind::Finite)
  {
    throw ErrorAt(this->Line,
      Quote(field) + " as " + name + " in the characters " + std::to_string(first) + " to " + std::to_string(last) +
        ", expected a number");
  }
  return value;
}

//----------------------------------------------------------------------------------------------------------------------
double IesxParser::OrNull(double value) const
{
  return this->Nulls.IsNullNumber(value) ? std::numeric_limits<double>::quiet_NaN() : value;
}

//----------------------------------------------------------------------------------------------------------------------
void IesxParser::ParsePick(std::string_view line)
{
  // Picks of 2D surveys end with the name and version of the line: "NL-07::2".
  const bool is2D = line.size() > 88 && line.find("::", 88) != std::string_view::npos;
  if (!this->Table.X.empty() && is2D == this->Table.HasLines())
  {
    throw ErrorAt(this->Line, "picks of 2D lines and of a 3D survey in one file, expected one of them");
  }
  this->Table.X.push_back(this->Number(line, 1, 16, "X"));
  this->Table.Y.push_back(this->Number(line, 17, 32, "Y"));
  this->Table.Z.push_back(this->OrNull(this->Number(line, 39, 47, "Z")));
  if (is2D)
  {
    this->Amplitudes.push_back(std::numeric_limits<double>::quiet_NaN());
    this->Table.Horizon.push_back(this->Profile);
    return;
  }
  this->Table.Crossline.push_back(this->Number(line, 48, 57, "Crossline"));
  this->Amplitudes.push_back(this->OrNull(this->Number(line, 73, 86, "Amplitude")));
  this->Table.Inline.push_back(this->Number(line, 89, 95, "Inline"));
  this->Table.Horizon.push_back(this->Profile);
}

//----------------------------------------------------------------------------------------------------------------------
/// The line repeats z and the attribute of the previous pick, with more digits.
void IesxParser::ParseDigits(std::string_view line)
{
  FieldCursor fields(line, FieldSeparator::Blanks);
  std::string_view field;
  double value = 0.0;
  for (std::vector<double>* const column : { &this->Table.Z, &this->Amplitudes })
  {
    if (!fields.Next(field))
    {
      return;
    }
    if (column->empty() || ReadAnyNumber(field, value) != NumberKind::Finite)
    {
      throw ErrorAt(this->Line, Quote(line) + ", expected z and the attribute of the pick before");
    }
    column->back() = this->OrNull(value);
  }
}

//----------------------------------------------------------------------------------------------------------------------
PickTable IesxParser::Take()
{
  if (!this->HasEnded)
  {
    throw CutOffAt(this->Line, "end of file without a line EOD, expected one");
  }
  const bool hasAmplitudes =
    std::any_of(this->Amplitudes.begin(), this->Amplitudes.end(), [](double value) { return !std::isnan(value); });
  if (hasAmplitudes)
  {
    this->Table.Attributes.push_back({ "Amplitude", std::move(this->Amplitudes) });
  }
  return std::move(this->Table);
}
}
