// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnNames.h"

#include "Common/Errors.h"
#include "TextFields.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

namespace SeismicHorizons
{
namespace
{
struct KnownName
{
  std::string_view Name; // letters and digits, small
  ColumnRole Role;
};

constexpr std::array<KnownName, 60> KnownNames = { { { "x", ColumnRole::X }, { "easting", ColumnRole::X },
  { "east", ColumnRole::X }, { "eastings", ColumnRole::X }, { "utmx", ColumnRole::X }, { "xutm", ColumnRole::X },
  { "xcoord", ColumnRole::X }, { "xcoordinate", ColumnRole::X }, { "coordx", ColumnRole::X }, { "cdpx", ColumnRole::X },
  { "xworld", ColumnRole::X }, { "worldx", ColumnRole::X }, { "xutme", ColumnRole::X }, { "y", ColumnRole::Y },
  { "northing", ColumnRole::Y }, { "north", ColumnRole::Y }, { "northings", ColumnRole::Y }, { "utmy", ColumnRole::Y },
  { "yutm", ColumnRole::Y }, { "ycoord", ColumnRole::Y }, { "ycoordinate", ColumnRole::Y }, { "coordy", ColumnRole::Y },
  { "cdpy", ColumnRole::Y }, { "yworld", ColumnRole::Y }, { "worldy", ColumnRole::Y }, { "yutmn", ColumnRole::Y },
  { "z", ColumnRole::Z }, { "depth", ColumnRole::Z }, { "time", ColumnRole::Z }, { "twt", ColumnRole::Z },
  { "twtms", ColumnRole::Z }, { "tvd", ColumnRole::Z }, { "tvdss", ColumnRole::Z }, { "elevation", ColumnRole::Z },
  { "elev", ColumnRole::Z }, { "zvalue", ColumnRole::Z }, { "zcoord", ColumnRole::Z }, { "msl", ColumnRole::Z },
  { "inline", ColumnRole::Inline }, { "il", ColumnRole::Inline }, { "iline", ColumnRole::Inline },
  { "inlineno", ColumnRole::Inline }, { "inlinenumber", ColumnRole::Inline }, { "iln", ColumnRole::Inline },
  { "inl", ColumnRole::Inline }, { "line", ColumnRole::Inline }, { "row", ColumnRole::Inline },
  { "crossline", ColumnRole::Crossline }, { "xl", ColumnRole::Crossline }, { "xline", ColumnRole::Crossline },
  { "crosslineno", ColumnRole::Crossline }, { "crosslinenumber", ColumnRole::Crossline },
  { "xln", ColumnRole::Crossline }, { "crl", ColumnRole::Crossline }, { "trace", ColumnRole::Crossline },
  { "column", ColumnRole::Crossline }, { "columninteger", ColumnRole::Crossline }, { "rowinteger", ColumnRole::Inline },
  { "name", ColumnRole::HorizonName }, { "horizon", ColumnRole::HorizonName } } };

/// Letters and digits of a name, in small letters, without what is in brackets: units mostly.
std::string Essence(std::string_view name)
{
  std::string essence;
  for (const char c : name.substr(0, name.find_first_of("([{", 1)))
  {
    if (std::isalnum(static_cast<unsigned char>(c)))
    {
      essence += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return essence;
}

/// What a column is called: by its role, or by its own name.
std::string Word(const TextColumn& column)
{
  return column.Role == ColumnRole::Attribute ? column.Name : RoleWord(column.Role);
}

bool Has(const std::vector<TextColumn>& columns, ColumnRole role)
{
  return std::any_of(columns.begin(), columns.end(), [role](const TextColumn& column) { return column.Role == role; });
}
}

//----------------------------------------------------------------------------------------------------------------------
const char* RoleWord(ColumnRole role)
{
  switch (role)
  {
    case ColumnRole::X:
      return "X";
    case ColumnRole::Y:
      return "Y";
    case ColumnRole::Z:
      return "Z";
    case ColumnRole::Inline:
      return "Inline";
    case ColumnRole::Crossline:
      return "Crossline";
    case ColumnRole::HorizonName:
      return "Name";
    case ColumnRole::Attribute:
      return "Attribute";
    default:
      return "-";
  }
}

//----------------------------------------------------------------------------------------------------------------------
TextColumn ColumnOfName(std::string_view name)
{
  if (name == "-")
  {
    return { ColumnRole::Ignored, "-" };
  }
  const std::string essence = Essence(name);
  const auto found = std::find_if(
    KnownNames.begin(), KnownNames.end(), [&essence](const KnownName& known) { return known.Name == essence; });
  if (found == KnownNames.end())
  {
    return { ColumnRole::Attribute, std::string(name) };
  }
  return { found->Role, std::string(name) };
}

//----------------------------------------------------------------------------------------------------------------------
void SettleRoles(std::vector<TextColumn>& columns)
{
  std::set<ColumnRole> roles;
  for (TextColumn& column : columns)
  {
    const bool isSingle = column.Role != ColumnRole::Attribute && column.Role != ColumnRole::Ignored;
    if (isSingle && !roles.insert(column.Role).second)
    {
      column.Role = ColumnRole::Attribute;
    }
  }
  const auto attribute = std::find_if(
    columns.begin(), columns.end(), [](const TextColumn& column) { return column.Role == ColumnRole::Attribute; });
  if (!Has(columns, ColumnRole::Z) && attribute != columns.end())
  {
    attribute->Role = ColumnRole::Z;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CheckRoles(const std::vector<TextColumn>& columns)
{
  const bool hasPlaces = Has(columns, ColumnRole::X) && Has(columns, ColumnRole::Y);
  const bool hasLines = Has(columns, ColumnRole::Inline) && Has(columns, ColumnRole::Crossline);
  if (!Has(columns, ColumnRole::Z) || !(hasPlaces || hasLines))
  {
    throw InputError("columns " + ListNames(columns) + ", expected Z, and X and Y or Inline and Crossline");
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
    if (columns.back().Role != ColumnRole::Ignored && !words.insert(word).second)
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
  std::string names;
  for (const TextColumn& column : columns)
  {
    names += (names.empty() ? "" : ", ") + Word(column);
  }
  return names.empty() ? "(none)" : names;
}
}
