// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Text/LineErrors.h"
#include "GridParsers.h"
#include "GxfHeader.h"
#include "HeaderFields.h"

#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr int Base = 90;
constexpr char Zero = '%'; // The other digits follow in ASCII.
constexpr char NoValue = '!'; // starts a group without value
constexpr char Repeat = '"'; // Groups with a count and with the repeated value follow.

/// Values in base 90 have no separators.
class CompressedValues
{
public:
  CompressedValues(GridText& text, const GxfHeader& header)
    : Text(text)
    , Header(header)
    , Count(CountNodes(header.Lattice.Columns))
    , GroupSize(static_cast<std::size_t>(header.GroupSize))
  {
  }

  std::vector<double> Read()
  {
    while (this->Found() < this->Count)
    {
      const std::string_view group = this->NextGroup();
      const bool isRepeated = group.front() == Repeat;
      const std::int64_t times = isRepeated ? this->ReadRepeat() : 1;
      this->Append(times, isRepeated ? this->NextGroup() : group);
    }
    if (!this->Rest.empty())
    {
      throw this->Text.Error(Quote(this->Rest) + " after the last value, expected the end of the line");
    }
    this->Text.NextLine();
    return std::move(this->Values);
  }

private:
  std::int64_t Found() const { return static_cast<std::int64_t>(this->Values.size()); }

  std::string_view NextGroup()
  {
    while (this->Rest.empty())
    {
      if (!this->IsFirstLine)
      {
        this->Text.NextLine();
      }
      this->IsFirstLine = false;
      const std::optional<std::string_view> line = this->Text.PeekLine();
      if (!line)
      {
        throw this->Text.EndError(this->Found(), this->Count);
      }
      this->Rest = Trim(*line);
    }
    const std::string_view group = this->Rest.substr(0, this->GroupSize);
    if (group.size() < this->GroupSize)
    {
      throw this->Text.Error(Quote(group) + " at the end of the line, expected groups of " +
        std::to_string(this->GroupSize) + " characters");
    }
    this->Rest.remove_prefix(this->GroupSize);
    ++this->Groups;
    return group;
  }

  std::int64_t Decode(std::string_view group) const
  {
    std::int64_t number = 0;
    for (const char c : group)
    {
      if (c < Zero || c >= Zero + Base)
      {
        throw this->Text.Error("value " + Quote(group) + ", expected digits to the base 90");
      }
      number = Base * number + (c - Zero);
    }
    return number;
  }

  std::int64_t ReadRepeat()
  {
    const std::int64_t times = this->Decode(this->NextGroup());
    if (times > this->Count - this->Found())
    {
      throw this->Text.Error(
        "a value " + std::to_string(times) + " times, expected at most " + std::to_string(this->Count - this->Found()));
    }
    PrefixErrors(this->Text.Place(), [&] { RequirePoints(this->Found() + times, this->Groups); });
    return times;
  }

  void Append(std::int64_t times, std::string_view group)
  {
    const double z = group.front() == NoValue
      ? std::numeric_limits<double>::quiet_NaN()
      : static_cast<double>(this->Decode(group)) * this->Header.Scale + this->Header.Offset;
    if (std::isinf(z))
    {
      throw this->Text.Error("value " + Quote(group) + ", expected a finite number after #TRANSFORM");
    }
    this->Values.insert(this->Values.end(), static_cast<std::size_t>(times), z);
  }

  GridText& Text;
  const GxfHeader& Header;
  const std::int64_t Count;
  const std::size_t GroupSize;
  std::string_view Rest;
  bool IsFirstLine = true;
  std::int64_t Groups = 0;
  std::vector<double> Values;
};

std::vector<double> ReadPlainValues(GridText& text, const GxfHeader& header)
{
  std::vector<double> values = text.Values(CountNodes(header.Lattice.Columns), header.IsNull);
  for (double& z : values)
  {
    z = z * header.Scale + header.Offset;
    if (std::isinf(z))
    {
      throw text.Error("a value too large, expected a finite number after #TRANSFORM");
    }
  }
  return values;
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadGxf(GridText& text)
{
  HorizonGrid grid;
  const GxfHeader header = ReadGxfHeader(text);
  grid.Name = header.Name;
  grid.Survey = header.Survey;
  grid.Lattice = header.Lattice;
  std::vector<double> values =
    header.GroupSize > 0 ? CompressedValues(text, header).Read() : ReadPlainValues(text, header);
  text.RequireEnd("#!");
  grid.Z = Arrange(std::move(values), grid.Lattice.Columns, header.Order);
  return grid;
}
}
