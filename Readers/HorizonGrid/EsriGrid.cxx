// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridParsers.h"
#include "HeaderFields.h"

#include <map>

namespace SeismicHorizons
{
namespace
{
constexpr double UsualNull = -9999.0;

using EsriHeader = std::map<std::string, HeaderFields>;

bool IsSmallLetter(char c)
{
  return c >= 'a' && c <= 'z';
}

/// Stops at the first line of values, which may start with the word nan.
EsriHeader ReadEsriHeader(GridText& text)
{
  EsriHeader header;
  for (; text.PeekLine(); text.NextLine())
  {
    std::vector<std::string> words = SplitAtBlanks(*text.PeekLine());
    const std::string key = ToLower(words[0]);
    if (!key.empty() && (!IsSmallLetter(key.front()) || key == "nan"))
    {
      break;
    }
    if (!key.empty())
    {
      header.insert_or_assign(key, HeaderFields(text.Place(), std::move(words)));
    }
  }
  return header;
}

class EsriFields
{
public:
  EsriFields(const EsriHeader& header, const GridText& text)
    : Header(header)
    , Text(text)
  {
  }

  bool Has(const std::string& key) const { return this->Header.count(key) != 0; }
  int Count(const std::string& key) const { return this->Line(key).Count(1, key); }
  double Number(const std::string& key) const { return this->Line(key).Number(1, key); }

  /// The header gives the first node (xllcenter) or the corner of its cell (xllcorner).
  double FirstNode(const std::string& axis, double step) const
  {
    const std::string centre = axis + "llcenter";
    return this->Has(centre) ? this->Number(centre) : this->Number(axis + "llcorner") + 0.5 * step;
  }

  double Step(const std::string& key) const { return this->Number(this->Has(key) ? key : "cellsize"); }

  /// Some programs declare nan as the null value, by a word that is not a number.
  NullRule IsNull() const
  {
    const std::string key = "nodata_value";
    if (!this->Has(key))
    {
      return NullAt(UsualNull);
    }
    return IsSameWord(this->Line(key).Text(1, key), "nan") ? NullRule() : NullAt(this->Number(key));
  }

private:
  const HeaderFields& Line(const std::string& key) const
  {
    const auto line = this->Header.find(key);
    if (line == this->Header.end())
    {
      throw this->Text.Error("no line " + key + ", expected one before the values");
    }
    return line->second;
  }

  const EsriHeader& Header;
  const GridText& Text;
};
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadEsriGrid(GridText& text)
{
  HorizonGrid grid;
  grid.Survey.IsUpright = true;
  const EsriHeader header = ReadEsriHeader(text);
  const EsriFields fields(header, text);
  const std::array<int, 2> columns = { fields.Count("ncols"), fields.Count("nrows") };
  const std::array<double, 2> steps = { fields.Step("dx"), fields.Step("dy") };
  const Eigen::Vector2d origin(fields.FirstNode("x", steps[0]), fields.FirstNode("y", steps[1]));
  grid.Lattice = PrefixErrors(text.Place(), [&] { return TurnedLattice(columns, origin, steps, 0.0); });
  std::vector<double> values = text.Values(CountNodes(columns), fields.IsNull());
  text.RequireEnd();
  StorageOrder order;
  order.FromTop = true;
  grid.Z = Arrange(std::move(values), columns, order);
  return grid;
}
}
