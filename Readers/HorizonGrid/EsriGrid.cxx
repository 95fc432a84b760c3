// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridParsers.h"
#include "GridText.h"
#include "HeaderFields.h"

namespace SeismicHorizons
{
namespace
{
constexpr double UsualNull = -9999.0;

bool IsSmallLetter(char c)
{
  return c >= 'a' && c <= 'z';
}

class EsriHeader
{
public:
  /// Stops at the first line of values, which may start with a word for no value.
  explicit EsriHeader(GridText& text)
    : Text(text)
  {
    for (; text.PeekLine(); text.NextLine())
    {
      std::vector<std::string> words = SplitAtBlanks(*text.PeekLine());
      const std::string key = ToLower(words[0]);
      if (!key.empty() && (!IsSmallLetter(key.front()) || text.IsNull(key)))
      {
        break;
      }
      if (!key.empty())
      {
        this->Lines.insert_or_assign(key, HeaderFields(text.Place(), std::move(words)));
      }
    }
  }

  bool Has(const std::string& key) const { return this->Lines.count(key) != 0; }
  int Count(const std::string& key) const { return this->Line(key).Count(1, key); }
  double Number(const std::string& key) const { return this->Line(key).Number(1, key); }

  /// The header gives the first node (xllcenter) or the corner of its cell (xllcorner).
  double FirstNode(const std::string& axis, double step) const
  {
    const std::string centre = axis + "llcenter";
    return this->Has(centre) ? this->Number(centre) : this->Number(axis + "llcorner") + 0.5 * step;
  }

  double Step(const std::string& key) const { return this->Number(this->Has(key) ? key : "cellsize"); }

  /// Some programs declare a word such as nan as the null value.
  NullRule IsNull() const
  {
    const std::string key = "nodata_value";
    if (!this->Has(key))
    {
      return NullAt(UsualNull);
    }
    return this->Text.IsNull(this->Line(key).Text(1, key)) ? NullRule() : NullAt(this->Number(key));
  }

private:
  const HeaderFields& Line(const std::string& key) const
  {
    return RequireKeyword(this->Lines, key, this->Text.Place());
  }

  const GridText& Text;
  KeywordLines Lines;
};
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadEsriGrid(GridText& text)
{
  HorizonGrid grid;
  grid.Survey.IsUpright = true;
  const EsriHeader header(text);
  const std::array<int, 2> columns = { header.Count("ncols"), header.Count("nrows") };
  const std::array<double, 2> steps = { header.Step("dx"), header.Step("dy") };
  const Eigen::Vector2d origin(header.FirstNode("x", steps[0]), header.FirstNode("y", steps[1]));
  grid.Lattice = PrefixErrors(text.Place(), [&] { return TurnedLattice(columns, origin, steps, 0.0); });
  std::vector<double> values = text.Values(CountNodes(columns), header.IsNull());
  text.RequireEnd();
  grid.Z = Arrange(std::move(values), columns, { false, false, true });
  return grid;
}
}
