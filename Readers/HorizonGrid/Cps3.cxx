// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridParsers.h"
#include "HeaderFields.h"

#include <algorithm>
#include <map>

namespace SeismicHorizons
{
namespace
{
// Word of FSASCI; some programs write a seventh word.
constexpr std::size_t NullWord = 5;
constexpr double AlwaysNull = 1e30;

struct Cps3Header
{
  std::map<std::string, HeaderFields> Lines;
  std::string Name;
};

Cps3Header ReadCps3Header(GridText& text)
{
  Cps3Header header;
  for (; text.PeekLine(); text.NextLine())
  {
    const std::string_view line = Trim(*text.PeekLine());
    if (line.substr(0, 2) == "->")
    {
      header.Name = Trim(Unquote(line.substr(2)));
    }
    else if (line.substr(0, 2) == "FS")
    {
      std::vector<std::string> words = SplitAtBlanksAndCommas(line);
      const std::string keyword = words[0];
      header.Lines.insert_or_assign(keyword, HeaderFields(text.Place(), std::move(words)));
    }
    else if (!line.empty() && line.front() != '!')
    {
      break;
    }
  }
  return header;
}

const HeaderFields& RequireLine(const Cps3Header& header, const char* keyword, const GridText& text)
{
  const auto line = header.Lines.find(keyword);
  if (line == header.Lines.end())
  {
    throw text.Error("no line " + std::string(keyword) + ", expected one before the values");
  }
  return line->second;
}
}

//----------------------------------------------------------------------------------------------------------------------
/// The steps of FSXINC are ignored, since some programs swap them; the limits imply them.
HorizonGrid ReadCps3(GridText& text)
{
  HorizonGrid grid;
  const Cps3Header header = ReadCps3Header(text);
  grid.Name = header.Name;
  const HeaderFields& format = RequireLine(header, "FSASCI", text);
  const double null = format.Number(std::min(NullWord, format.Size() - 1), "null value");
  const HeaderFields& limits = RequireLine(header, "FSLIMI", text);
  const std::array<double, 2> x = { limits.Number(1, "xmin"), limits.Number(2, "xmax") };
  const std::array<double, 2> y = { limits.Number(3, "ymin"), limits.Number(4, "ymax") };
  const HeaderFields& counts = RequireLine(header, "FSNROW", text);
  const std::array<int, 2> columns = { counts.Count(2, "nx"), counts.Count(1, "ny") };
  grid.Lattice = PrefixErrors(limits.Place(), [&] { return AxisLattice(columns, x, y); });
  StorageOrder order;
  order.AlongY = true;
  order.FromTop = true;
  std::vector<double> values = text.Values(CountNodes(columns), OrFrom(NullAt(null), AlwaysNull));
  text.RequireEnd();
  grid.Z = Arrange(std::move(values), columns, order);
  return grid;
}
}
