// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FieldRole.h"

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
  FieldRole Role;
};

constexpr std::array<KnownName, 95> KnownNames = { { { "x", FieldRole::X }, { "easting", FieldRole::X },
  { "east", FieldRole::X }, { "eastings", FieldRole::X }, { "utmx", FieldRole::X }, { "xutm", FieldRole::X },
  { "xcoord", FieldRole::X }, { "xcoordinate", FieldRole::X }, { "coordx", FieldRole::X }, { "cdpx", FieldRole::X },
  { "xworld", FieldRole::X }, { "worldx", FieldRole::X }, { "xutme", FieldRole::X }, { "y", FieldRole::Y },
  { "northing", FieldRole::Y }, { "north", FieldRole::Y }, { "northings", FieldRole::Y }, { "utmy", FieldRole::Y },
  { "yutm", FieldRole::Y }, { "ycoord", FieldRole::Y }, { "ycoordinate", FieldRole::Y }, { "coordy", FieldRole::Y },
  { "cdpy", FieldRole::Y }, { "yworld", FieldRole::Y }, { "worldy", FieldRole::Y }, { "yutmn", FieldRole::Y },
  { "z", FieldRole::Z }, { "depth", FieldRole::Z }, { "time", FieldRole::Z }, { "twt", FieldRole::Z },
  { "twtms", FieldRole::Z }, { "tvd", FieldRole::Z }, { "tvdss", FieldRole::Z }, { "elevation", FieldRole::Z },
  { "elev", FieldRole::Z }, { "zvalue", FieldRole::Z }, { "zcoord", FieldRole::Z }, { "msl", FieldRole::Z },
  { "inline", FieldRole::Inline }, { "il", FieldRole::Inline }, { "iline", FieldRole::Inline },
  { "inlineno", FieldRole::Inline }, { "inlinenumber", FieldRole::Inline }, { "iln", FieldRole::Inline },
  { "inl", FieldRole::Inline }, { "line", FieldRole::Inline }, { "row", FieldRole::Inline },
  { "crossline", FieldRole::Crossline }, { "xl", FieldRole::Crossline }, { "xline", FieldRole::Crossline },
  { "crosslineno", FieldRole::Crossline }, { "crosslinenumber", FieldRole::Crossline }, { "xln", FieldRole::Crossline },
  { "crl", FieldRole::Crossline }, { "trace", FieldRole::Crossline }, { "column", FieldRole::Crossline },
  { "columninteger", FieldRole::Crossline }, { "rowinteger", FieldRole::Inline }, { "name", FieldRole::HorizonName },
  { "horizon", FieldRole::HorizonName }, { "rechtswert", FieldRole::X }, { "hochwert", FieldRole::Y },
  { "ffid", FieldRole::Inline }, { "cdp", FieldRole::Crossline }, { "horizonname", FieldRole::HorizonName },
  { "horizonid", FieldRole::HorizonName }, { "horizont", FieldRole::HorizonName },
  { "surfacename", FieldRole::HorizonName }, { "surfaceid", FieldRole::HorizonName }, { "sline", FieldRole::Inline },
  { "col", FieldRole::Crossline }, { "oost", FieldRole::X }, { "este", FieldRole::X }, { "leste", FieldRole::X },
  { "ost", FieldRole::X }, { "est", FieldRole::X }, { "noord", FieldRole::Y }, { "norte", FieldRole::Y },
  { "nord", FieldRole::Y }, { "diepte", FieldRole::Z }, { "profundidad", FieldRole::Z },
  { "profundidade", FieldRole::Z }, { "tiefe", FieldRole::Z }, { "profondeur", FieldRole::Z }, { "dyp", FieldRole::Z },
  { "dybde", FieldRole::Z }, { "tijd", FieldRole::Z }, { "tiempo", FieldRole::Z }, { "tempo", FieldRole::Z },
  { "zeit", FieldRole::Z }, { "temps", FieldRole::Z }, { "hoogte", FieldRole::Z }, { "hoehe", FieldRole::Z },
  { "altitude", FieldRole::Z }, { "cota", FieldRole::Z } } };

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

FieldRole RoleOfWords(const Words& words)
{
  if (HasWordOf(AttributeWords, words))
  {
    return FieldRole::Attribute;
  }
  if (HasWordOf(CrosslineWords, words))
  {
    return FieldRole::Crossline;
  }
  if (HasWordOf(InlineWords, words))
  {
    return FieldRole::Inline;
  }
  const bool isPlace = std::all_of(
    words.begin(), words.end(), [](const std::string& word) { return word.empty() || IsIn(PlaceWords, word); });
  const bool hasX = IsIn(words, "x");
  if (isPlace && hasX != IsIn(words, "y"))
  {
    return hasX ? FieldRole::X : FieldRole::Y;
  }
  return HasWordOf(ZWords, words)    ? FieldRole::Z
    : HasWordOf(HorizonWords, words) ? FieldRole::HorizonName
                                     : FieldRole::Attribute;
}
}

//----------------------------------------------------------------------------------------------------------------------
const char* RoleWord(FieldRole role)
{
  switch (role)
  {
    case FieldRole::X:
      return "X";
    case FieldRole::Y:
      return "Y";
    case FieldRole::Z:
      return "Z";
    case FieldRole::Inline:
      return "Inline";
    case FieldRole::Crossline:
      return "Crossline";
    case FieldRole::HorizonName:
      return "Name";
    case FieldRole::Attribute:
      return "Attribute";
    default:
      return "-";
  }
}

//----------------------------------------------------------------------------------------------------------------------
FieldRole RoleOfExactName(std::string_view name)
{
  const std::string essence = Essence(name);
  const auto found = std::find_if(
    KnownNames.begin(), KnownNames.end(), [&essence](const KnownName& known) { return known.Name == essence; });
  return found == KnownNames.end() ? FieldRole::Attribute : found->Role;
}

//----------------------------------------------------------------------------------------------------------------------
FieldRole RoleOfName(std::string_view name)
{
  if (name == "-" || name == "_")
  {
    return FieldRole::Ignored;
  }
  const FieldRole exact = RoleOfExactName(name);
  return exact == FieldRole::Attribute ? RoleOfWords(SplitName(name)) : exact;
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
