// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickCollector.h"

#include "Common/LineErrors.h"

#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PickCollector::PickCollector(const TextLayout& layout)
  : Layout(layout)
  , Lines(layout.HeaderLines)
{
  this->Table.Survey = layout.Survey;
  for (const TextColumn& column : layout.Columns)
  {
    if (column.Role == ColumnRole::Attribute)
    {
      this->Table.Attributes.push_back({ column.Name, {} });
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Where the numbers of a column go to.
std::vector<double>& PickCollector::Column(std::size_t column)
{
  switch (this->Layout.Columns[column].Role)
  {
    case ColumnRole::X:
      return this->Table.X;
    case ColumnRole::Y:
      return this->Table.Y;
    case ColumnRole::Z:
      return this->Table.Z;
    case ColumnRole::Inline:
      return this->Table.Inline;
    case ColumnRole::Crossline:
      return this->Table.Crossline;
    default:
      break;
  }
  std::size_t attribute = 0;
  for (std::size_t before = 0; before < column; ++before)
  {
    attribute += this->Layout.Columns[before].Role == ColumnRole::Attribute ? 1 : 0;
  }
  return this->Table.Attributes[attribute].Values;
}

//----------------------------------------------------------------------------------------------------------------------
void PickCollector::Reserve(std::size_t picks)
{
  for (std::size_t column = 0; column < this->Layout.Columns.size(); ++column)
  {
    const ColumnRole role = this->Layout.Columns[column].Role;
    if (role == ColumnRole::HorizonName)
    {
      this->Table.Horizon.reserve(picks);
    }
    else if (role != ColumnRole::Ignored)
    {
      this->Column(column).reserve(picks);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PickCollector::Add(const PickBlock& block)
{
  if (this->HasEnded && block.FirstLine >= 0)
  {
    throw ErrorAt(this->Lines + block.FirstLine + 1, LinesAfterEnd);
  }
  if (block.ErrorLine >= 0)
  {
    throw ErrorAt(this->Lines + block.ErrorLine + 1, block.Error);
  }
  std::size_t picks = block.Horizon.size();
  for (std::size_t column = 0; column < block.Values.size(); ++column)
  {
    const std::vector<double>& values = block.Values[column];
    if (!values.empty())
    {
      std::vector<double>& all = this->Column(column);
      all.insert(all.end(), values.begin(), values.end());
      picks = values.size();
    }
  }
  this->AddNames(block);
  this->Picks += picks;
  this->Lines += block.Lines;
  this->HasEnded = this->HasEnded || block.EndLine >= 0;
}

//----------------------------------------------------------------------------------------------------------------------
void PickCollector::AddNames(const PickBlock& block)
{
  std::vector<int> numbers;
  for (const std::string& name : block.Names)
  {
    const auto [place, isNew] = this->Numbers.emplace(name, int(this->Table.Names.size()));
    if (isNew)
    {
      this->Table.Names.push_back(name);
    }
    numbers.push_back(place->second);
  }
  for (const int number : block.Horizon)
  {
    this->Table.Horizon.push_back(numbers[std::size_t(number)]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
PickTable PickCollector::Take()
{
  if (this->Layout.Picks >= 0 && this->Layout.Picks != std::int64_t(this->Picks))
  {
    throw ErrorAt(this->Lines,
      "end of file after " + std::to_string(this->Picks) + " picks, expected " + std::to_string(this->Layout.Picks));
  }
  if (this->Table.Names.empty())
  {
    this->Table.Names = { this->Layout.HorizonName };
  }
  return std::move(this->Table);
}
}
