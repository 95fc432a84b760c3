// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnRole.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace SeismicHorizons
{
namespace
{
struct KnownName
{
  std::string_view Name; // letters and digits in lower case
  ColumnRole Role;
};

constexpr std::array<KnownName, 95> KnownNames = { { { "x", ColumnRole::X }, { "easting", ColumnRole::X },
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
  { "name", ColumnRole::HorizonName }, { "horizon", ColumnRole::HorizonName }, { "rechtswert", ColumnRole::X },
  { "hochwert", ColumnRole::Y }, { "ffid", ColumnRole::Inline }, { "cdp", ColumnRole::Crossline },
  { "horizonname", ColumnRole::HorizonName }, { "horizonid", ColumnRole::HorizonName },
  { "horizont", ColumnRole::HorizonName }, { "surfacename", ColumnRole::HorizonName },
  { "surfaceid", ColumnRole::HorizonName }, { "sline", ColumnRole::Inline }, { "col", ColumnRole::Crossline },
  { "oost", ColumnRole::X }, { "este", ColumnRole::X }, { "leste", ColumnRole::X }, { "ost", ColumnRole::X },
  { "est", ColumnRole::X }, { "noord", ColumnRole::Y }, { "norte", ColumnRole::Y }, { "nord", ColumnRole::Y },
  { "diepte", ColumnRole::Z }, { "profundidad", ColumnRole::Z }, { "profundidade", ColumnRole::Z },
  { "tiefe", ColumnRole::Z }, { "profondeur", ColumnRole::Z }, { "dyp", ColumnRole::Z }, { "dybde", ColumnRole::Z },
  { "tijd", ColumnRole::Z }, { "tiempo", ColumnRole::Z }, { "tempo", ColumnRole::Z }, { "zeit", ColumnRole::Z },
  { "temps", ColumnRole::Z }, { "hoogte", ColumnRole::Z }, { "hoehe", ColumnRole::Z }, { "altitude", ColumnRole::Z },
  { "cota", ColumnRole::Z } } };

using Words = std::vector<std::string>;

/// A name with such a word is an attribute: "Thickness (depth)", "Time gradient".
constexpr std::array<std::string_view, 34> AttributeWords = { "thickness", "thick", "isochore", "isopach", "isochron",
  "error", "std", "stdev", "sigma", "uncertainty", "dip", "azimuth", "amplitude", "amp", "rms", "diff", "difference",
  "delta", "residual", "velocity", "vel", "gradient", "date", "md", "objectid", "fid", "oid", "confidence", "quality",
  "index", "count", "shift", "offset", "curvature" };
/// Such a field is z only if no other field can be.
constexpr std::array<std::string_view, 22> OtherWords = { "id", "pointid", "nr", "no", "num", "number", "sp", "line",
  "row", "col", "column", "trace", "flag", "status", "type", "method", "user", "author", "remark", "comment", "seismic",
  "pick" };
constexpr std::array<std::string_view, 5> InlineWords = { "inline", "iline", "il", "iln", "inl" };
constexpr std::array<std::string_view, 5> CrosslineWords = { "crossline", "xline", "xl", "xln", "crl" };
constexpr std::array<std::string_view, 10> ZWords = { "z", "twt", "owt", "tvd", "tvdss", "depth", "time", "elevation",
  "elev", "msl" };
constexpr std::array<std::string_view, 12> HorizonWords = { "horizon", "hor", "hrz", "formation", "surface", "surf",
  "marker", "strat", "unit", "event", "interp", "layer" };
// May accompany "x" or "y".
constexpr std::array<std::string_view, 14> PlaceWords = { "x", "y", "point", "coord", "coordinate", "cdp", "utm",
  "world", "map", "loc", "location", "pos", "position", "m" };

/// Text in brackets is mostly a unit.
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

Words SplitName(std::string_view name)
{
  Words words(1);
  for (const char c : name.substr(0, name.find_first_of("([{", 1)))
  {
    if (std::isalnum(static_cast<unsigned char>(c)))
    {
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    else if (!words.back().empty())
    {
      words.emplace_back();
    }
  }
  return words;
}

template <typename List>
bool IsIn(const List& list, std::string_view word)
{
  return std::find(list.begin(), list.end(), word) != list.end();
}

template <typename List>
bool HasWordOf(const List& list, const Words& words)
{
  return std::any_of(words.begin(), words.end(), [&list](const std::string& word) { return IsIn(list, word); });
}

ColumnRole RoleOfWords(const Words& words)
{
  if (HasWordOf(AttributeWords, words))
  {
    return ColumnRole::Attribute;
  }
  if (HasWordOf(CrosslineWords, words))
  {
    return ColumnRole::Crossline;
  }
  if (HasWordOf(InlineWords, words))
  {
    return ColumnRole::Inline;
  }
  const bool isPlace = std::all_of(
    words.begin(), words.end(), [](const std::string& word) { return word.empty() || IsIn(PlaceWords, word); });
  const bool hasX = IsIn(words, "x");
  if (isPlace && hasX != IsIn(words, "y"))
  {
    return hasX ? ColumnRole::X : ColumnRole::Y;
  }
  return HasWordOf(ZWords, words)    ? ColumnRole::Z
    : HasWordOf(HorizonWords, words) ? ColumnRole::HorizonName
                                     : ColumnRole::Attribute;
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
ColumnRole RoleOfExactName(std::string_view name)
{
  const std::string essence = Essence(name);
  const auto found = std::find_if(
    KnownNames.begin(), KnownNames.end(), [&essence](const KnownName& known) { return known.Name == essence; });
  return found == KnownNames.end() ? ColumnRole::Attribute : found->Role;
}

//----------------------------------------------------------------------------------------------------------------------
ColumnRole RoleOfName(std::string_view name)
{
  if (name == "-")
  {
    return ColumnRole::Ignored;
  }
  const ColumnRole exact = RoleOfExactName(name);
  return exact == ColumnRole::Attribute ? RoleOfWords(SplitName(name)) : exact;
}

//----------------------------------------------------------------------------------------------------------------------
bool IsNeverZ(std::string_view name)
{
  const Words words = SplitName(name);
  return HasWordOf(AttributeWords, words) || HasWordOf(OtherWords, words);
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t ChooseZ(const std::vector<std::string>& names, const char* remedy)
{
  const auto plain =
    std::find_if(names.begin(), names.end(), [](const std::string& name) { return Essence(name) == "z"; });
  if (plain != names.end())
  {
    return std::size_t(plain - names.begin());
  }
  for (const std::string& name : names)
  {
    if (Essence(name) != Essence(names.front()))
    {
      throw InputError(names.front() + " and " + name + " could both be Z, expected one of them: set " + remedy);
    }
  }
  return 0;
}
}
