// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonSheets.h"

#include "Common/DisjointSets.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
using Voxel = std::int32_t; // by its number

/// A single surface and a layer that touch, and how often.
struct Contact
{
  Voxel Surface = 0;
  Voxel Layer = 0;
  std::int64_t Count = 0;
};

class SheetSplitter
{
public:
  explicit SheetSplitter(const HorizonVoxels& voxels)
    : Voxels(voxels)
    , Parts(voxels.I.size())
    , ColumnOf(voxels.I.size())
  {
    for (Voxel voxel = 0; voxel < Voxel(voxels.I.size()); ++voxel)
    {
      if (voxel == 0 || this->Place(voxel) != this->Place(voxel - 1))
      {
        this->Starts.push_back(voxel);
      }
      this->ColumnOf[std::size_t(voxel)] = std::int32_t(this->Starts.size()) - 1;
    }
    this->Starts.push_back(Voxel(voxels.I.size()));
  }

  bool IsSingle() const { return this->Starts.size() == this->Voxels.I.size() + 1; }

  /// The sheet of each voxel; -1 for one that is dropped.
  std::vector<int> Split()
  {
    this->JoinNeighbours();
    this->ListConflicts();
    for (const Contact& contact : this->CountContacts())
    {
      this->JoinUnlessAbove(contact.Surface, contact.Layer);
    }
    return this->DealOut();
  }

private:
  std::pair<int, int> Place(Voxel voxel) const
  {
    return { this->Voxels.J[std::size_t(voxel)], this->Voxels.I[std::size_t(voxel)] };
  }

  int Size(std::int32_t column) const
  {
    return this->Starts[std::size_t(column) + 1] - this->Starts[std::size_t(column)];
  }

  /// The column at a place, or -1.
  std::int32_t FindColumn(const std::pair<int, int>& place) const
  {
    const auto last = this->Starts.end() - 1;
    const auto found = std::lower_bound(this->Starts.begin(), last, place,
      [this](Voxel voxel, const std::pair<int, int>& wanted) { return this->Place(voxel) < wanted; });
    return found != last && this->Place(*found) == place ? std::int32_t(found - this->Starts.begin()) : -1;
  }

  /// The voxel of a column nearest to another one, the first of those as near.
  Voxel FindNearest(Voxel voxel, std::int32_t column) const
  {
    const int k = this->Voxels.K[std::size_t(voxel)];
    Voxel nearest = this->Starts[std::size_t(column)];
    for (Voxel other = nearest + 1; other < this->Starts[std::size_t(column) + 1]; ++other)
    {
      const auto distance = [this, k](Voxel of) { return std::abs(this->Voxels.K[std::size_t(of)] - k); };
      nearest = distance(other) < distance(nearest) ? other : nearest;
    }
    return nearest;
  }

  void JoinNeighbours()
  {
    // The other four have this column as one of theirs.
    constexpr std::array<std::array<int, 2>, 4> steps = { { { 0, 1 }, { 1, -1 }, { 1, 0 }, { 1, 1 } } };
    for (std::int32_t column = 0; column + 1 < std::int32_t(this->Starts.size()); ++column)
    {
      const std::pair<int, int> place = this->Place(this->Starts[std::size_t(column)]);
      for (const std::array<int, 2>& step : steps)
      {
        const std::int32_t other = this->FindColumn({ place.first + step[0], place.second + step[1] });
        if (other >= 0)
        {
          this->JoinColumns(column, other);
        }
      }
    }
  }

  void JoinColumns(std::int32_t column, std::int32_t other)
  {
    for (Voxel voxel = this->Starts[std::size_t(column)]; voxel < this->Starts[std::size_t(column) + 1]; ++voxel)
    {
      const Voxel nearest = this->FindNearest(voxel, other);
      if (this->FindNearest(nearest, column) != voxel)
      {
        continue;
      }
      if ((this->Size(column) == 1) == (this->Size(other) == 1))
      {
        this->Parts.Join(voxel, nearest);
      }
      else
      {
        this->Touching.push_back(this->Size(column) == 1 ? Contact{ voxel, nearest, 1 } : Contact{ nearest, voxel, 1 });
      }
    }
  }

  /// Which layers lie above each other.
  void ListConflicts()
  {
    this->Above.resize(this->Voxels.I.size());
    for (std::int32_t column = 0; column + 1 < std::int32_t(this->Starts.size()); ++column)
    {
      for (Voxel voxel = this->Starts[std::size_t(column)]; voxel < this->Starts[std::size_t(column) + 1]; ++voxel)
      {
        for (Voxel other = this->Starts[std::size_t(column)]; other < voxel; ++other)
        {
          const Voxel a = this->Parts.Find(voxel);
          const Voxel b = this->Parts.Find(other);
          if (a != b)
          {
            this->Above[std::size_t(a)].push_back(b);
            this->Above[std::size_t(b)].push_back(a);
          }
        }
      }
    }
    for (std::vector<Voxel>& parts : this->Above)
    {
      std::sort(parts.begin(), parts.end());
      parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    }
  }

