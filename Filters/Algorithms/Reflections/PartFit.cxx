// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PartFit.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
bool PartFit::MayJoin(
  PointId big, const ColumnSet* columns, PointId small, const ColumnWindow& window, std::int64_t& shared) const
{
  if (columns)
  {
    return this->MayJoin(
      big, small, window, [columns](int i, int j) { return columns->Has(i, j); }, shared);
  }
  const auto hasColumn = [this, big](int i, int j) { return this->Sets.HasColumn(big, this->Picks.ColumnAt(i, j)); };
  return this->MayJoin(big, small, window, hasColumn, shared);
}

//----------------------------------------------------------------------------------------------------------------------
template <typename HasColumn>
bool PartFit::MayJoin(
  PointId big, PointId small, const ColumnWindow& window, HasColumn&& hasColumn, std::int64_t& shared) const
{
  const PointId size = this->Sets.SizeOf(small);
  const auto most = std::int64_t(this->Rules.LargestShare * size);
  const bool needsContact = size >= this->Rules.ContactSize;
  Contact contact;
  const auto look = [&](PointId partner, int i, int j)
  {
    if (!window.Has(i, j))
    {
      return;
    }
    const bool isLinked = partner != NoPoint && this->Sets.SetOf(partner) == big;
    contact.Linked += isLinked ? 1 : 0;
    contact.Facing += isLinked || hasColumn(i, j) ? 1 : 0;
  };
  shared = 0;
  this->Sets.ForEachMember(small,
    [&](PointId pick)
    {
      const int i = this->Sets.ColumnOf(pick) % this->Picks.Columns[0];
      const int j = this->Sets.ColumnOf(pick) / this->Picks.Columns[0];
      shared += hasColumn(i, j) ? 1 : 0;
      for (int direction = 0; needsContact && direction < this->Links.Directions(); ++direction)
      {
        const ColumnStep& step = NeighbourSteps[std::size_t(direction)];
        look(this->Links.Next(pick, direction), i + step.I, j + step.J);
        look(this->Links.Previous(pick, direction), i - step.I, j - step.J);
      }
      return shared <= most;
    });
  return shared <= most && (!needsContact || this->IsEnough(big, small, contact));
}

//----------------------------------------------------------------------------------------------------------------------
bool PartFit::IsEnough(PointId big, PointId small, const Contact& contact) const
{
  const PointId size = this->Sets.SizeOf(small);
  const double facing = double(contact.Facing);
  const double linked = double(contact.Linked);
  if (linked < this->Rules.SmallestContact * facing)
  {
    return false;
  }
  if (size < this->Rules.LargestFilled || size <= this->Rules.LargestFilledWidth * facing)
  {
    return true;
  }
  return this->Rules.Correlate && contact.Linked >= this->Rules.FewestWidePairs &&
    linked >= this->Rules.SmallestWideContact * facing &&
    this->Rules.Correlate(this->ListPairs(big, small)) >= this->Rules.SmallestWideCorrelation;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<Edge> PartFit::ListPairs(PointId big, PointId small) const
{
  std::vector<Edge> pairs;
  this->Sets.ForEachMember(small,
    [&](PointId pick)
    {
      for (int direction = 0; direction < this->Links.Directions(); ++direction)
      {
        for (const PointId partner : { this->Links.Next(pick, direction), this->Links.Previous(pick, direction) })
        {
          if (partner != NoPoint && this->Sets.SetOf(partner) == big)
          {
            pairs.push_back({ pick, partner });
          }
        }
      }
      return true;
    });
  return pairs;
}
}
