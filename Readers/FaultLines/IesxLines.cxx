// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fault sticks and boundaries of IESX, also called GeoQuest and GeoFrame: a line PROFILE with the name of a fault, a line
// per point, and EOD. Sticks have x, y, the number of the stick and z at fixed positions; boundaries are shorter lines
// of x, y, the number of the segment and z.

#include "FaultLineFormats.h"

#include "Common/Text/TextFields.h"

#include <utility>

namespace SeismicHorizons
{
namespace
{
class IesxLineParser : public FaultLineParser
{
public:
  void Take(const NumberedLine& line) override
  {
    const std::string_view text = Trim(line.Text);
    if (StartsWith(text, "PROFILE"))
    {
      this->EndLine();
      const std::string_view rest = text.substr(std::string_view("PROFILE").size());
      this->Fault = std::string(Trim(rest.substr(0, rest.find("TYPE"))));
      this->HasEnded = false;
    }
    else if (StartsWith(text, "EOD"))
    {
      this->EndLine();
      this->HasEnded = true;
    }
    else if (!IsSkipped(text) && !StartsWith(text, "SNAPPING"))
    {
      if (this->HasEnded)
      {
        throw ErrorAt(line.Number, Quote(text) + " after EOD, expected PROFILE or the end of the file");
      }
      this->TakePoint(line);
    }
  }

  FaultLineFile Finish() override
  {
    if (!this->HasEnded)
    {
      throw CutOffAt(this->LastLine, "end of file, expected EOD at the end of fault lines of IESX");
    }
    return std::move(this->File);
  }

private:
  void EndLine()
  {
    this->File.Close(this->Fault, this->Stick);
    this->Stick.clear();
    this->HasPoint = false;
  }

  void TakePoint(const NumberedLine& line)
  {
    constexpr std::size_t fixedSize = 47;
    std::vector<std::string_view> fields = SplitFields(line.Text, FieldSeparator::Blanks);
    if (line.Text.size() >= fixedSize)
    {
      std::string_view stick = line.Text.substr(32, 6);
      stick = Trim(stick).find(' ') == std::string_view::npos ? stick : stick.substr(0, 3);
      fields = { Trim(line.Text.substr(0, 16)), Trim(line.Text.substr(16, 16)), Trim(stick),
        Trim(line.Text.substr(38, 9)) };
    }
    else if (fields.size() < 4)
    {
      throw ErrorAt(line.Number,
        std::to_string(fields.size()) + " fields, expected x, y, the number of the stick or segment, and z");
    }
    const SpacePoint place = { ReadFinite(fields[0], line.Number, "x"), ReadFinite(fields[1], line.Number, "y"),
      ReadFinite(fields[3], line.Number, "z") };
    if (this->HasPoint && fields[2] != this->Stick)
    {
      this->EndLine();
    }
    this->Stick = std::string(fields[2]);
    this->HasPoint = true;
    this->LastLine = line.Number;
    this->File.Append(place);
  }

  FaultLineFile File;
  std::string Fault;
  std::string Stick;
  std::int64_t LastLine = 1;
  bool HasPoint = false;
  bool HasEnded = false;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::unique_ptr<FaultLineParser> MakeIesxLineParser()
{
  return std::make_unique<IesxLineParser>();
}
}
