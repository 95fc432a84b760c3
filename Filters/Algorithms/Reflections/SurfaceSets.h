// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sets of picks that grow together to surfaces, with at most one pick in each column.

#ifndef SeismicHorizonsSurfaceSets_h
#define SeismicHorizonsSurfaceSets_h

#include "Common/RawVector.h"
#include "Reflection.h"

#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// A rectangle of columns.
struct ColumnWindow
{
  int FirstI = 0;
  int EndI = 0;
  int FirstJ = 0;
  int EndJ = 0;

  bool Has(int i, int j) const { return i >= this->FirstI && i < this->EndI && j >= this->FirstJ && j < this->EndJ; }
};

/// A set has the number of one of its picks. Its members are a ring.
class SurfaceSets
{
public:
  /// A set for each pick.
  explicit SurfaceSets(const ReflectionPicks& picks);

  /// The set of a pick; NoPoint when it was dropped.
  PointId SetOf(PointId pick) const { return this->Labels[std::size_t(pick)]; }
  PointId SizeOf(PointId set) const { return this->Sizes[std::size_t(set)]; }
  std::int32_t ColumnOf(PointId pick) const { return this->Members[std::size_t(pick)].Column; }

  /// Whether a set waits. One that does has no size to ask for, and does not grow.
  bool Waits(PointId set) const { return this->Sizes[std::size_t(set)] < 0; }
  void SetWaits(PointId set, bool waits)
  {
    PointId& size = this->Sizes[std::size_t(set)];
    size = waits ? -std::abs(size) : std::abs(size);
  }

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
      pick = this->Members[std::size_t(pick)].Next;
    } while (pick != set);
  }

  /// Puts the members of sets that lie in these columns into their order in memory, in which they are quick to visit.
  void SortMembers(const ColumnWindow& window);

  /// Puts the members of `small` into `big`. Those in columns that `big` has are dropped.
  void Absorb(PointId big, PointId small, bool areShared);

  /// The set of each pick; NoPoint for picks that were dropped.
  RawVector<PointId> TakeLabels() { return std::move(this->Labels); }

private:
  struct Member
  {
    PointId Next = NoPoint; // member of the set
    std::int32_t Column = 0;
  };

  const ReflectionPicks& Picks;
  RawVector<PointId> Labels;
  RawVector<Member> Members;
  RawVector<PointId> Sizes;
};
}

#endif
