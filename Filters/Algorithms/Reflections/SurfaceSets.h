// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sets of picks that grow together to surfaces, with at most one pick in each column.

#ifndef SeismicHorizonsSurfaceSets_h
#define SeismicHorizonsSurfaceSets_h

#include "Common/RawVector.h"
#include "Reflection.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A set has the number of one of its picks. Its members are a ring.
class SurfaceSets
{
public:
  /// A set for each pick.
  explicit SurfaceSets(const ReflectionPicks& picks);

  /// The set of a pick; NoPoint when it was dropped.
  PointId SetOf(PointId pick) const { return this->Labels[std::size_t(pick)]; }
  PointId SizeOf(PointId set) const { return this->Sizes[std::size_t(set)]; }
  std::int32_t ColumnOf(PointId pick) const { return this->ColumnNumbers[std::size_t(pick)]; }

  /// Whether a set has a pick in a column.
  bool HasColumn(PointId set, std::int64_t column) const
  {
    int found = 0;
    const PointId end = this->Picks.End(column);
    for (PointId pick = this->Picks.Begin(column); pick < end; ++pick)
    {
      found |= int(this->Labels[std::size_t(pick)] == set);
    }
    return found != 0;
  }

  /// Calls visit(pick) for each member until it returns false.
  template <typename Visit>
  void ForEachMember(PointId set, Visit&& visit) const
  {
    PointId pick = set;
    do
    {
      if (!visit(pick))
      {
        return;
      }
      pick = this->Ring[std::size_t(pick)];
    } while (pick != set);
  }

  /// How many columns of a set another one has too, counted until they are more than `most`.
  std::int64_t CountShared(PointId set, PointId other, std::int64_t most) const;

  /// Puts the members of `small` into `big`. Those in columns that `big` has are dropped.
  void Absorb(PointId big, PointId small, bool areShared);

  /// The set of each pick; NoPoint for picks that were dropped.
  RawVector<PointId> TakeLabels() { return std::move(this->Labels); }

private:
  const ReflectionPicks& Picks;
  RawVector<PointId> Labels;
  RawVector<PointId> Ring; // the next member of the set
  RawVector<PointId> Sizes;
  RawVector<std::int32_t> ColumnNumbers;
};
}

#endif
