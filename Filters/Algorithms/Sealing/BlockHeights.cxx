// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockHeights.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/ConvexHull.h"
#include "FaultNetwork.h"
#include "Filters/Algorithms/HoleFilling/PlateEnergy.h"
#include "Filters/Algorithms/HoleFilling/SiteSolver.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int32_t NoBlock = -1;
constexpr double Beyond = 4.0; // columns that heights are continued beyond faults
constexpr int Around = 4; // columns kept around a block
constexpr double LeastApart = 2.5; // errors, between horizons of a block
constexpr double LeastTipStep = 3.0; // errors, of a fault beyond its tips
constexpr std::size_t FewestSteps = 6; // places of one
constexpr double MostHeave = 30.0; // columns, of one
constexpr double BeyondSteps = 5.3; // columns that it goes on; no whole number, as ribbons may not lie on other edges
constexpr std::size_t FewestOfBlock = 6; // of a block that follows them
constexpr double LeastNew = 0.01; // of the nodes of a continuation, for another one
constexpr int Rim = 6; // columns of picks that the continuation follows
constexpr std::int32_t FirstWidening = 64; // columns that a window grows by; four times as many each time

/// Visits the neighbours of a node in a window.
template <typename Visitor>
void ForEachBeside(const BlockWindow& window, std::size_t node, Visitor&& visit)
{
  const std::size_t width = window.Width(), x = node % width;
  if (x > 0)
  {
    visit(node - 1);
  }
  if (x + 1 < width)
  {
    visit(node + 1);
  }
  if (node >= width)
  {
    visit(node - width);
  }
  if (node + width < window.Size())
  {
    visit(node + width);
  }
}

double DistanceToLine(const std::vector<Eigen::Vector2d>& loop, const Eigen::Vector2d& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < loop.size(); ++n)
  {
    const Eigen::Vector2d way = loop[(n + 1) % loop.size()] - loop[n], to = place - loop[n];
    const double part = std::clamp(to.dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (to - part * way).norm());
  }
  return least;
}

/// A place of a fault, S and Z, where a horizon steps.
struct StepPlace
{
  Eigen::Vector2d Place;
  bool IsHighest; // of the uppermost horizon
  bool IsLowest;
};

class BlockFiller
{
public:
  explicit BlockFiller(const SealingInput& input)
    : Input(input)
    , All(WindowOf(input, Margin))
    , Corners(input.Corners())
    , Column(input.Step.maxCoeff())
  {
  }

  const BlockWindow& Everywhere() const { return this->All; }
  bool IsInWalls(const PlanePoint& column) const
  {
    return WindowOf(this->Input).Contains(column) &&
      (this->Input.Outline.empty() || SeismicHorizons::IsInside(this->Corners, this->PlaceOf(column, 0.0).head<2>()));
  }

