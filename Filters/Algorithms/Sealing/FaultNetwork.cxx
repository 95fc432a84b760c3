// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultNetwork.h"

#include "BlockHeights.h"
#include "Common/Base/Errors.h"
#include "Common/Horizon/PlaceText.h"
#include "SealedComplex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace SeismicHorizons
{
namespace
{
constexpr double LeastShare = 0.1; // of a fault that counts as beyond another one

/// How much of a fault is on each side of another one.
struct FaultShares
{
  std::array<double, 2> Sides = { 0.0, 0.0 }; // footwall and hanging wall
  std::array<double, 2> Beyond = { 0.0, 0.0 }; // of these, farther than the end distance
  std::array<double, 2> Farthest = { 0.0, 0.0 };
  std::array<Eigen::Vector3d, 2> FarthestPlace;
  bool IsNear = false; // reaches the other one

  bool IsBoth() const
  {
    return std::min(this->Beyond[0], this->Beyond[1]) > LeastShare * (this->Sides[0] + this->Sides[1]);
  }
  bool IsHanging() const { return this->Sides[1] > this->Sides[0]; }
};

/// Places of a fault within its picks and the box.
std::vector<Eigen::Vector3d> PlacesOf(const FaultPlate& plate, const Eigen::AlignedBox3d& box)
{
  constexpr int steps = 48;
  std::vector<Eigen::Vector3d> places;
  for (int row = 0; row <= steps; ++row)
  {
    for (int column = 0; column <= steps; ++column)
    {
      const double s = plate.First() + (plate.Last() - plate.First()) * column / steps;
      const double z = plate.Lowest() + (plate.Highest() - plate.Lowest()) * row / steps;
      const Eigen::Vector3d place = plate.At(s, z);
      if (plate.Contains(s, z) && box.contains(place))
      {
        places.push_back(place);
      }
    }
  }
  return places;
}

/// The closed line around the extent of a fault. Ends for which goesOn(place, way) holds are moved far away.
template <typename GoesOn>
std::vector<Eigen::Vector2d> FindTipLoop(const FaultPlate& plate, double far, GoesOn&& goesOn)
{
  std::array<std::vector<Eigen::Vector2d>, 2> ends; // left and right, upwards
  for (std::size_t level = 0; level < plate.Levels(); ++level)
  {
    const std::array<double, 2> reach = plate.EndsAt(level);
    for (std::size_t side = 0; side < 2 && reach[0] <= reach[1]; ++side)
    {
      const Eigen::Vector2d place(reach[side], plate.Height(level)), way(side == 0 ? -1.0 : 1.0, 0.0);
      ends[side].push_back(goesOn(place, way) ? Eigen::Vector2d(place + far * way) : place);
    }
  }
  for (const bool isTop : { false, true })
  {
    const Eigen::Vector2d left = isTop ? ends[0].back() : ends[0].front();
    const Eigen::Vector2d right = isTop ? ends[1].back() : ends[1].front();
    const Eigen::Vector2d middle = 0.5 * (left + right), way(0.0, isTop ? 1.0 : -1.0);
    for (std::size_t side = 0; side < 2 && goesOn(middle, way); ++side)
    {
      const Eigen::Vector2d corner = (side == 0 ? left : right) + far * way;
      ends[side].insert(isTop ? ends[side].end() : ends[side].begin(), corner);
    }
  }
  std::vector<Eigen::Vector2d> loop = ends[1];
  loop.insert(loop.end(), ends[0].rbegin(), ends[0].rend());
  return loop;
}

class NetworkMaker
{
public:
  NetworkMaker(const std::vector<FaultPlate>& plates, const Eigen::AlignedBox3d& box, double column, double endDistance)
    : Plates(plates)
    , Column(column)
    , Reach(column * endDistance)
  {
    for (const FaultPlate& plate : plates)
    {
      this->Places.push_back(PlacesOf(plate, box));
      const auto area = double(this->Places.back().size()) *
        plate.AreaOf(plate.Last() - plate.First(), plate.Highest() - plate.Lowest(), 0.0, 0.0);
      this->Areas.push_back(area);
    }
    for (std::size_t fault = 0; fault < plates.size(); ++fault)
    {
      this->Shares.emplace_back();
      for (std::size_t other = 0; other < plates.size(); ++other)
      {
        this->Shares.back().push_back(this->SharesOf(fault, other));
      }
    }
    this->Ends.assign(plates.size(), std::vector<unsigned char>(plates.size(), 0));
  }

  void AddRules(const std::vector<EndingRule>& rules)
  {
    const auto numberOf = [this](const std::string& name)
    {
      for (std::size_t fault = 0; fault < this->Plates.size(); ++fault)
      {
        if (this->Plates[fault].Name() == name)
        {
          return fault;
        }
      }
      throw InputError("fault " + name + " in Endings, expected the name of a given fault");
    };
    for (const EndingRule& rule : rules)
    {
      this->Ends[numberOf(rule.Minor)][numberOf(rule.Main)] = 2;
    }
    this->HasRules = !rules.empty();
  }

  FaultNetwork Make()
  {
    FaultNetwork network;
    this->ChooseEnds(network);
    for (const std::size_t fault : this->FindOrder())
    {
      if (this->Places[fault].empty())
      {
        network.Outside.push_back(this->Plates[fault].Name());
        continue;
      }
      this->Add(fault, network);
    }
    return network;
  }

private:
  FaultShares SharesOf(std::size_t fault, std::size_t other) const
  {
    FaultShares shares;
    for (const Eigen::Vector3d& place : this->Places[fault])
    {
      const double distance = this->Plates[other].Distance(this->Plates[other].ToPlace(place));
      const std::size_t side = distance > 0.0 ? 1 : 0;
      shares.IsNear = shares.IsNear || std::abs(distance) <= this->Reach;
      shares.Sides[side] += 1.0;
      shares.Beyond[side] += std::abs(distance) > this->Reach ? 1.0 : 0.0;
      if (std::abs(distance) > shares.Farthest[side])
      {
        shares.Farthest[side] = std::abs(distance);
        shares.FarthestPlace[side] = place;
      }
    }
    return shares;
  }

  void ChooseEnds(FaultNetwork& network)
  {
    for (std::size_t a = 0; a < this->Plates.size(); ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        if (this->Places[a].empty() || this->Places[b].empty())
        {
          continue;
        }
        const FaultShares &ofA = this->Shares[a][b], &ofB = this->Shares[b][a];
        if (std::max({ ofA.Farthest[0], ofA.Farthest[1], ofB.Farthest[0], ofB.Farthest[1] }) < this->Column)
        {
          throw InputError("fault " + this->Plates[a].Name() + " within a column of " + this->Plates[b].Name() +
            ", expected one of them");
        }
        if (this->Ends[a][b] != 0 || this->Ends[b][a] != 0)
        {
          continue;
        }
        const bool aEnds = ofA.IsBoth() == ofB.IsBoth() ? this->Areas[a] < this->Areas[b] : ofB.IsBoth();
        const std::size_t minor = aEnds ? a : b, main = aEnds ? b : a;
        const bool cross = ofA.IsBoth() && ofB.IsBoth();
        if (cross && this->HasRules)
        {
          const Eigen::Vector3d place =
            0.5 * (this->Shares[minor][main].FarthestPlace[0] + this->Shares[minor][main].FarthestPlace[1]);
          throw InputError("fault " + this->Plates[minor].Name() + " crosses " + this->Plates[main].Name() + " near " +
            PlaceText(place) + ", expected a rule in Endings for which of them ends");
        }
        this->Ends[minor][main] = 1;
        if (cross || this->Shares[minor][main].IsNear)
        {
          network.Choices.push_back(
            this->Plates[minor].Name() + " ends at " + this->Plates[main].Name() + (cross ? " on both sides" : ""));
        }
      }
    }
  }

  /// Faults that others end at come first, then large ones. A circle is cut at the largest fault, unless it is of rules.
  std::vector<std::size_t> FindOrder() const
  {
    std::vector<std::size_t> left(this->Plates.size()), order;
    std::iota(left.begin(), left.end(), std::size_t(0));
    std::stable_sort(
      left.begin(), left.end(), [this](std::size_t a, std::size_t b) { return this->Areas[a] > this->Areas[b]; });
    while (!left.empty())
    {
      const auto waits = [&](std::size_t fault, unsigned char least) {
        return std::any_of(
          left.begin(), left.end(), [&](std::size_t other) { return this->Ends[fault][other] >= least; });
      };
      auto next = std::find_if(left.begin(), left.end(), [&](std::size_t fault) { return !waits(fault, 1); });
      next = next != left.end()
        ? next
        : std::find_if(left.begin(), left.end(), [&](std::size_t fault) { return !waits(fault, 2); });
      if (next == left.end())
      {
        throw InputError(
          "fault " + this->Plates[left.front()].Name() + " in a cycle of Endings, expected rules without cycles");
      }
      order.push_back(*next);
      left.erase(next);
    }
    return order;
  }

  /// One fault for each combination of sides of the faults that it crosses.
  void Add(std::size_t number, FaultNetwork& network)
  {
    std::vector<SealingFault> parts = { SealingFault{ this->Plates[number], {}, {}, {} } };
    const std::size_t before = network.Faults.size();
    for (std::size_t fault = 0; fault < before; ++fault)
    {
      const FaultShares& shares = this->Shares[number][network.Plates[fault]];
      const bool isCut = shares.IsBoth() && this->Ends[number][network.Plates[fault]] != 2;
      if (shares.IsBoth() && !isCut)
      {
        const double left = shares.Sides[shares.IsHanging() ? 0 : 1] / (shares.Sides[0] + shares.Sides[1]);
        network.LeftOut.push_back(this->Plates[number].Name() + " in the " +
          (shares.IsHanging() ? "footwall" : "hanging wall") + " of " + this->Plates[network.Plates[fault]].Name() +
          ", " + std::to_string(int(std::lround(100.0 * left))) + " % of it");
      }
      std::vector<SealingFault> next;
      for (const SealingFault& part : parts)
      {
        for (const bool isHanging : { false, true })
        {
          if (!CanMeetRegion(part, network.Faults[fault]))
          {
            next.insert(next.end(), isHanging ? 0 : 1, part);
          }
          else if (isCut || isHanging == shares.IsHanging())
          {
            next.push_back(part);
            next.back().Region.push_back({ fault, isHanging });
          }
        }
      }
      parts = std::move(next);
    }
    for (SealingFault& part : parts)
    {
      part.PartOf = network.Faults.size() > before ? std::optional<std::size_t>(before) : std::nullopt;
      network.Faults.push_back(std::move(part));
      network.Plates.push_back(number);
    }
  }

  /// Whether no earlier fault is between them.
  static bool CanMeetRegion(const SealingFault& a, const SealingFault& b)
  {
    return std::none_of(a.Region.begin(), a.Region.end(),
      [&](const FaultSideOf& side)
      {
        return std::any_of(b.Region.begin(), b.Region.end(),
          [&](const FaultSideOf& other) { return other.Fault == side.Fault && other.IsHanging != side.IsHanging; });
      });
  }

  const std::vector<FaultPlate>& Plates;
  double Column;
  double Reach;
  std::vector<std::vector<Eigen::Vector3d>> Places; // by fault
  std::vector<double> Areas;
  std::vector<std::vector<FaultShares>> Shares; // by fault and other fault
  std::vector<std::vector<unsigned char>> Ends; // by fault and the one it ends at: 1 chosen, 2 by a rule
  bool HasRules = false;
};
}

