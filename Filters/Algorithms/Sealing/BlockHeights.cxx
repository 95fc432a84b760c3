// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockHeights.h"

#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/HoleFilling/PlateEnergy.h"
#include "Filters/Algorithms/HoleFilling/SiteSolver.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr double Beyond = 4.0; // columns that heights are continued beyond faults
constexpr int Around = 4; // columns kept around a block
constexpr double LeastApart = 2.5; // errors, between horizons of a block
constexpr std::size_t FewestOfBlock = 6; // of a block that follows them
constexpr int Rim = 6; // columns of picks that the continuation follows

double MeanOf(const std::vector<double>& known)
{
  double sum = 0.0, count = 0.0;
  for (const double value : known)
  {
    sum += std::isfinite(value) ? value : 0.0;
    count += std::isfinite(value) ? 1.0 : 0.0;
  }
  return sum / std::max(count, 1.0);
}

class BlockFiller
{
public:
  BlockFiller(const BlockLattice& lattice, const std::vector<SealingFault>& faults)
    : Lattice(lattice)
    , Faults(faults)
    , Column(lattice.Step.maxCoeff())
  {
  }

  /// Continues known heights over the block, step by step from where they are known: how far it reaches depends on them.
  void Fill(BlockHeights& block, const Monitor& monitor) const
  {
    const std::vector<double> known = block.Heights;
    std::vector<std::size_t> sites;
    constexpr int mostRounds = 6;
    for (int round = 0; round < mostRounds; ++round)
    {
      std::vector<std::size_t> added;
      bool isNew = false;
      this->Spread(block.Heights,
        [&](std::size_t node, double height)
        {
          const bool isInside = this->IsInside(block.Sides, node, height, Beyond);
          added.insert(added.end(), isInside ? 1 : 0, node);
          isNew = isNew || (isInside && this->IsInside(block.Sides, node, height, 0.5 * Beyond));
          return isInside;
        });
      if (!isNew)
      {
        break;
      }
      sites.insert(sites.end(), added.begin(), added.end());
      std::sort(sites.begin(), sites.end());
      block.Heights = this->Solve(known, sites, monitor);
    }
    block.Nearest = block.Heights;
    this->Spread(block.Nearest, [](std::size_t, double) { return true; });
  }

  /// Keeps heights of the block, and some columns around whatever their heights are: so a steep horizon leaves its block
  /// through a fault, and does not end before.
  void Limit(BlockHeights& block, PickAccount& account) const
  {
    const auto width = std::size_t(this->Lattice.Width), height = std::size_t(this->Lattice.Height);
    std::vector<unsigned char> isKept(block.Nearest.size(), 0), isThere(block.Nearest.size(), 0);
    ParallelFor(std::int64_t(isKept.size()), Grain, Monitor(),
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto node = std::size_t(first); node < std::size_t(last); ++node)
        {
          isKept[node] = this->IsInside(block.Sides, node, block.Nearest[node], 1.0) ? 1 : 0;
          isThere[node] = isKept[node] != 0 && this->Lattice.IsInBox(node) &&
              this->IsInside(block.Sides, node, block.Nearest[node], 0.0)
            ? 1
            : 0;
        }
      });
    for (std::size_t node = 0; node < isThere.size(); ++node)
    {
      account.Columns += isThere[node];
      account.Continued += isThere[node] != 0 && block.IsKnown[node] == 0 ? 1 : 0;
    }
    for (int step = 0; step < Around; ++step)
    {
      const std::vector<unsigned char> last = isKept;
      for (std::size_t node = 0; node < last.size(); ++node)
      {
        const std::size_t x = node % width, y = node / width;
        isKept[node] = last[node] != 0 || (x > 0 && last[node - 1] != 0) || (x + 1 < width && last[node + 1] != 0) ||
            (y > 0 && last[node - width] != 0) || (y + 1 < height && last[node + width] != 0)
          ? 1
          : 0;
      }
    }
    for (std::size_t node = 0; node < isKept.size(); ++node)
    {
      block.Heights[node] = isKept[node] != 0 ? block.Nearest[node] : NotKnown;
    }
  }