  /// Continues the picks of the blocks of a horizon over them.
  void FillAll(std::vector<BlockHeights>& blocks, const Monitor& monitor) const
  {
    ParallelFor(std::int64_t(blocks.size()), 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto n = std::size_t(first); n < std::size_t(last); ++n)
        {
          blocks[n].IsGuessed = blocks[n].Known < FewestOfBlock;
          if (!blocks[n].IsGuessed)
          {
            this->Fill({}, 0.0, blocks[n]);
          }
        }
      });
  }

  /// Places beyond the tips of a fault where picks on its sides step by more than `apart`, by fault: S and Z.
  void FindSteps(
    const std::vector<BlockHeights>& blocks, double apart, std::vector<std::vector<StepPlace>>& steps) const
  {
    for (std::size_t n = 0; n < blocks.size(); ++n)
    {
      for (std::size_t other = 0; other < n; ++other)
      {
        const std::optional<std::size_t> fault = this->FaultBetween(blocks[other], blocks[n]);
        if (fault)
        {
          this->AddSteps(
            blocks[other], blocks[n], *fault, apart, steps[this->Input.Faults[*fault].PartOf.value_or(*fault)]);
        }
      }
    }
  }

  /// Beyond the tips of a fault its sides are one: later blocks follow earlier ones where they agree or have no picks.
  void Join(double apart, std::vector<BlockHeights>& blocks, const Monitor& monitor) const
  {
    for (std::size_t n = 0; n < blocks.size(); ++n)
    {
      monitor.Progress(double(n) / double(blocks.size()));
      std::vector<const BlockHeights*> others;
      for (std::size_t other = 0; other < n; ++other)
      {
        others.insert(others.end(), this->FaultBetween(blocks[other], blocks[n]) ? 1 : 0, &blocks[other]);
      }
      if (!others.empty())
      {
        this->Fill(others, apart, blocks[n]);
      }
    }
  }

  /// Keeps horizons of a block at a distance in which their meshes cannot meet, where the lower one gives way. Then finds the
  /// nodes of the block and some around, whatever their heights are: so a steep horizon leaves its block through a fault,
  /// and does not end before.
  void Limit(
    const std::vector<const BlockHeights*>& above, double apart, BlockHeights& block, PickAccount& account) const
  {
    for (std::int32_t around = FirstWidening;; around *= 4)
    {
      this->PutBelow(above, apart, block, account);
      if (this->MarkMeshed(block))
      {
        break;
      }
      this->Widen(block, around);
    }
    for (const unsigned char node : block.Nodes)
    {
      account.Columns += (node & IsThere) != 0 ? 1 : 0;
      account.Continued += (node & (IsThere | HasPick)) == IsThere ? 1 : 0;
      block.IsInBox = block.IsInBox || (node & IsThere) != 0;
    }
    if (const BlockWindow meshed = WindowOfMeshed(block);
        !meshed.IsEmpty()) // Otherwise the horizon is above or below all of its block, which far heights tell.
    {
      Move(block, meshed);
    }
  }

