// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Most of the time goes into looking at the members of the smaller part, once for columns and once for contacts. What
// two parts were refused for is not looked at again before they have grown.

#include "BestFirstJoining.h"

#include <algorithm>
#include <array>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Parts are tried again when they have grown by this.
constexpr double Growth = 1.3;

std::uint64_t PairKey(PointId a, PointId b)
{
  return std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b));
}
}

//----------------------------------------------------------------------------------------------------------------------
void BestFirstJoining::Run(const Monitor& monitor)
{
  this->TryAll(this->Links.SortByScore(), monitor.Step(0.0, 0.8));
  this->Refusals.clear();
  this->TryAll(std::exchange(this->Refused, {}), monitor.Step(0.8, 1.0));
}

//----------------------------------------------------------------------------------------------------------------------
// Links come in the order of their scores, from all over memory. In blocks, the places they need are read side by side
// first, so that the processor waits for them once.
void BestFirstJoining::TryAll(const std::vector<LinkId>& links, const Monitor& monitor)
{
  constexpr std::size_t block = 64;
  constexpr std::size_t blocksPerCall = 1024; // of the monitor
  std::array<Pair, block> pairs;
  for (std::size_t first = 0; first < links.size(); first += block)
  {
    if (first % (block * blocksPerCall) == 0)
    {
      monitor.Progress(double(first) / double(links.size()));
    }
    const std::size_t size = std::min(block, links.size() - first);
    for (std::size_t n = 0; n < size; ++n)
    {
      const PointId from = this->Links.PickOf(links[first + n]);
      pairs[n] = { from, this->Links.Next(from, this->Links.DirectionOf(links[first + n])) };
    }
    std::array<bool, block> mayJoin;
    for (std::size_t n = 0; n < size; ++n)
    {
      mayJoin[n] = this->Sets.SetOf(pairs[n].From) != this->Sets.SetOf(pairs[n].To);
    }
    for (std::size_t n = 0; n < size; ++n)
    {
      // Sets that are one stay one.
      if (mayJoin[n] && !this->Try(pairs[n]))
      {
        this->Refused.push_back(links[first + n]);
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool BestFirstJoining::Try(const Pair& pair)
{
  PointId big = this->Sets.SetOf(pair.From);
  PointId small = this->Sets.SetOf(pair.To);
  if (big == small || big == NoPoint || small == NoPoint)
  {
    return true;
  }
  if (this->Sets.SizeOf(big) < this->Sets.SizeOf(small))
  {
    std::swap(big, small);
  }
  if (this->WasRefused(big, small))
  {
    return false;
  }
  std::int64_t shared = 0;
  if (!this->MayJoin(big, small, shared))
  {
    this->Refusals[PairKey(big, small)] = std::int64_t(this->Sets.SizeOf(big)) + this->Sets.SizeOf(small);
    return false;
  }
  this->Sets.Absorb(big, small, shared > 0);
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
bool BestFirstJoining::WasRefused(PointId big, PointId small) const
{
  const auto found = this->Refusals.find(PairKey(big, small));
  const double size = double(this->Sets.SizeOf(big)) + double(this->Sets.SizeOf(small));
  return found != this->Refusals.end() && size < Growth * double(found->second);
}

//----------------------------------------------------------------------------------------------------------------------
bool BestFirstJoining::MayJoin(PointId big, PointId small, std::int64_t& shared) const
{
  const PointId size = this->Sets.SizeOf(small);
  const auto most = std::int64_t(this->Rules.LargestShare * size);
  shared = this->Sets.CountShared(small, big, most);
  return shared <= most && (size < this->Rules.ContactSize || this->FaceEachOther(big, small));
}

//----------------------------------------------------------------------------------------------------------------------
bool BestFirstJoining::FaceEachOther(PointId big, PointId small) const
{
  const std::int64_t width = this->Picks.Columns[0];
  const std::int64_t height = this->Picks.Columns[1];
  std::int64_t facing = 0;
  std::int64_t linked = 0;
  const auto look = [&](PointId partner, std::int64_t i, std::int64_t j)
  {
    if (partner != NoPoint && this->Sets.SetOf(partner) == big)
    {
      ++facing;
      ++linked;
    }
    else if (i >= 0 && i < width && j >= 0 && j < height && this->Sets.HasColumn(big, i + j * width))
    {
      ++facing;
    }
    return true;
  };
  this->Sets.ForEachMember(small,
    [&](PointId pick)
    {
      const std::int64_t i = this->Sets.ColumnOf(pick) % width;
      const std::int64_t j = this->Sets.ColumnOf(pick) / width;
      for (int direction = 0; direction < this->Links.Directions(); ++direction)
      {
        const ColumnStep& step = NeighbourSteps[std::size_t(direction)];
        look(this->Links.Next(pick, direction), i + step.I, j + step.J);
        look(this->Links.Previous(pick, direction), i - step.I, j - step.J);
      }
      return true;
    });
  const PointId size = this->Sets.SizeOf(small);
  const bool isTooWide = size >= this->Rules.LargestFilled && size > this->Rules.LargestFilledWidth * double(facing);
  return !isTooWide && double(linked) >= this->Rules.SmallestContact * double(facing);
}
}
