// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sets of picks that grow together to surfaces, with at most one pick in each column.

#ifndef SeismicHorizonsSurfaceSets_h
#define SeismicHorizonsSurfaceSets_h

#include "Common/RawVector.h"
#include "Reflection.h"

#include <cstdint>

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
  PointId SetOf(PointId pick) const
  {
    const PointId label = this->Labels[std::size_t(pick)];
    return label < NoPoint ? pick : label;
  }
  PointId SizeOf(PointId set) const { return (NoPoint - this->Labels[std::size_t(set)]) & ~WaitBit; }
  std::int32_t ColumnOf(PointId pick) const { return this->Members[std::size_t(pick)].Column; }

  /// Whether a set waits.
  bool Waits(PointId set) const { return ((NoPoint - this->Labels[std::size_t(set)]) & WaitBit) != 0; }
  void SetWaits(PointId set, bool waits)
  {
    this->Labels[std::size_t(set)] = NoPoint - (this->SizeOf(set) | (waits ? WaitBit : 0));
  }

  /// Whether a set has a pick in a column.
  bool HasColumn(PointId set, std::int64_t column) const
  {
    int found = int(this->ColumnOf(set) == column);
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
  RawVector<PointId> TakeLabels();

private:
  struct Member
  {
    PointId Next = NoPoint; // member of the set
    std::int32_t Column = 0;
  };

  const ReflectionPicks& Picks;
  // Of each pick its set. Of the pick that a set is named by, a number below NoPoint, by as much as the set has
  // members; picks are fewer than 2^30, which leaves a bit for sets that wait.
  static constexpr PointId WaitBit = PointId(1) << 30;
  RawVector<PointId> Labels;
  RawVector<Member> Members;
};
}

#endif