private:
  static constexpr std::int32_t Margin = 4; // columns around the box

  /// Continues the picks of a block over it, in a window that grows until it holds the block.
  void Fill(const std::vector<const BlockHeights*>& others, double apart, BlockHeights& block) const
  {
    for (std::int32_t around = FirstWidening;; around *= 4)
    {
      for (const BlockHeights* const other : others)
      {
        this->Share(*other, *this->FaultBetween(*other, block), apart, block);
      }
      if (this->FillWindow(block))
      {
        return;
      }
      this->Widen(block, around);
    }
  }

  /// The only fault between two blocks of a horizon with picks, if it dies out.
  std::optional<std::size_t> FaultBetween(const BlockHeights& a, const BlockHeights& b) const
  {
    std::optional<std::size_t> between;
    for (std::size_t fault = 0; fault < a.Sides.size(); ++fault)
    {
      if (a.Sides[fault] * b.Sides[fault] < 0)
      {
        if (between || this->Input.Faults[fault].TipLoop.empty())
        {
          return std::nullopt;
        }
        between = fault;
      }
    }
    return a.Horizon == b.Horizon && !a.IsGuessed && !b.IsGuessed ? between : std::nullopt;
  }

  Eigen::Vector3d PlaceOf(const PlanePoint& column, double height) const
  {
    return { this->Input.Step.x() * column.X, this->Input.Step.y() * column.Y, height };
  }

  /// How far a place of a block is from the nearest of its faults, in columns; negative beyond one, where any may be told.
  double InsideOf(const BlockHeights& block, const PlanePoint& column, double height) const
  {
    const Eigen::Vector3d place = this->PlaceOf(column, height);
    double inside = std::numeric_limits<double>::infinity();
    for (std::size_t fault = block.Sides.size();
         fault-- > 0 && inside >= -Beyond * this->Column;) // The last ones bound it.
    {
      const FaultPlate& plate = this->Input.Faults[fault].Plate;
      const int side = block.Sides[fault];
      inside = side != 0 ? std::min(inside, side * plate.Distance(plate.ToPlace(place))) : inside;
    }
    return inside / this->Column;
  }

  /// Where a place is on the fault between two blocks, if it is up to `most` behind it for the first one, beyond its tips, and
  /// on their side of all others.
  std::optional<FaultPlace> FindBehind(const BlockHeights& block, const BlockHeights& other, std::size_t between,
    const Eigen::Vector3d& place, double most) const
  {
    const SealingFault& fault = this->Input.Faults[between];
    const FaultPlace at = fault.Plate.ToPlace(place);
    const double behind = other.Sides[between] * fault.Plate.Distance(at);
    bool isThere = behind > 0.0 && behind <= most && fault.IsBeyondTips(at);
    for (std::size_t n = 0; n < block.Sides.size() && isThere; ++n)
    {
      const FaultPlate& plate = this->Input.Faults[n].Plate;
      if (n != between && (block.Sides[n] != 0 || other.Sides[n] != 0))
      {
        const double distance = plate.Distance(plate.ToPlace(place));
        isThere = block.Sides[n] * distance >= 0.0 && other.Sides[n] * distance >= 0.0;
      }
    }
    return isThere ? std::optional<FaultPlace>(at) : std::nullopt;
  }

  void AddSteps(const BlockHeights& a, const BlockHeights& b, std::size_t between, double apart,
    std::vector<StepPlace>& steps) const
  {
    constexpr double beside = 1.0, beyond = 2.0; // columns, of the fault and its tips
    constexpr double clear = 4.0; // times the least step, which may be as near to the tips
    constexpr double around = 6.0; // columns, beside the heave
    const SealingFault& fault = this->Input.Faults[between];
    for (std::size_t node = 0; node < a.Nodes.size(); ++node)
    {
      const PlanePoint column = a.Window.ColumnOf(node);
      const double height = b.HeightNear(column);
      if (!b.Window.Contains(column) || std::abs(a.Heights[node] - height) <= apart)
      {
        continue;
      }
      const std::optional<FaultPlace> at =
        this->FindBehind(a, b, between, this->PlaceOf(column, height), beside * this->Column);
      const double heave = fault.Plate.Lean() * std::abs(a.Heights[node] - height) / this->Column;
      const auto near = std::int32_t(around + std::min(heave, MostHeave));
      const bool isClear = std::abs(a.Heights[node] - height) > clear * apart;
      if (at && a.HasPickNear(column, near) && b.HasPickNear(column, near) &&
        (isClear || DistanceToLine(fault.TipLoop, { at->S, at->Z }) > beyond * this->Column))
      {
        const bool isHighest = a.Horizon == 0, isLowest = a.Horizon + 1 == this->Input.Horizons.size();
        steps.push_back({ { at->S, at->Z }, isHighest, isLowest });
        steps.push_back({ { at->S, at->Z + a.Heights[node] - height }, isHighest, isLowest });
      }
    }
  }

  /// Takes heights of another block behind the fault between both, beyond its tips.
  void Share(const BlockHeights& other, std::size_t between, double apart, BlockHeights& block) const
  {
    for (std::size_t node = 0; node < block.Nodes.size(); ++node)
    {
      const PlanePoint column = block.Window.ColumnOf(node);
      if (block.Nodes[node] != 0 || !other.Window.Contains(column))
      {
        continue;
      }
      const double height = other.HeightNear(column);
      const bool isBehind =
        this->FindBehind(block, other, between, this->PlaceOf(column, height), Beyond * this->Column).has_value();
      if (isBehind && (std::abs(height - block.Heights[node]) <= apart || !block.HasPickNear(column, 2 * int(Beyond))))
      {
        block.Nodes[node] = IsShared;
        block.Heights[node] = height;
      }
    }
  }

  /// Whether the window ends there, but not the lattice.
  bool IsEdge(const BlockWindow& window, const PlanePoint& column) const
  {
    return (column.X == window.Least.X && column.X > this->All.Least.X) ||
      (column.Y == window.Least.Y && column.Y > this->All.Least.Y) ||
      (column.X == window.Greatest.X && column.X < this->All.Greatest.X) ||
      (column.Y == window.Greatest.Y && column.Y < this->All.Greatest.Y);
  }

  /// The same block in another window. New nodes have the nearest height.
  static void Move(BlockHeights& block, const BlockWindow& window)
  {
    std::vector<double> heights(window.Size());
    std::vector<unsigned char> nodes(window.Size(), 0);
    window.ForEach(
      [&](const PlanePoint& column, std::size_t node)
      {
        heights[node] = block.HeightNear(column);
        nodes[node] = block.Window.Contains(column) ? block.Nodes[block.Window.NodeOf(column)] : 0;
      });
    block.Heights = std::move(heights);
    block.Nodes = std::move(nodes);
    block.Window = window;
  }

  void Widen(BlockHeights& block, std::int32_t columns) const { Move(block, block.Window.Grown(columns, this->All)); }

  static BlockWindow WindowOfMeshed(const BlockHeights& block)
  {
    BlockWindow meshed;
    block.Window.ForEach(
      [&](const PlanePoint& column, std::size_t node)
      {
        if ((block.Nodes[node] & IsMeshed) != 0)
        {
          meshed.Add(column);
        }
      });
    return meshed;
  }

  /// Step by step from picks, since how far the block reaches depends on the heights. Columns around the box, which are cut
  /// off, have the nearest height. False if the window is too small.
  bool FillWindow(BlockHeights& block) const
  {
    std::vector<double> known(block.Heights.size(), NoValue);
    for (std::size_t node = 0; node < known.size(); ++node)
    {
      known[node] = (block.Nodes[node] & (HasPick | IsShared)) != 0 ? block.Heights[node] : NoValue;
    }
    std::vector<double> heights = known;
    std::vector<std::size_t> sites;
    const BlockWindow box = WindowOf(this->Input, 1);
    constexpr int mostRounds = 6;
    for (int round = 0; round < mostRounds; ++round)
    {
      bool isCutOff = false;
      std::size_t near = 0;
      const std::size_t before = sites.size();
      Spread(block.Window, heights,
        [&](std::size_t node, double height)
        {
          const PlanePoint column = block.Window.ColumnOf(node);
          const double inside = box.Contains(column) ? this->InsideOf(block, column, height) : -2.0 * Beyond;
          const bool isInside = inside >= -Beyond;
          sites.insert(sites.end(), isInside ? 1 : 0, node);
          isCutOff = isCutOff || (isInside && this->IsEdge(block.Window, column));
          near += inside >= -0.5 * Beyond ? 1 : 0;
          return isInside;
        });
      if (isCutOff)
      {
        return false;
      }
      if (double(near) <= LeastNew * double(before))
      {
        sites.resize(before);
        break;
      }
      std::sort(sites.begin(), sites.end());
      heights = Solve(block.Window, known, sites);
    }
    Spread(block.Window, heights, [](std::size_t, double) { return true; });
    block.Heights = std::move(heights);
    return true;
  }

  /// Gives nodes without a height the one of the nearest node, as far as accepts(node, height).
  template <typename Accepts>
  static void Spread(const BlockWindow& window, std::vector<double>& heights, Accepts&& accepts)
  {
    std::vector<std::size_t> front;
    for (std::size_t node = 0; node < heights.size(); ++node)
    {
      if (std::isfinite(heights[node]))
      {
        front.push_back(node);
      }
    }
    for (std::size_t n = 0; n < front.size(); ++n)
    {
      const double height = heights[front[n]];
      ForEachBeside(window, front[n],
        [&](std::size_t node)
        {
          if (std::isnan(heights[node]) && accepts(node, height))
          {
            heights[node] = height;
            front.push_back(node);
          }
        });
    }
  }

  /// The sites, and known heights near them, by runs of rows.
  static std::vector<BoxRun> RunsAround(
    const BlockWindow& window, const std::vector<std::size_t>& sites, const std::vector<double>& known)
  {
    std::vector<unsigned char> isSite(known.size(), 0);
    for (const std::size_t site : sites)
    {
      BlockWindow own;
      own.Add(window.ColumnOf(site));
      isSite[site] = 1;
      own.Grown(Rim, window)
        .ForEach(
          [&](const PlanePoint& column, std::size_t)
          {
            const std::size_t node = window.NodeOf(column);
            isSite[node] = isSite[node] != 0 || std::isfinite(known[node]) ? 1 : 0;
          });
    }
    std::vector<BoxRun> runs;
    for (std::size_t node = 0; node < isSite.size(); ++node)
    {
      const auto row = std::int32_t(node / window.Width()), column = std::int32_t(node % window.Width());
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
  static std::vector<double> Solve(
    const BlockWindow& window, const std::vector<double>& known, const std::vector<std::size_t>& sites)
  {
    SiteSystem<2> system(SiteBox::Fill(RunsAround(window, sites, known)));
    const BoxPlaces& near = *system.Sites.Near;
    const auto isIn = [&system](std::int64_t place) { return system.Sites.Number[std::size_t(place)] != NoSite; };
    const auto always = [](auto...) { return true; };
    const auto add = [&system](std::int64_t place, const auto& terms, double weight)
    { AddSquare(system, place, terms, weight); };
    ForEachPlateStencil(near, isIn, always, always, add);
    static constexpr std::array<PlateTerm, 2> alongX = { { { 0, 0, -1.0 }, { 1, 0, 1.0 } } };
    static constexpr std::array<PlateTerm, 2> alongY = { { { 0, 0, -1.0 }, { 0, 1, 1.0 } } };
    constexpr double tension = 1e-6, spring = 1.0, hold = 1e-12;
    const double datum = *std::find_if(known.begin(), known.end(), [](double height) { return std::isfinite(height); });
    const auto nodeOf = [&](std::size_t site)
    {
      const PlanePoint column = near.Column(system.Sites.Place[site]);
      return std::size_t(column.Y) * window.Width() + std::size_t(column.X);
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
    MakeSiteSolver<2>(system)->Solve(values, Monitor());
    std::vector<double> heights = known;
    for (std::size_t site = 0; site < values.size(); ++site)
    {
      double& height = heights[nodeOf(site)];
      height = std::isfinite(height) ? height : values[site] + datum;
    }
    return heights;
  }

  /// The lower horizon gives way.
  void PutBelow(
    const std::vector<const BlockHeights*>& above, double apart, BlockHeights& block, PickAccount& account) const
  {
    const double highest = this->Input.Top - apart * double(block.Horizon + 1);
    const double lowest = this->Input.Base + apart * double(this->Input.Horizons.size() - block.Horizon);
    std::vector<double> heights(block.Heights.size());
    ParallelFor(std::int64_t(heights.size()), Grain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto node = std::size_t(first); node < std::size_t(last); ++node)
        {
          const PlanePoint column = block.Window.ColumnOf(node);
          double most = highest;
          for (const BlockHeights* const other : above)
          {
            most = other->Has(column, IsMeshed) ? std::min(most, other->HeightNear(column) - apart) : most;
          }
          heights[node] = std::max(lowest, std::min(most, block.Heights[node]));
        }
      });
    for (std::size_t node = 0; node < heights.size(); ++node)
    {
      const double move = (block.Nodes[node] & HasPick) != 0 ? std::abs(heights[node] - block.Heights[node]) : 0.0;
      account.Moved += move > 0.0 ? 1 : 0;
      account.LargestMove = std::max(account.LargestMove, move);
    }
    block.Heights = std::move(heights);
  }

  /// False if the window is too small.
  bool MarkMeshed(BlockHeights& block) const
  {
    ParallelFor(std::int64_t(block.Nodes.size()), Grain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto node = std::size_t(first); node < std::size_t(last); ++node)
        {
          const PlanePoint column = block.Window.ColumnOf(node);
          const double inside = this->InsideOf(block, column, block.Heights[node]);
          const bool isThere = inside >= 0.0 && this->IsInWalls(column);
          block.Nodes[node] = (block.Nodes[node] & HasPick) | (inside >= -1.0 ? IsMeshed : 0) | (isThere ? IsThere : 0);
        }
      });
    std::vector<std::size_t> front, next; // nodes beside those that are meshed
    const auto addBeside = [&](std::size_t node)
    {
      ForEachBeside(block.Window, node,
        [&](std::size_t other) { next.insert(next.end(), (block.Nodes[other] & IsMeshed) != 0 ? 0 : 1, other); });
    };
    for (std::size_t node = 0; node < block.Nodes.size(); ++node)
    {
      if ((block.Nodes[node] & IsMeshed) != 0)
      {
        addBeside(node);
      }
    }
    for (int step = 0; step < Around; ++step)
    {
      front = std::exchange(next, {});
      std::for_each(front.begin(), front.end(), [&](std::size_t node) { block.Nodes[node] |= IsMeshed; });
      std::for_each(front.begin(), front.end(), addBeside);
    }
    const BlockWindow meshed = WindowOfMeshed(block);
    return meshed.IsEmpty() ||
      !(this->IsEdge(block.Window, meshed.Least) || this->IsEdge(block.Window, meshed.Greatest));
  }

  const SealingInput& Input;
  BlockWindow All;
  std::vector<Eigen::Vector2d> Corners;
  double Column;
};