//----------------------------------------------------------------------------------------------------------------------
FaultNetwork MakeNetwork(const std::vector<FaultPlate>& plates, const Eigen::AlignedBox3d& box, double column,
  double endDistance, const std::vector<EndingRule>& rules)
{
  NetworkMaker maker(plates, box, column, endDistance);
  maker.AddRules(rules);
  return maker.Make();
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<Eigen::Vector2d> Straighten(const std::vector<Eigen::Vector2d>& loop, double tolerance)
{
  const auto areNear =
    [&](const std::vector<Eigen::Vector2d>& places, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    const Eigen::Vector2d way = to - from;
    return std::all_of(places.begin(), places.end(),
      [&](const Eigen::Vector2d& place)
      {
        const Eigen::Vector2d at = place - from;
        return std::abs(way.x() * at.y() - way.y() * at.x()) <= tolerance * way.norm() && at.dot(way) >= 0.0;
      });
  };
  std::vector<Eigen::Vector2d> kept = { loop.front() };
  std::vector<Eigen::Vector2d> dropped;
  for (std::size_t n = 1; n < loop.size(); ++n)
  {
    dropped.push_back(loop[n]);
    if (!areNear(dropped, kept.back(), loop[(n + 1) % loop.size()]))
    {
      kept.push_back(loop[n]);
      dropped.clear();
    }
  }
  dropped.push_back(kept.front());
  if (kept.size() > 3 && areNear(dropped, kept.back(), kept[1]))
  {
    kept.erase(kept.begin());
  }
  return kept;
}

//----------------------------------------------------------------------------------------------------------------------
void EndAtTips(const SealingInput& input, double endDistance, FaultNetwork& network)
{
  const Eigen::AlignedBox3d box = input.Box();
  const std::vector<Eigen::Vector2d> corners = input.Corners();
  const double column = input.Step.minCoeff();
  constexpr double beyond = 4.0; // columns
  const double far = (endDistance + beyond) * column;
  for (std::size_t number = 0; number < network.Faults.size(); ++number)
  {
    SealingFault& fault = network.Faults[number];
    const double gap = network.Gaps[number];
    const FaultPlate& plate = fault.Plate;
    const auto isThere = [&](const Eigen::Vector2d& at)
    {
      const Eigen::Vector3d place = plate.At(at.x(), at.y());
      return box.contains(place) && IsInside(corners, place.head<2>()) &&
        std::all_of(fault.Region.begin(), fault.Region.end(),
          [&](const FaultSideOf& side)
          {
            const FaultPlate& other = network.Faults[side.Fault].Plate;
            return (other.Distance(other.ToPlace(place)) > 0.0) == side.IsHanging;
          });
    };
    const double base = box.min().z() - plate.Datum(), height = box.sizes().z();
    const auto goesOn = [&](const Eigen::Vector2d& place, const Eigen::Vector2d& way)
    {
      constexpr double least = 1e-3; // Above and below the box, ends are as at its top and base.
      const double z = std::clamp(place.y(), base + least * height, base + (1.0 - least) * height);
      const Eigen::Vector2d from(place.x(), way.y() == 0.0 ? z : place.y());
      const bool meetsHorizon = way.y() > 0.0 && fault.EndsBelow && gap <= endDistance * column;
      return meetsHorizon || (isThere(from) && !isThere(from + endDistance * column * way));
    };
    fault.TipLoop = Straighten(FindTipLoop(plate, far, goesOn), LoopTolerance * column);
    constexpr int steps = 256;
    bool hasTips = false;
    for (int n = 0; n < steps * steps && !hasTips; ++n)
    {
      const double s = (double(n % steps) + 0.5) / steps, z = (double(n / steps) + 0.5) / steps;
      const Eigen::Vector2d at(
        plate.First() + (plate.Last() - plate.First()) * s + 2.0 * box.diagonal().norm() * (s - 0.5),
        base + height * z);
      hasTips = isThere(at) && !IsInside(fault.TipLoop, at);
    }
    fault.TipLoop = hasTips ? fault.TipLoop : std::vector<Eigen::Vector2d>();
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t EndAtHorizons(const std::vector<std::size_t>& unconformities, const SealingInput& input,
  const Eigen::AlignedBox3d& box, FaultNetwork& network)
{
  network.Gaps.assign(network.Faults.size(), std::numeric_limits<double>::infinity());
  for (const std::size_t number : unconformities)
  {
    const SealingHorizon& horizon = input.Horizons[number];
    const BlockWindow window = WindowOf(input);
    std::vector<double> heights(window.Size(), NoValue);
    for (std::size_t pick = 0; pick < horizon.Columns.size(); ++pick)
    {
      if (window.Contains(horizon.Columns[pick]))
      {
        heights[window.NodeOf(horizon.Columns[pick])] = horizon.Heights[pick];
      }
    }
    for (std::size_t n = 0; n < network.Faults.size(); ++n)
    {
      SealingFault& fault = network.Faults[n];
      double above = 0.0, all = 0.0, gap = std::numeric_limits<double>::infinity();
      for (const Eigen::Vector3d& place : PlacesOf(fault.Plate, box))
      {
        const Eigen::Vector2d column = (place.head<2>().array() / input.Step.array()).round();
        const double height = heights[window.NodeOf({ std::int32_t(column.x()), std::int32_t(column.y()) })];
        all += std::isnan(height) ? 0.0 : 1.0;
        above += place.z() > height ? 1.0 : 0.0;
        gap = std::min(gap, std::isnan(height) ? gap : height - place.z());
      }
      if (all > 0.0 && above < LeastShare * all)
      {
        fault.EndsBelow = std::max(fault.EndsBelow.value_or(number), number);
        network.Gaps[n] = fault.EndsBelow == number ? gap : network.Gaps[n];
      }
    }
  }
  return std::size_t(std::count_if(network.Faults.begin(), network.Faults.end(),
    [](const SealingFault& fault) { return fault.EndsBelow.has_value(); }));
}
}