private:
  bool IsInside(const BlockSides& sides, std::size_t node, double height, double margin) const
  {
    const Eigen::Vector2d place = this->Lattice.At(node);
    for (std::size_t fault = sides.size(); fault-- > 0;) // The last ones bound the block.
    {
      const FaultPlate& plate = this->Faults[fault].Plate;
      if (sides[fault] != 0 &&
        sides[fault] * plate.Distance(plate.ToPlace({ place.x(), place.y(), height })) < -margin * this->Column)
      {
        return false;
      }
    }
    return true;
  }

  /// Gives nodes without a height the one of the nearest node, as far as accepts(node, height).
  template <typename Accepts>
  void Spread(std::vector<double>& heights, Accepts&& accepts) const
  {
    std::vector<std::size_t> front;
    for (std::size_t node = 0; node < heights.size(); ++node)
    {
      if (std::isfinite(heights[node]))
      {
        front.push_back(node);
      }
    }
    const auto width = std::size_t(this->Lattice.Width), height = std::size_t(this->Lattice.Height);
    for (std::size_t n = 0; n < front.size(); ++n)
    {
      const std::size_t x = front[n] % width, y = front[n] / width;
      const auto visit = [&](std::size_t node)
      {
        if (std::isnan(heights[node]) && accepts(node, heights[front[n]]))
        {
          heights[node] = heights[front[n]];
          front.push_back(node);
        }
      };
      if (x > 0)
      {
        visit(front[n] - 1);
      }
      if (x + 1 < width)
      {
        visit(front[n] + 1);
      }
      if (y > 0)
      {
        visit(front[n] - width);
      }
      if (y + 1 < height)
      {
        visit(front[n] + width);
      }
    }
  }

  /// The sites, and known heights near them, by runs of rows.
  std::vector<BoxRun> RunsAround(const std::vector<std::size_t>& sites, const std::vector<double>& known) const
  {
    const int width = this->Lattice.Width, height = this->Lattice.Height;
    std::vector<unsigned char> isSite(known.size(), 0);
    for (const std::size_t site : sites)
    {
      const int x = int(site) % width, y = int(site) / width;
      isSite[site] = 1;
      for (int row = std::max(0, y - Rim); row <= std::min(height - 1, y + Rim); ++row)
      {
        for (int column = std::max(0, x - Rim); column <= std::min(width - 1, x + Rim); ++column)
        {
          const auto node = std::size_t(row) * std::size_t(width) + std::size_t(column);
          isSite[node] = isSite[node] != 0 || std::isfinite(known[node]) ? 1 : 0;
        }
      }
    }
    std::vector<BoxRun> runs;
    for (std::size_t node = 0; node < isSite.size(); ++node)
    {
      const int row = int(node) / width, column = int(node) % width;
      if (isSite[node] != 0 && !runs.empty() && runs.back().Row == row && runs.back().Last == column - 1)
      {
        ++runs.back().Last;
      }
      else if (isSite[node] != 0)
      {
        runs.push_back({ row, column, column });
      }
    }
    return runs;
  }

  /// A plate through the sites, held by springs at known heights around them. A weak membrane keeps it near them far
  /// away.
  std::vector<double> Solve(
    const std::vector<double>& known, const std::vector<std::size_t>& sites, const Monitor& monitor) const
  {
    SiteSystem<2> system(SiteBox::Fill(this->RunsAround(sites, known)));
    const BoxPlaces& near = *system.Sites.Near;
    const auto isIn = [&system](std::int64_t place) { return system.Sites.Number[std::size_t(place)] != NoSite; };
    const auto always = [](auto...) { return true; };
    const auto add = [&system](std::int64_t place, const auto& terms, double weight)
    { AddSquare(system, place, terms, weight); };
    ForEachPlateStencil(near, isIn, always, always, add);
    static constexpr std::array<PlateTerm, 2> alongX = { { { 0, 0, -1.0 }, { 1, 0, 1.0 } } };
    static constexpr std::array<PlateTerm, 2> alongY = { { { 0, 0, -1.0 }, { 0, 1, 1.0 } } };
    constexpr double tension = 1e-6, spring = 1.0, hold = 1e-12;
    const double datum = MeanOf(known);
    const auto nodeOf = [&](std::size_t site)
    {
      const PlanePoint column = near.Column(system.Sites.Place[site]);
      return std::size_t(column.Y) * std::size_t(this->Lattice.Width) + std::size_t(column.X);
    };
    std::vector<double> values(system.Sites.Size(), 0.0);
    for (std::size_t site = 0; site < values.size(); ++site)
    {
      const std::int64_t place = system.Sites.Place[site];
      if (isIn(place + 1))
      {
        add(place, alongX, tension);
      }
      if (isIn(near.Above(place)))
      {
        add(place, alongY, tension);
      }
      const double value = known[nodeOf(site)];
      system.Matrix[site][StencilMatrix<2>::Centre] += std::isfinite(value) ? spring : hold;
      values[site] = std::isfinite(value) ? spring * (value - datum) : 0.0;
    }
    MakeSiteSolver<2>(system)->Solve(values, monitor);
    std::vector<double> heights = known;
    for (std::size_t site = 0; site < values.size(); ++site)
    {
      double& height = heights[nodeOf(site)];
      height = std::isfinite(height) ? height : values[site] + datum;
    }
    return heights;
  }

  const BlockLattice& Lattice;
  const std::vector<SealingFault>& Faults;
  double Column;
};

