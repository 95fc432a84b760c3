// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fault as a thin plate through its picks: how far it lies in the direction of dip, by the place along strike and the
// height. So faults may be upright, and the unit of heights does not matter. Places of a fault have coordinates
//
//   S   along strike, with the fault dipping to the right
//   N   horizontal, across, in the direction of dip
//   Z   height
//
// and the hanging wall is where N is greater than that of the plate.

#ifndef SeismicHorizonsFaultPlate_h
#define SeismicHorizonsFaultPlate_h

#include "Common/Base/Monitor.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// What is known of a fault: sticks, edges of a surface, or traces on horizons, piece by piece.
struct FaultPicks
{
  std::string Name;
  std::vector<std::array<Eigen::Vector3d, 2>> Segments;
  std::vector<std::array<Eigen::Vector3d, 2>> TipLoop; // a closed line around the fault; without it their hull is
  bool IsSurface = false; // Segments cover the fault, which ends with them.
  bool HasDip = true; // Otherwise it is taken as upright, and heaves are unknown.
  std::vector<std::size_t> Horizons; // the only ones that it cuts, by number; empty for any
  double Spacing = 0.0; // between sticks; the fault reaches half of it beyond the first and the last
};

struct FaultPlace
{
  double S = 0.0;
  double N = 0.0;
  double Z = 0.0;
};

class FaultPlate
{
public:
  /// Throws InputError for picks that are no surface: level ones, and those on one line.
  explicit FaultPlate(const FaultPicks& picks, const Monitor& monitor = Monitor());

  /// The plate in other coordinates, turned about z.
  FaultPlate Moved(const Eigen::Isometry2d& move) const;
  /// The same places, with the hanging wall on the other side.
  FaultPlate Reversed() const;

  const std::string& Name() const { return this->OwnName; }
  bool HasDip() const { return this->IsDipKnown; }
  /// Around the picks and half of their spacing, on the map.
  const Eigen::AlignedBox2d& Box() const { return this->OnMap; }
  FaultPlace ToPlace(const Eigen::Vector3d& world) const;
  Eigen::Vector3d ToWorld(const FaultPlace& place) const;

  const Eigen::Vector2d& AlongOnMap() const { return this->Along; }
  const Eigen::Vector2d& AcrossOnMap() const { return this->Across; }

  /// Beyond the picks the plate is continued as a plane.
  double Offset(double s, double z) const;
  Eigen::Vector3d At(double s, double z) const { return this->ToWorld({ s, this->Offset(s, z), z }); }
  /// Positive in the hanging wall: the horizontal distance across strike.
  double Distance(const FaultPlace& place) const { return place.N - this->Offset(place.S, place.Z); }

  bool Contains(double s, double z, double margin = 0.0) const;
  double First() const { return this->Ends[0]; }
  double Last() const { return this->Ends[1]; }
  double Lowest() const { return this->Grid[1].First; }
  double Highest() const { return this->Grid[1].At(this->Grid[1].Size - 1); }
  std::size_t Levels() const { return this->Grid[1].Size; }
  /// How far the fault reaches at a level, the mean of above and below.
  std::array<double, 2> EndsAt(std::size_t level) const;
  double Height(std::size_t level) const { return this->Grid[1].At(level); }
  /// World z of heights of 0.
  double Datum() const { return this->Origin.z(); }
  double StepAlong() const { return this->Grid[0].Step; }

  /// The largest distance of picks from the plate, across strike.
  double LargestMiss() const { return this->Miss; }
  /// The largest angle of strike at picks with the mean strike, as its tangent.
  double LargestTurn() const { return this->Turn; }

  /// Map distance across strike by height, of the mean plane.
  double Lean() const { return std::abs(this->Plane.y()); }
  /// Whether the fault is too steep to tell its hanging wall from the shape: it dips by less than a column.
  bool IsUpright(double column) const { return this->Lean() * (this->Highest() - this->Lowest()) < column; }
  /// The area of the plate between two places along strike and two heights, taken as one plane.
  double AreaOf(double width, double height, double s, double z) const;

private:
  struct Axis
  {
    double First = 0.0;
    double Step = 1.0;
    std::size_t Size = 2;

    double At(std::size_t n) const { return this->First + double(n) * this->Step; }
    /// The interval of a value, and which part of it is before the value. Outside it is the first or last interval.
    std::pair<std::size_t, double> Find(double value) const;
    std::size_t Interval(double value) const { return this->Find(value).first; }
  };

  using Segments = std::vector<std::array<FaultPlace, 2>>;

  void Orient(const FaultPicks& picks);
  Segments MakeGrid(const FaultPicks& picks);
  void FindExtent(const Segments& segments, double margin);
  void Fit(const Segments& segments, const Monitor& monitor);
  Eigen::Vector2d Gradient(double s, double z) const;

  std::string OwnName;
  bool IsDipKnown;
  Eigen::AlignedBox2d OnMap;
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero();
  Eigen::Vector2d Along = Eigen::Vector2d::UnitX();
  Eigen::Vector2d Across = Eigen::Vector2d::UnitY();
  Eigen::Vector2d Plane = Eigen::Vector2d::Zero(); // slopes of the mean plane along S and Z
  std::array<Axis, 2> Grid; // along S and Z
  std::vector<double> Values; // from the mean plane, by rows of S
  std::vector<std::array<double, 2>> Extent; // by level; empty ranges end before they begin
  std::array<double, 2> Ends = { 0.0, 0.0 };
  double Miss = 0.0;
  double Turn = 0.0;
};
}

#endif
