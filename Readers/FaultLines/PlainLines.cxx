// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines of x y z. A polyline ends at an empty line, at 999.0 three times (IRAP, RMS), at a line ->name (CPS-3), or
// where the fields after z change. Charisma sticks have words before and after the coordinates.

#include "FaultLineFormats.h"

#include <array>
#include <cstddef>

namespace SeismicHorizons
{
namespace
{
std::vector<std::string_view> ListLineFields(std::string_view line)
{
  const FieldSeparator separator = line.find(',') != std::string_view::npos ? FieldSeparator::Comma
    : line.find(';') != std::string_view::npos                              ? FieldSeparator::Semicolon
                                                                            : FieldSeparator::Blanks;
  return SplitFields(line, separator);
}

class PlainLineParser : public FaultLineParser
{
public:
  void Take(const NumberedLine& line) override
  {
    const std::string_view text = Trim(line.Text);
    if (text.empty() || IsEndMark(text))
    {
      this->EndLine();
    }
    else if (StartsWith(text, "->"))
    {
      this->EndLine();
      this->Name = std::string(Trim(text.substr(2)));
    }
    else if (!IsSkipped(text))
    {
      this->TakeFields(ListLineFields(text), line.Number);
    }
  }

  FaultLineFile Finish() override
  {
    this->EndLine();
    return std::move(this->File);
  }

private:
  void EndLine()
  {
    this->File.Close(this->Name.empty() ? this->Key : this->Name);
    this->HasPlace = false;
  }

  void TakeFields(const std::vector<std::string_view>& fields, std::int64_t line)
  {
    if (StartsWith(fields.front(), "INLINE") || StartsWith(fields.front(), "CROSSLINE"))
    {
      this->TakeStick(fields, line);
    }
    else if (this->HasPlace || this->File.Places.size() > 0 || IsNumber(fields.front()))
    {
      this->TakePlace(fields, 0, 3, line);
    }
    // Other lines before the first point are headings.
  }

  /// The fields are: INLINE- inline crossline x y z name stick. Names may contain blanks.
  void TakeStick(const std::vector<std::string_view>& fields, std::int64_t line)
  {
    constexpr std::size_t FewestFields = 8;
    if (fields.size() < FewestFields)
    {
      throw ErrorAt(line,
        std::to_string(fields.size()) +
          " fields of a fault stick, expected 8: INLINE-, inline, crossline, x, y, z, "
          "name and number");
    }
    this->TakePlace(fields, 3, 6, line);
  }

  /// The coordinates start at field `first`. The fields from `rest` on identify the polyline.
  void TakePlace(const std::vector<std::string_view>& fields, std::size_t first, std::size_t rest, std::int64_t line)
  {
    if (fields.size() < rest)
    {
      throw ErrorAt(line, std::to_string(fields.size()) + " fields, expected x, y and z");
    }
    const SpacePoint place = { ReadFinite(fields[first], line, "x"), ReadFinite(fields[first + 1], line, "y"),
      ReadFinite(fields[first + 2], line, "z") };
    if (place.X == EndOfPart && place.Y == EndOfPart && place.Z == EndOfPart)
    {
      this->EndLine();
      return;
    }
    std::string key;
    for (std::size_t n = rest; n < fields.size(); ++n)
    {
      key += (n > rest ? " " : "") + std::string(fields[n]);
    }
    if (this->HasPlace && key != this->Key)
    {
      this->EndLine();
    }
    this->Key = key;
    this->HasPlace = true;
    this->File.Append(place);
  }

  FaultLineFile File;
  std::string Name;
  std::string Key;
  bool HasPlace = false;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::unique_ptr<FaultLineParser> MakePlainLineParser()
{
  return std::make_unique<PlainLineParser>();
}
}
