// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextLayout.h"

#include "Common/Survey/Units.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"

#include <algorithm>
#include <array>
#include <set>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<const char*, 11> KindNames = { "plain text", "OpendTect", "OpenWorks", "EarthVision",
  "Petrel points with attributes", "RMS attributes", "Charisma", "lattice indices", "IESX", "matrix of heights",
  "points of GOCAD" };
constexpr std::array<const char*, 5> SeparatorNames = { "blanks", "blanks and colons", "tabs", "commas", "semicolons" };

std::string Word(const TextColumn& column)
{
  return column.Role == FieldRole::Attribute ? column.Name : RoleWord(column.Role);
}

/// Repeated names of attributes get a number: "Amplitude 2".
void NumberDoubles(std::vector<TextColumn>& columns)
{
  std::set<std::string> names;
  for (TextColumn& column : columns)
  {
    const std::string name = column.Name;
    for (int number = 2; column.Role == FieldRole::Attribute && !names.insert(column.Name).second; ++number)
    {
      column.Name = name + " " + std::to_string(number);
    }
  }
}

void KeepOneZ(std::vector<TextColumn>& columns)
{
  std::vector<std::string> names;
  std::vector<TextColumn*> candidates;
  for (TextColumn& column : columns)
  {
    if (column.Role == FieldRole::Z)
    {
      names.push_back(column.Name);
      candidates.push_back(&column);
    }
  }
  const std::size_t chosen = names.size() > 1 ? ChooseZ(names, "Columns") : 0;
  for (std::size_t n = 0; n < candidates.size(); ++n)
  {
    candidates[n]->Role = n == chosen ? FieldRole::Z : FieldRole::Attribute;
  }
}

/// Several fields that may be z are an InputError.
void NameOnlyZ(std::vector<TextColumn>& columns)
{
  const auto mayBe = [](const TextColumn& column)
  { return column.Role == FieldRole::Attribute && !IsNeverZ(column.Name); };
  const auto first = std::find_if(columns.begin(), columns.end(), mayBe);
  const auto second = first == columns.end() ? first : std::find_if(first + 1, columns.end(), mayBe);
  if (second != columns.end())
  {
    throw InputError(
      Excerpt(first->Name) + " and " + Excerpt(second->Name) + " could both be Z, expected one of them: set Columns");
  }
  if (first != columns.end())
  {
    first->Role = FieldRole::Z;
  }
}

bool Has(const std::vector<TextColumn>& columns, FieldRole role)
{
  return std::any_of(columns.begin(), columns.end(), [role](const TextColumn& column) { return column.Role == role; });
}