/// The block of each pick, or NoBlock if it is not used, or within `drop` of a fault. Beyond tips there is no fault.
std::vector<std::int32_t> FindBlockOfPoints(const SealingInput& input, std::size_t number, const BlockWindow& all,
  const std::vector<unsigned char>& isDropped, const BlockTree& tree, double drop, const Monitor& monitor)
{
  const SealingHorizon& horizon = input.Horizons[number];
  const std::vector<BlockSides> blocks = tree.BlocksOf(number);
  std::vector<std::int32_t> blockOf(horizon.Columns.size(), NoBlock);
  ParallelFor(std::int64_t(blockOf.size()), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto pick = std::size_t(first); pick < std::size_t(last); ++pick)
      {
        const PlanePoint& column = horizon.Columns[pick];
        const Eigen::Vector3d place(input.Step.x() * column.X, input.Step.y() * column.Y, horizon.Heights[pick]);
        bool isUsed = all.Contains(column) && isDropped[pick] == 0;
        const auto isHanging = [&](std::size_t fault)
        {
          const FaultPlate& plate = input.Faults[fault].Plate;
          const FaultPlace at = plate.ToPlace(place);
          const double distance = plate.Distance(at);
          isUsed = isUsed && distance != 0.0 && (std::abs(distance) > drop || input.Faults[fault].IsBeyondTips(at));
          return distance > 0.0;
        };
        if (isUsed)
        {
          const auto found = std::find(blocks.begin(), blocks.end(), tree.FindAt(number, isHanging));
          blockOf[pick] = isUsed ? std::int32_t(found - blocks.begin()) : NoBlock;
        }
      }
    });
  return blockOf;
}