  /// Those of each surface with each layer, the most frequent first.
  std::vector<Contact> CountContacts()
  {
    for (Contact& contact : this->Touching)
    {
      contact = { this->Parts.Find(contact.Surface), this->Parts.Find(contact.Layer), 1 };
    }
    const auto key = [](const Contact& contact) { return std::make_tuple(contact.Surface, contact.Layer); };
    std::sort(this->Touching.begin(), this->Touching.end(),
      [&key](const Contact& a, const Contact& b) { return key(a) < key(b); });
    std::vector<Contact> counted;
    for (const Contact& contact : this->Touching)
    {
      if (counted.empty() || key(counted.back()) != key(contact))
      {
        counted.push_back({ contact.Surface, contact.Layer, 0 });
      }
      ++counted.back().Count;
    }
    std::stable_sort(
      counted.begin(), counted.end(), [](const Contact& a, const Contact& b) { return a.Count > b.Count; });
    return counted;
  }

  void JoinUnlessAbove(Voxel a, Voxel b)
  {
    a = this->Parts.Find(a);
    b = this->Parts.Find(b);
    if (this->Above[std::size_t(a)].size() < this->Above[std::size_t(b)].size())
    {
      std::swap(a, b);
    }
    std::vector<Voxel>& few = this->Above[std::size_t(b)];
    const bool isAbove =
      std::any_of(few.begin(), few.end(), [this, a](Voxel other) { return this->Parts.Find(other) == a; });
    if (a == b || isAbove)
    {
      return;
    }
    std::vector<Voxel> all = std::move(this->Above[std::size_t(a)]);
    all.insert(all.end(), few.begin(), few.end());
    few.clear();
    this->Parts.Join(a, b);
    this->Above[std::size_t(this->Parts.Find(a))] = std::move(all);
  }

  /// Each part goes on the first sheet that has none of its columns, the largest part first.
  std::vector<int> DealOut()
  {
    const std::size_t size = this->Voxels.I.size();
    std::vector<Voxel> order(size);
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::int64_t> sizes(size, 0);
    for (const Voxel voxel : order)
    {
      ++sizes[std::size_t(this->Parts.Find(voxel))];
    }
    std::stable_sort(order.begin(), order.end(),
      [this, &sizes](Voxel a, Voxel b)
      {
        const Voxel partA = this->Parts.Find(a);
        const Voxel partB = this->Parts.Find(b);
        return std::make_tuple(-sizes[std::size_t(partA)], partA) < std::make_tuple(-sizes[std::size_t(partB)], partB);
      });
    std::vector<std::uint64_t> taken(this->Starts.size(), 0); // sheets that have a voxel in the column, as bits
    std::vector<int> sheets(size, -1);
    for (std::size_t first = 0; first < size;)
    {
      std::size_t last = first;
      std::uint64_t used = 0;
      for (; last < size && this->Parts.Find(order[last]) == this->Parts.Find(order[first]); ++last)
      {
        used |= taken[std::size_t(this->ColumnOf[std::size_t(order[last])])];
      }
      int sheet = 0;
      while (sheet < MostSheets && (used >> sheet & 1U) != 0)
      {
        ++sheet;
      }
      for (; first < last; ++first)
      {
        std::uint64_t& ofColumn = taken[std::size_t(this->ColumnOf[std::size_t(order[first])])];
        if (sheet < MostSheets && (ofColumn >> sheet & 1U) == 0)
        {
          ofColumn |= std::uint64_t(1) << sheet;
          sheets[std::size_t(order[first])] = sheet;
        }
      }
    }
    return sheets;
  }

  static constexpr int MostSheets = 64;

  const HorizonVoxels& Voxels;
  DisjointSets Parts;
  std::vector<Voxel> Starts; // the first voxel of each column, and the end
  std::vector<std::int32_t> ColumnOf; // each voxel
  std::vector<Contact> Touching;
  std::vector<std::vector<Voxel>> Above; // by part
};

void CopyVoxel(const HorizonVoxels& from, std::size_t voxel, HorizonVoxels& to)
{
  to.I.push_back(from.I[voxel]);
  to.J.push_back(from.J[voxel]);
  to.K.push_back(from.K[voxel]);
  to.Thickness.push_back(from.Thickness[voxel]);
  to.Amplitude.push_back(from.Amplitude[voxel]);
  to.RealZ.push_back(from.RealZ[voxel]);
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<HorizonVoxels> SplitIntoSheets(HorizonVoxels voxels)
{
  std::vector<HorizonVoxels> sheets;
  SheetSplitter splitter(voxels);
  if (splitter.IsSingle())
  {
    sheets.push_back(std::move(voxels));
    return sheets;
  }
  const std::vector<int> sheetOf = splitter.Split();
  sheets.resize(std::size_t(*std::max_element(sheetOf.begin(), sheetOf.end())) + 1);
  for (HorizonVoxels& sheet : sheets)
  {
    sheet.SurfaceId = voxels.SurfaceId;
  }
  for (std::size_t voxel = 0; voxel < sheetOf.size(); ++voxel)
  {
    if (sheetOf[voxel] < 0)
    {
      ++sheets.front().DroppedDuplicates;
    }
    else
    {
      CopyVoxel(voxels, voxel, sheets[std::size_t(sheetOf[voxel])]);
    }
  }
  return sheets;
}
}
