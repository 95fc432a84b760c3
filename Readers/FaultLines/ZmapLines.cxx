// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// ZMAP+ points and polygons: a header gives the character positions of each field, and each point has a line. A new
// segment number starts a polyline.

#include "FaultLineFormats.h"

#include <algorithm>
#include <array>
#include <optional>

namespace SeismicHorizons
{
namespace
{
/// Characters count from 0.
struct ZmapField
{
  std::size_t First = 0;
  std::size_t Size = 0;
};

struct ZmapFields
{
  std::optional<ZmapField> X, Y, Z, Segment;

  std::optional<ZmapField>* Find(int type)
  {
    switch (type)
    {
      case 1:
        return &this->X;
      case 2:
        return &this->Y;
      case 3:
        return &this->Z;
      case 35:
        return &this->Segment;
      default:
        return nullptr;
    }
  }
};

/// The fields are: name, number, type, ?, first character, last character, empty, null value.
void TakeField(const NumberedLine& line, ZmapFields& fields)
{
  FieldCursor cursor(line.Text, FieldSeparator::Comma);
  std::array<std::string_view, 6> parts;
  const bool isWhole =
    std::all_of(parts.begin(), parts.end(), [&cursor](std::string_view& part) { return cursor.Next(part); });
  const int type = isWhole ? ReadPositiveInteger(parts[2]) : 0;
  const int first = isWhole ? ReadPositiveInteger(parts[4]) : 0;
  const int last = isWhole ? ReadPositiveInteger(parts[5]) : 0;
  if (type == 0 || first == 0 || last < first)
  {
    throw ErrorAt(line.Number,
      Quote(Trim(line.Text)) + ", expected a field of ZMAP+: name, number, type, flag, first and last character");
  }
  if (std::optional<ZmapField>* const place = fields.Find(type))
  {
    *place = ZmapField{ std::size_t(first - 1), std::size_t(last - first + 1) };
  }
}

std::string_view Cut(std::string_view text, const ZmapField& field)
{
  return field.First < text.size() ? Trim(text.substr(field.First, field.Size)) : std::string_view();
}

class ZmapLineParser : public FaultLineParser
{
public:
  void Take(const NumberedLine& line) override
  {
    const std::string_view text = Trim(line.Text);
    if (StartsWith(text, "@"))
    {
      ++this->Marks;
      if (this->Marks == 2 && !(this->Fields.X && this->Fields.Y))
      {
        throw ErrorAt(line.Number, "end of the ZMAP+ header, expected fields of the types 1 and 2, x and y");
      }
    }
    else if (!IsSkipped(line.Text) && !IsEndMark(text))
    {
      this->Marks < 2 ? TakeField(line, this->Fields) : this->TakePlace(line);
    }
  }

  FaultLineFile Finish() override
  {
    this->File.Close("", this->Segment);
    return std::move(this->File);
  }

private:
  void TakePlace(const NumberedLine& line)
  {
    const ZmapFields& fields = this->Fields;
    const std::string_view own = fields.Segment ? Cut(line.Text, *fields.Segment) : std::string_view();
    if (own != this->Segment)
    {
      this->File.Close("", this->Segment);
      this->Segment = std::string(own);
    }
    this->File.Append({ ReadFinite(Cut(line.Text, *fields.X), line.Number, "x"),
      ReadFinite(Cut(line.Text, *fields.Y), line.Number, "y"),
      fields.Z ? ReadFinite(Cut(line.Text, *fields.Z), line.Number, "z") : 0.0 });
  }

  FaultLineFile File;
  ZmapFields Fields;
  std::string Segment;
  int Marks = 0; // Lines that begin with @; two of them enclose the header.
};
}

//----------------------------------------------------------------------------------------------------------------------
std::unique_ptr<FaultLineParser> MakeZmapLineParser()
{
  return std::make_unique<ZmapLineParser>();
}
}