/// The block of a place farther than `margin` from its faults, or -1.
std::int32_t FindBlockOf(const std::vector<SealingFault>& faults, const std::vector<BlockHeights>& blocks,
  const Eigen::Vector3d& place, double margin)
{
  std::vector<double> distances(faults.size(), NotKnown);
  for (std::size_t n = 0; n < blocks.size(); ++n)
  {
    bool isIn = true;
    for (std::size_t fault = 0; fault < faults.size() && isIn; ++fault)
    {
      const int side = blocks[n].Sides[fault];
      if (side != 0 && std::isnan(distances[fault]))
      {
        distances[fault] = faults[fault].Plate.Distance(faults[fault].Plate.ToPlace(place));
      }
      isIn = side == 0 || side * distances[fault] > margin;
    }
    if (isIn)
    {
      return std::int32_t(n);
    }
  }
  return -1;
}

/// The picks of a horizon by block.
std::vector<BlockHeights> ListPicks(const SealingInput& input, std::size_t number, const BlockLattice& lattice,
  const BlockTree& tree, double drop, PickAccount& account, const Monitor& monitor)
{
  const SealingHorizon& horizon = input.Horizons[number];
  std::vector<BlockHeights> blocks;
  for (const BlockSides& sides : tree.BlocksOf(number))
  {
    BlockHeights block;
    block.Horizon = number;
    block.Sides = sides;
    block.Heights.assign(lattice.Size(), NotKnown);
    block.IsKnown.assign(lattice.Size(), 0);
    blocks.push_back(block);
  }
  std::vector<unsigned char> isDropped(horizon.Columns.size(), 0);
  for (const HorizonCutoffs& cutoffs : horizon.AtFault)
  {
    for (const std::vector<std::size_t>& dropped : cutoffs.Dropped)
    {
      std::for_each(dropped.begin(), dropped.end(), [&](std::size_t pick) { isDropped[pick] = 1; });
    }
  }
  constexpr std::int32_t none = -1;
  std::vector<std::int32_t> blockOf(horizon.Columns.size(), none);
  ParallelFor(std::int64_t(blockOf.size()), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto pick = std::size_t(first); pick < std::size_t(last); ++pick)
      {
        if (lattice.Contains(horizon.Columns[pick]))
        {
          const Eigen::Vector2d onMap = lattice.At(lattice.NodeOf(horizon.Columns[pick]));
          blockOf[pick] = FindBlockOf(input.Faults, blocks, { onMap.x(), onMap.y(), horizon.Heights[pick] }, drop);
        }
      }
    });
  for (std::size_t pick = 0; pick < blockOf.size(); ++pick)
  {
    if (!lattice.Contains(horizon.Columns[pick]) || isDropped[pick] != 0)
    {
      ++(isDropped[pick] != 0 ? account.NotAgreeing : account.Outside);
      continue;
    }
    const std::size_t node = lattice.NodeOf(horizon.Columns[pick]);
    BlockHeights* const block = blockOf[pick] != none ? &blocks[std::size_t(blockOf[pick])] : nullptr;
    if (!block || block->IsKnown[node] != 0)
    {
      ++(!block ? account.BesideFaults : account.Doubled);
      continue;
    }
    ++account.Used;
    ++block->Known;
    block->IsKnown[node] = 1;
    block->Heights[node] = horizon.Heights[pick];
  }
  return blocks;
}

/// The block on the other side of the last fault possible, of those with picks the one with most.
const BlockHeights* FindSibling(const std::vector<BlockHeights>& blocks, const BlockHeights& block, std::size_t horizon)
{
  for (std::size_t fault = block.Sides.size(); fault-- > 0;)
  {
    if (block.Sides[fault] == 0)
    {
      continue;
    }
    const BlockHeights* best = nullptr;
    for (const BlockHeights& other : blocks)
    {
      bool isSibling = other.Horizon == horizon && !other.IsGuessed && other.Sides[fault] == -block.Sides[fault];
      for (std::size_t before = 0; before < fault && isSibling; ++before)
      {
        isSibling = other.Sides[before] == block.Sides[before];
      }
      best = isSibling && (!best || other.Known > best->Known) ? &other : best;
    }
    if (best)
    {
      return best;
    }
  }
  return nullptr;
}

