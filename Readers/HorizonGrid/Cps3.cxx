// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridParsers.h"
#include "GridText.h"
#include "HeaderFields.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
// Word of FSASCI; some programs write a seventh word.
constexpr std::size_t NullWord = 5;
constexpr double AlwaysNull = 1e30;

KeywordLines ReadCps3Header(GridText& text, std::string& name)
{
  KeywordLines lines;
  for (; text.PeekLine(); text.NextLine())
  {
    const std::string_view line = Trim(*text.PeekLine());
    if (line.substr(0, 2) == "->")
    {
      name = Trim(Unquote(line.substr(2)));
    }
    else if (line.substr(0, 2) == "FS")
    {
      std::vector<std::string> words = SplitAtBlanksAndCommas(line);
      const std::string keyword = words[0];
      lines.insert_or_assign(keyword, HeaderFields(text.Place(), std::move(words)));
    }
    else if (!line.empty() && line.front() != '!')
    {
      break;
    }
  }
  return lines;
}
}

//----------------------------------------------------------------------------------------------------------------------
/// The steps of FSXINC are ignored, since some programs swap them; the limits imply them.
HorizonGrid ReadCps3(GridText& text)
{
  HorizonGrid grid;
  const KeywordLines header = ReadCps3Header(text, grid.Name);
  const HeaderFields& format = RequireKeyword(header, "FSASCI", text.Place());
  const double null = format.Number(std::min(NullWord, format.Size() - 1), "null value");
  const HeaderFields& limits = RequireKeyword(header, "FSLIMI", text.Place());
  const std::array<double, 2> x = { limits.Number(1, "xmin"), limits.Number(2, "xmax") };
  const std::array<double, 2> y = { limits.Number(3, "ymin"), limits.Number(4, "ymax") };
  const HeaderFields& counts = RequireKeyword(header, "FSNROW", text.Place());
  const std::array<int, 2> columns = { counts.Count(2, "nx"), counts.Count(1, "ny") };
  grid.Lattice = PrefixErrors(limits.Place(), [&] { return AxisLattice(columns, x, y); });
  std::vector<double> values = text.Values(CountNodes(columns), OrFrom(NullAt(null), AlwaysNull));
  text.RequireEnd();
  grid.Z = Arrange(std::move(values), columns, ColumnsFromTop);
  return grid;
}
}
