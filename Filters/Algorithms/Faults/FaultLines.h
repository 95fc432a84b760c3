// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fault lines as chains of faulted links, and from lines that are given: traces or polygons of an interpreter, and
// sticks.
//
// A link is cut where a trace passes between its two columns, so that columns are parted just as the trace parts them,
// and the cuts are a chain without breaks. A polygon that follows both cutoffs of a fault cuts along both: there is no
// surface between them, and what is filled in later continues each side alone. Where a polygon is narrower than a
// column, both of its sides cut the same links.

#ifndef SeismicHorizonsFaultLines_h
#define SeismicHorizonsFaultLines_h

#include "ColumnHeights.h"
#include "Common/Types.h"
#include "LinkGrid.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A faulted link as part of a fault line.
struct FaultedLink
{
  LatticeLink Place;
  double Throw = 0.0; // height beyond the link minus height before it; nan where one of them is not known
  double Middle = 0.0; // the height half way; nan where there is none near
  bool IsForward = true; // whether the line goes north across a link to the east, or east across one to the north

  /// How much higher the left of the line is than its right.
  double LeftThrow() const { return IsLeftBeyond(this->Place.Side, this->IsForward) ? this->Throw : -this->Throw; }
};

/// A cut of a link in the box, with its throw where both columns have points.
FaultedLink MeasureCut(const ColumnHeights& heights, std::int64_t link, bool isForward);

/// Chains of faulted links, each from an end to the other.
class FaultLines
{
public:
  std::size_t Size() const { return this->Ends.size(); }
  std::size_t NumberOfLinks() const { return this->Links.size(); }
  std::size_t Start(std::size_t line) const { return line == 0 ? 0 : this->Ends[line - 1]; }
  std::size_t End(std::size_t line) const { return this->Ends[line]; }
  FaultedLink& operator[](std::size_t n) { return this->Links[n]; }
  const FaultedLink& operator[](std::size_t n) const { return this->Links[n]; }

  /// Appends to the line that is being built.
  void Append(const FaultedLink& link) { this->Links.push_back(link); }
  /// Appends whole lines.
  void Append(const FaultLines& other);
  /// Ends that line unless it has no link, and turns it so that its left is the higher side on the whole.
  void Close();

private:
  std::vector<FaultedLink> Links;
  std::vector<std::size_t> Ends;
};

/// All links of the lines by j, i and side, each once: that of the first line that has it.
struct LinkOfLine
{
  std::size_t Link = 0; // its number in the lines
  std::size_t Line = 0;
};
std::vector<LinkOfLine> SortLinks(const FaultLines& lines);

/// A place on the map, in columns.
struct MapPlace
{
  double X = 0.0;
  double Y = 0.0;
};

using FaultPolyline = std::vector<MapPlace>;

/// The links of the horizon's bounding box that polylines cut: a line for each part of a polyline inside the box, with
/// the throw where both columns of a link have points. A polyline exactly through a column passes on the side of lesser
/// coordinates. Throws InputError on a place that is not finite, and on lines that run back and forth until they have
/// cut far more links than there are. Linear in the number of places and of links that are cut.
FaultLines CutAlong(const ColumnHeights& heights, const std::vector<FaultPolyline>& polylines);

/// A line down a fault surface.
struct FaultStick
{
  std::vector<SpacePoint> Places;
  std::string Fault; // what sticks of one fault have in common
};

/// Throws InputError on a place of a stick that is not finite, with the number of the stick.
void RequireFinite(const std::vector<SpacePoint>& places, std::size_t stick);

/// Where a line in columns and vertical indices passes from above the horizon to below it, or back, in its direction.
/// Over gaps in the horizon heights continue evenly along the line.
std::vector<MapPlace> FindPassages(const ColumnHeights& heights, const std::vector<SpacePoint>& line);
}

#endif