/// Blocks without picks follow the nearest other horizon with picks there, by the thickness across the fault.
void Guess(std::vector<BlockHeights>& blocks, BlockHeights& block)
{
  const BlockHeights* const sibling = FindSibling(blocks, block, block.Horizon);
  if (!sibling)
  {
    return;
  }
  block.Nearest = sibling->Nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const BlockHeights& own : blocks)
  {
    const std::size_t apart = own.Horizon > block.Horizon ? own.Horizon - block.Horizon : block.Horizon - own.Horizon;
    if (own.IsGuessed || apart == 0 || apart >= least || own.Sides != block.Sides)
    {
      continue;
    }
    for (const BlockHeights& beside : blocks)
    {
      if (beside.Horizon == own.Horizon && !beside.IsGuessed && beside.Sides == sibling->Sides)
      {
        least = apart;
        for (std::size_t node = 0; node < block.Heights.size(); ++node)
        {
          block.Nearest[node] = own.Nearest[node] + sibling->Nearest[node] - beside.Nearest[node];
        }
      }
    }
  }
}

/// Horizons of a block keep a distance in which their meshes cannot meet: the lower one gives way.
void PutInOrder(const SealingInput& input, double least, std::vector<BlockHeights>& blocks, std::size_t number,
  std::vector<PickAccount>& accounts)
{
  BlockHeights& block = blocks[number];
  PickAccount& account = accounts[block.Horizon];
  const double highest = input.Top - least * double(block.Horizon + 1);
  const double lowest = input.Base + least * double(input.Horizons.size() - block.Horizon);
  std::vector<const BlockHeights*> above;
  for (std::size_t upper = 0; upper < number; ++upper)
  {
    const bool isAbove =
      blocks[upper].Horizon < block.Horizon && BlockTree::AreTogether(blocks[upper].Sides, block.Sides);
    above.insert(above.end(), isAbove ? 1 : 0, &blocks[upper]);
  }
  for (std::size_t node = 0; node < block.Nearest.size(); ++node)
  {
    double most = highest;
    for (const BlockHeights* const other : above)
    {
      most = std::isfinite(other->Heights[node]) ? std::min(most, other->Heights[node] - least) : most;
    }
    const double height = std::max(lowest, std::min(most, block.Nearest[node]));
    const double move = block.IsKnown[node] != 0 ? std::abs(height - block.Nearest[node]) : 0.0;
    account.Moved += move > 0.0 ? 1 : 0;
    account.LargestMove = std::max(account.LargestMove, move);
    block.Nearest[node] = height;
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonBlocks FindBlockHeights(const SealingInput& input, const SealingOptions& options, const Monitor& monitor)
{
  const BlockLattice lattice(input);
  const BlockTree tree(input.Faults);
  const BlockFiller filler(lattice, input.Faults);
  const double drop = options.DropDistance * input.Step.maxCoeff();
  HorizonBlocks result;
  std::vector<BlockHeights>& blocks = result.Blocks;
  result.Accounts.resize(input.Horizons.size());
  for (std::size_t horizon = 0; horizon < input.Horizons.size(); ++horizon)
  {
    std::vector<BlockHeights> own = ListPicks(input, horizon, lattice, tree, drop, result.Accounts[horizon], monitor);
    if (std::none_of(own.begin(), own.end(), [](const BlockHeights& block) { return block.Known >= FewestOfBlock; }))
    {
      throw InputError("horizon " + input.Horizons[horizon].Name + " without " + std::to_string(FewestOfBlock) +
        " picks in any block, expected more");
    }
    ParallelFor(std::int64_t(own.size()), 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto n = std::size_t(first); n < std::size_t(last); ++n)
        {
          own[n].IsGuessed = own[n].Known < FewestOfBlock;
          if (!own[n].IsGuessed)
          {
            filler.Fill(own[n], Monitor());
          }
        }
      });
    std::move(own.begin(), own.end(), std::back_inserter(blocks));
  }
  for (BlockHeights& block : blocks)
  {
    if (block.IsGuessed)
    {
      Guess(blocks, block);
    }
  }
  for (std::size_t n = 0; n < blocks.size(); ++n)
  {
    PutInOrder(input, LeastApart * options.MaximumError, blocks, n, result.Accounts);
    filler.Limit(blocks[n], result.Accounts[blocks[n].Horizon]);
  }
  return result;
}
}
