// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnRole.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

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
ColumnRole RoleOfName(std::string_view name)
{
  if (name == "-")
  {
    return ColumnRole::Ignored;
  }
  const std::string essence = Essence(name);
  const auto found = std::find_if(
    KnownNames.begin(), KnownNames.end(), [&essence](const KnownName& known) { return known.Name == essence; });
  return found == KnownNames.end() ? ColumnRole::Attribute : found->Role;
}
}
