// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fault lines as chains of faulted links, also from traces, polygons and sticks of an interpreter.
//
// A link is cut where a trace passes between its columns, so that the cuts form a chain without breaks. A polygon
// around both cutoffs of a fault cuts along both: there is no surface between them, and filling continues each side
// alone. Both sides of a polygon narrower than a column cut the same links.

#ifndef SeismicHorizonsFaultLines_h
#define SeismicHorizonsFaultLines_h

#include "ColumnHeights.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"
#include "LinkGrid.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct FaultedLink
{
  LatticeLink Place;
  double Throw = 0.0; // This is the height beyond the link minus the height before it, or NaN.
  double Middle = 0.0; // This is the mean height, or NaN without a height nearby.
  bool IsForward = true; // Forward lines go north across a link to the east, or east across a link to the north.

  /// The left of the line is higher by this.
  double LeftThrow() const { return IsLeftBeyond(this->Place.Side, this->IsForward) ? this->Throw : -this->Throw; }
};

FaultedLink MeasureCut(const ColumnHeights& heights, std::int64_t link, bool isForward);

class FaultLines
{
public:
  std::size_t Size() const { return this->Ends.size(); }
  std::size_t NumberOfLinks() const { return this->Links.size(); }
  std::size_t Start(std::size_t line) const { return line == 0 ? 0 : this->Ends[line - 1]; }
  std::size_t End(std::size_t line) const { return this->Ends[line]; }
  FaultedLink& operator[](std::size_t n) { return this->Links[n]; }
  const FaultedLink& operator[](std::size_t n) const { return this->Links[n]; }

  void Append(const FaultedLink& link) { this->Links.push_back(link); }
  void Append(const FaultLines& other);
  /// Ends the line and turns it so that its left is the higher side on average. Empty lines are ignored.
  void Close();

  /// Names the lines since the last call.
  void NameNew(const std::string& fault) { this->Faults.resize(this->Ends.size(), fault); }
  std::string Fault(std::size_t line) const { return line < this->Faults.size() ? this->Faults[line] : std::string(); }

private:
  std::vector<FaultedLink> Links;
  std::vector<std::size_t> Ends;
  std::vector<std::string> Faults;
};

/// Links are sorted by j, i and side; the first line with a link wins.
struct LinkOfLine
{
  std::size_t Link = 0; // its position in the lines
  std::size_t Line = 0;
};
std::vector<LinkOfLine> SortLinks(const FaultLines& lines);

/// Empty without links. Cuts take memory for the bounding box of the links.
std::optional<LinkCuts> CutLinks(const std::vector<LatticeLink>& links);

/// Coordinates are in columns.
struct MapPlace
{
  double X = 0.0;
  double Y = 0.0;
};

using FaultPolyline = std::vector<MapPlace>;

/// Returns a line for each section of a polyline inside the bounding box. A polyline exactly through a column passes on
/// the side of lesser coordinates. Throws InputError for places that are not finite, and far more cuts than links.
/// `faults` are the names of their faults, or empty.
FaultLines CutAlong(const ColumnHeights& heights, const std::vector<FaultPolyline>& polylines,
  const std::vector<std::string>& faults = {});

/// Fault polygons are closed lines around the area that a fault leaves empty in a horizon. Mapping programs fill their
/// inside with values that are not data. A closed line ends where it began and has an inside.
bool IsClosed(const FaultPolyline& line);

/// Returns the points outside all closed lines, by the even-odd rule for each line. Throws InputError for more than a
/// hundred million crossings of rows.
KeptPoints FindOutside(PlanePoints columns, const std::vector<FaultPolyline>& lines);

struct FaultStick
{
  std::vector<SpacePoint> Places;
  std::string Fault; // equal for sticks of one fault
};

void RequireFinite(const std::vector<SpacePoint>& places, std::size_t stick);

/// The line is in columns and vertical indices. Over missing columns, heights are interpolated along it.
std::vector<MapPlace> FindPassages(const ColumnHeights& heights, const std::vector<SpacePoint>& line);
}

#endif