/// x without y becomes an attribute, as does y without x.
void MakeAttributeOfHalf(std::vector<TextColumn>& columns, FieldRole one, FieldRole other)
{
  for (TextColumn& column : columns)
  {
    const bool isAlone = (column.Role == one && !Has(columns, other)) || (column.Role == other && !Has(columns, one));
    column.Role = isAlone ? FieldRole::Attribute : column.Role;
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
TextColumn ColumnOfName(std::string_view name)
{
  if (name.empty())
  {
    return { FieldRole::Ignored, "-" };
  }
  return { RoleOfName(name), std::string(name) };
}

//----------------------------------------------------------------------------------------------------------------------
std::string_view UnitOfName(std::string_view name)
{
  name = Trim(name);
  const bool hasBrackets = !name.empty() && (name.back() == ')' || name.back() == ']');
  const std::size_t before = name.find_last_of(hasBrackets ? "([" : "_ ");
  if (before == std::string_view::npos)
  {
    return {};
  }
  const std::string_view unit = Trim(name.substr(before + 1, name.size() - before - (hasBrackets ? 2 : 1)));
  const std::string brief = ShortUnit(unit);
  return brief == "m" || brief == "ft" || brief == "ms" || brief == "s" ? unit : std::string_view();
}

//----------------------------------------------------------------------------------------------------------------------
std::string_view DomainOfName(std::string_view name)
{
  const std::string lower = ToLower(name);
  const auto has = [&lower](const char* word) { return lower.find(word) != std::string::npos; };
  return has("twt") || has("time") ? "time" : has("depth") || has("tvd") ? "depth" : "";
}

//----------------------------------------------------------------------------------------------------------------------
void DescribeZ(SurveyDescription& survey, std::string_view name, std::string_view unit)
{
  survey.VerticalDomain = survey.VerticalDomain.empty() ? DomainOfName(name) : survey.VerticalDomain;
  if (survey.VerticalUnit.empty())
  {
    SetVerticalUnit(survey, unit.empty() ? UnitOfName(name) : unit);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SettleRoles(std::vector<TextColumn>& columns)
{
  KeepOneZ(columns);
  std::set<FieldRole> roles;
  for (TextColumn& column : columns)
  {
    const bool isSingle = column.Role != FieldRole::Attribute && column.Role != FieldRole::Ignored;
    if (isSingle && !roles.insert(column.Role).second)
    {
      column.Role = FieldRole::Attribute;
    }
  }
  if (!Has(columns, FieldRole::Z))
  {
    NameOnlyZ(columns);
  }
  MakeAttributeOfHalf(columns, FieldRole::X, FieldRole::Y);
  MakeAttributeOfHalf(columns, FieldRole::Inline, FieldRole::Crossline);
  NumberDoubles(columns);
}

//----------------------------------------------------------------------------------------------------------------------
void CheckRoles(const std::vector<TextColumn>& columns)
{
  const bool hasPlaces = Has(columns, FieldRole::X) && Has(columns, FieldRole::Y);
  const bool hasLines = Has(columns, FieldRole::Inline) && Has(columns, FieldRole::Crossline);
  if (!Has(columns, FieldRole::Z) || !(hasPlaces || hasLines))
  {
    throw InputError("columns " + ListNames(columns) +
      ", expected Z, and X and Y or Inline and Crossline: set Columns, or "
      "HeaderLines for lines above the picks");
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TextColumn> ParseColumnList(const std::string& list)
{
  const bool hasCommas = list.find(',') != std::string::npos;
  std::vector<TextColumn> columns;
  FieldCursor fields(list, hasCommas ? FieldSeparator::Comma : FieldSeparator::Blanks);
  std::string_view field;
  std::set<std::string> words;
  while (fields.Next(field))
  {
    columns.push_back(ColumnOfName(Trim(field)));
    const std::string word = Word(columns.back());
    if (columns.back().Role != FieldRole::Ignored && !words.insert(word).second)
    {
      throw InputError("columns " + list + ", expected " + word + " once");
    }
  }
  CheckRoles(columns);
  return columns;
}

//----------------------------------------------------------------------------------------------------------------------
std::string ListNames(const std::vector<TextColumn>& columns)
{
  constexpr std::size_t mostNamed = 20;
  std::string names;
  for (std::size_t column = 0; column < std::min(mostNamed, columns.size()); ++column)
  {
    names += (column == 0 ? "" : ", ") + Excerpt(Word(columns[column]));
  }
  names += columns.size() > mostNamed ? ", ... (" + std::to_string(columns.size()) + " columns)" : "";
  return names.empty() ? "(none)" : names;
}

//----------------------------------------------------------------------------------------------------------------------
void TextLayout::ChooseLines(const std::string& where, const std::vector<TextColumn>& columns)
{
  const std::size_t sign = std::min(where.find('='), where.size());
  const std::string name = ToLower(Trim(where.substr(0, sign)));
  const auto found = std::find_if(
    columns.begin(), columns.end(), [&name](const TextColumn& column) { return ToLower(column.Name) == name; });
  if (sign == where.size() || found == columns.end())
  {
    throw InputError("Where " + Quote(where) + ", expected COLUMN=VALUE with one of the columns " + ListNames(columns) +
      ": Columns names them");
  }
  this->WhereColumn = int(found - columns.begin());
  this->WhereValue = Trim(where.substr(sign + 1));
}

//----------------------------------------------------------------------------------------------------------------------
bool TextLayout::IsChosen(std::string_view line) const
{
  const std::vector<std::string_view> fields = SplitFields(line, this->Separator);
  return std::size_t(this->WhereColumn) < fields.size() && fields[std::size_t(this->WhereColumn)] == this->WhereValue;
}

//----------------------------------------------------------------------------------------------------------------------
int TextLayout::Find(FieldRole role) const
{
  const auto found = std::find_if(
    this->Columns.begin(), this->Columns.end(), [role](const TextColumn& column) { return column.Role == role; });
  return found == this->Columns.end() ? -1 : int(found - this->Columns.begin());
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t TextLayout::CountUsed(bool withAttributes) const
{
  const auto last = std::find_if(this->Columns.rbegin(), this->Columns.rend(),
    [=](const TextColumn& column)
    { return column.Role < FieldRole::Attribute || (withAttributes && column.Role == FieldRole::Attribute); });
  return std::size_t(this->Columns.rend() - last);
}

//----------------------------------------------------------------------------------------------------------------------
std::string TextLayout::Describe(std::int64_t otherLines) const
{
  std::string text = KindNames[std::size_t(this->Kind)];
  if (this->Kind != TextKind::Iesx && this->Kind != TextKind::VSet)
  {
    text += std::string(", separated by ") + SeparatorNames[std::size_t(this->Separator)];
  }
  text += ": " +
    (this->Kind == TextKind::Matrix ? std::to_string(this->Columns.size()) + " columns" : ListNames(this->Columns));
  return text + (otherLines > 0 ? "; " + std::to_string(otherLines) + " lines of other kinds left out" : "");
}
}
