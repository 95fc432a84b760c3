// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultLines_h
#define SeismicHorizonsFaultLines_h

#include "ColumnHeights.h"
#include "LinkGrid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A cut link as part of a fault line.
struct CutLink
{
  LatticeLink Place;
  double Throw = 0.0; // height beyond the link minus height before it; nan where one of them is not known
  double Middle = 0.0; // the height half way; nan where there is none near
  bool IsForward = true; // whether the line goes north across a link to the east, or east across one to the north

  /// How much higher the left of the line is than its right.
  double LeftThrow() const
  {
    return (this->Place.Side == LinkSide::North) == this->IsForward ? this->Throw : -this->Throw;
  }
};

/// A cut of a link in the box, with its throw where both columns have points.
CutLink MeasureCut(const ColumnHeights& heights, std::int64_t link, bool isForward);

/// Chains of cut links, each from an end to the other.
class FaultLines
{
public:
  std::size_t Size() const { return this->Ends.size(); }
  std::size_t NumberOfLinks() const { return this->Links.size(); }
  std::size_t Start(std::size_t line) const { return line == 0 ? 0 : this->Ends[line - 1]; }
  std::size_t End(std::size_t line) const { return this->Ends[line]; }
  CutLink& operator[](std::size_t n) { return this->Links[n]; }
  const CutLink& operator[](std::size_t n) const { return this->Links[n]; }

  /// Appends to the line that is being built.
  void Append(const CutLink& link) { this->Links.push_back(link); }
  /// Appends whole lines.
  void Append(const FaultLines& other);
  /// Ends that line unless it has no link, and turns it so that its left is the higher side on the whole.
  void Close();

private:
  std::vector<CutLink> Links;
  std::vector<std::size_t> Ends;
};

/// All links of the lines by j, i and side, each once: that of the first line that has it.
struct LinkOfLine
{
  std::size_t Link = 0; // its number in the lines
  std::size_t Line = 0;
};
std::vector<LinkOfLine> SortLinks(const FaultLines& lines);
}

#endif