/// The picks of a horizon by block.
std::vector<BlockHeights> ListBlockPicks(const SealingInput& input, std::size_t number, const BlockFiller& filler,
  const BlockTree& tree, double drop, PickAccount& account, const Monitor& monitor)
{
  const SealingHorizon& horizon = input.Horizons[number];
  const BlockWindow& all = filler.Everywhere();
  std::vector<BlockHeights> blocks;
  for (const BlockSides& sides : tree.BlocksOf(number))
  {
    blocks.emplace_back();
    blocks.back().Horizon = number;
    blocks.back().Sides = sides;
  }
  std::vector<unsigned char> isDropped(horizon.Columns.size(), 0);
  for (const HorizonCutoffs& cutoffs : horizon.AtFault)
  {
    for (const std::vector<std::size_t>& dropped : cutoffs.Dropped)
    {
      std::for_each(dropped.begin(), dropped.end(), [&](std::size_t pick) { isDropped[pick] = 1; });
    }
  }
  const std::vector<std::int32_t> blockOf = FindBlockOfPoints(input, number, all, isDropped, tree, drop, monitor);
  for (std::size_t pick = 0; pick < blockOf.size(); ++pick)
  {
    if (blockOf[pick] != NoBlock)
    {
      blocks[std::size_t(blockOf[pick])].Window.Add(horizon.Columns[pick]);
    }
  }
  for (BlockHeights& block : blocks)
  {
    block.Window = block.Window.IsEmpty() ? all : block.Window.Grown(FirstWidening, all);
    block.Heights.assign(block.Window.Size(), NoValue);
    block.Nodes.assign(block.Window.Size(), 0);
  }
  for (std::size_t pick = 0; pick < blockOf.size(); ++pick)
  {
    const PlanePoint& column = horizon.Columns[pick];
    if (blockOf[pick] == NoBlock)
    {
      ++(isDropped[pick] != 0 ? account.NotAgreeing : all.Contains(column) ? account.BesideFaults : account.Outside);
      continue;
    }
    BlockHeights& block = blocks[std::size_t(blockOf[pick])];
    const std::size_t node = block.Window.NodeOf(column);
    if (block.Nodes[node] != 0)
    {
      ++account.Doubled;
      continue;
    }
    // Those behind walls along the outline shape the horizon up to the walls.
    ++(input.Outline.empty() || filler.IsInWalls(column) ? account.Used : account.Outside);
    ++block.Known;
    block.Nodes[node] = HasPick;
    block.Heights[node] = horizon.Heights[pick];
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
  block.Heights.resize(block.Window.Size());
  block.Window.ForEach(
    [&](const PlanePoint& column, std::size_t node) { block.Heights[node] = sibling->HeightNear(column); });
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
        block.Window.ForEach([&](const PlanePoint& column, std::size_t node)
          { block.Heights[node] = own.HeightNear(column) + sibling->HeightNear(column) - beside.HeightNear(column); });
      }
    }
  }
}

