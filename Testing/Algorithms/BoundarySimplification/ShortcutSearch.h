// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which edges may take the place of a part of a loop, and how few points a loop can have, found by trying everything,
// with none of the code that simplifies loops.

#ifndef SeismicHorizonsShortcutSearch_h
#define SeismicHorizonsShortcutSearch_h

#include "Common/Horizon/BoundedHorizon.h"

#include <map>
#include <string>
#include <vector>

class ShortcutSearch
{
public:
  ShortcutSearch(const SeismicHorizons::BoundedHorizon& horizon, double tolerance, double threshold);

  /// Whether a loop of others has points of a loop in the same order, with edges that may be; empty when all is well.
  std::string CheckLoop(std::size_t loop, const SeismicHorizons::Loops& others, std::size_t other) const;

  /// For each position in a loop, how few points the loop can have when it keeps this one.
  std::vector<std::size_t> LeastPoints(std::size_t loop) const;

private:
  using Ids = std::vector<SeismicHorizons::PointId>;

  bool IsFixed(SeismicHorizons::PointId point) const { return this->Visits.at(point) > 1; }
  bool MayTakePlace(const Ids& chain) const;
  bool IsNear(const Ids& chain) const;
  bool SweepsOver(const Ids& chain) const;
  bool IsSwept(const Ids& chain, const SeismicHorizons::PlanePoint& place) const;
  std::size_t LeastEdges(const Ids& chain) const;
  Ids Around(std::size_t loop, std::size_t first) const;

  const SeismicHorizons::BoundedHorizon& Horizon;
  double Tolerance;
  double Threshold;
  std::map<SeismicHorizons::PointId, int> Visits;
};

#endif