/// Tip loops around places where picks step, and some columns beyond; up to the top or base of the model for its uppermost or
/// lowest horizon.
void GrowTipLoops(const std::vector<std::vector<StepPlace>>& steps, SealingInput& input, std::vector<TipStep>& grown)
{
  const double reach = BeyondSteps * input.Step.maxCoeff();
  for (std::size_t fault = 0; fault < steps.size(); ++fault)
  {
    SealingFault& own = input.Faults[fault];
    if (steps[fault].size() < FewestSteps)
    {
      continue;
    }
    TipStep& told = grown.emplace_back();
    told.Fault = own.Plate.Name();
    std::vector<Eigen::Vector2d> places = own.TipLoop;
    for (const StepPlace& step : steps[fault])
    {
      const Eigen::Vector2d& place = step.Place;
      told.Distance = std::max(told.Distance, IsInside(own.TipLoop, place) ? 0.0 : DistanceToLine(own.TipLoop, place));
      const double low = step.IsLowest ? input.Base - own.Plate.Datum() : place.y();
      const double high = step.IsHighest ? input.Top - own.Plate.Datum() : place.y();
      for (const double s : { -reach, reach })
      {
        places.emplace_back(place.x() + s, low - reach);
        places.emplace_back(place.x() + s, high + reach);
      }
    }
    own.TipLoop = Straighten(FindHull(std::move(places)), LoopTolerance * input.Step.minCoeff());
    for (SealingFault& part : input.Faults)
    {
      part.TipLoop = part.PartOf == fault ? own.TipLoop : part.TipLoop;
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonBlocks FindBlockHeights(SealingInput& input, const SealingOptions& options, const Monitor& monitor)
{
  const BlockTree tree(input.Faults);
  const BlockFiller filler(input);
  const double drop = options.DropDistance * input.Step.maxCoeff();
  HorizonBlocks result;
  std::vector<BlockHeights>& blocks = result.Blocks;
  result.Accounts.resize(input.Horizons.size());
  const double step = 0.8 / double(input.Horizons.size());
  for (std::size_t horizon = 0; horizon < input.Horizons.size(); ++horizon)
  {
    const Monitor part = monitor.Step(step * double(horizon), step * double(horizon + 1));
    std::vector<BlockHeights> own =
      ListBlockPicks(input, horizon, filler, tree, drop, result.Accounts[horizon], part.Step(0.0, 0.3));
    if (std::none_of(own.begin(), own.end(), [](const BlockHeights& block) { return block.Known >= FewestOfBlock; }))
    {
      throw InputError("horizon " + input.Horizons[horizon].Name + " without " + std::to_string(FewestOfBlock) +
        " picks in any block, expected more");
    }
    filler.FillAll(own, part.Step(0.3, 1.0));
    std::move(own.begin(), own.end(), std::back_inserter(blocks));
  }
  const double apart = LeastTipStep * options.MaximumError;
  std::vector<std::vector<StepPlace>> steps(input.Faults.size());
  filler.FindSteps(blocks, apart, steps);
  GrowTipLoops(steps, input, result.Steps);
  filler.Join(apart, blocks, monitor.Step(0.8, 1.0));
  for (BlockHeights& block : blocks)
  {
    if (block.IsGuessed)
    {
      Guess(blocks, block);
    }
  }
  for (std::size_t n = 0; n < blocks.size(); ++n)
  {
    std::vector<const BlockHeights*> above;
    for (std::size_t upper = 0; upper < n; ++upper)
    {
      const bool isAbove =
        blocks[upper].Horizon < blocks[n].Horizon && BlockTree::AreTogether(blocks[upper].Sides, blocks[n].Sides);
      above.insert(above.end(), isAbove ? 1 : 0, &blocks[upper]);
    }
    filler.Limit(above, LeastApart * options.MaximumError, blocks[n], result.Accounts[blocks[n].Horizon]);
  }
  return result;
}
}
