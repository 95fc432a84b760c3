// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons and faults with known truth, to be sealed: designed ones, of which each has one difficulty, and random networks
// of faults. Boxes of 2 km with bins of 25 or 50 m. Results are the same on all machines, but for rounding.

#ifndef SeismicHorizonsSealingModels_h
#define SeismicHorizonsSealingModels_h

#include "Filters/Algorithms/Sealing/SealedModel.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Positive in the hanging wall.
using FaultDistance = std::function<double(const Eigen::Vector3d&)>;

struct TrueModel
{
  std::string Name;
  SealingInput Input;
  double Error = 1.0; // to seal with
  std::size_t Eroded = 0; // columns of horizons without a pick
  std::vector<FaultDistance> Distances; // of faults, which go on where they are not in the model
  /// The height of horizon `n` in a block, continued beyond it. Sides are by fault: 1 in the hanging wall, -1 in the
  /// footwall, and 0 if the fault is not there.
  std::function<double(std::size_t n, const std::vector<int>& sides, double x, double y)> Height;
};

struct TruePlace
{
  std::size_t Layer; // 0 is above the first horizon
  std::vector<int> Sides;
};

/// From one straight fault with level horizons to faults that meet. In "noise" picks are wrong up to 40 m beyond the fault,
/// so that columns nearer than 1.8 must be dropped.
std::vector<std::string> DesignedModels();
TrueModel MakeDesignedModel(const std::string& name);

/// Of 1 to `mostFaults` curved faults, each in the block where it was put. Nothing if horizons leave the box or have no
/// picks: then take the next seed.
std::optional<TrueModel> MakeRandomNetwork(unsigned seed, int mostFaults);

/// Faults in order: one is there if its region is and it is below the horizon that it ends at. A place on a fault is in its
/// footwall, and one on a horizon is above it.
TruePlace FindTruePlace(const TrueModel& model, const Eigen::Vector3d& place);

double AreaInWalls(const TrueModel& model);

/// By layer from the top: sums over the middles of `columns` x `columns` fine columns, along which horizons and faults are
/// exact. Only a fault that a column meets twice within a `levels`th part of its height is missed there.
std::vector<double> TrueVolumes(const TrueModel& model, int columns, int levels);

/// What models are made of.
namespace ModelParts
{
constexpr double Length = 2000.0; // of boxes along x and y
constexpr double Pi = 3.14159265358979323846;

/// Distributions of the standard library differ between compilers.
class Random
{
public:
  explicit Random(unsigned seed)
    : Engine(seed)
  {
  }

  double Fraction() { return double(this->Engine()) / 4294967296.0; }
  double Between(double least, double greatest) { return least + (greatest - least) * this->Fraction(); }
  std::size_t Below(std::size_t count) { return std::size_t(double(count) * this->Fraction()); }

  /// Box-Muller.
  double Normal(double deviation)
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - this->Fraction()));
    return deviation * radius * std::cos(2.0 * Pi * this->Fraction());
  }

private:
  std::mt19937 Engine;
};

/// A plane with waves. It dips to the east; strike turns it counter-clockwise on the map.
struct WavyFault
{
  Eigen::Vector3d Origin;
  Eigen::Vector3d Normal;
  Eigen::Vector3d Along;
  Eigen::Vector3d Up;
  double Amplitude = 0.0;
  double WaveLength = 1.0; // divided by 2 pi

  WavyFault(const Eigen::Vector3d& origin, double dip, double strike)
    : Origin(origin)
  {
    const double angle = dip * Pi / 180.0, turn = strike * Pi / 180.0;
    const double level = dip == 90.0 ? 0.0 : std::cos(angle);
    this->Normal = { std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), level };
    this->Along = Eigen::Vector3d::UnitZ().cross(this->Normal).normalized();
    this->Up = this->Normal.cross(this->Along);
  }

  double Wave(double s, double t) const
  {
    return this->Amplitude * std::sin(s / this->WaveLength) * std::cos(t / this->WaveLength);
  }

  double Distance(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d from = place - this->Origin;
    return from.dot(this->Normal) - this->Wave(from.dot(this->Along), from.dot(this->Up));
  }

  Eigen::Vector3d OnPlane(double s, double t) const { return this->Origin + s * this->Along + t * this->Up; }
};

/// Where a fault dies out: at an ellipse by distance along it on the map, and height.
struct TipEllipse
{
  Eigen::Vector3d Middle = { 900.0, 0.5 * Length, -1200.0 };
  Eigen::Vector2d Along = Eigen::Vector2d::UnitY();
  double HalfLength = 600.0;
  double HalfHeight = 450.0;

  /// 1 in the middle, 0 from the ellipse on.
  double PartAt(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d from = place - this->Middle;
    return std::max(0.0,
      1.0 - std::pow(from.head<2>().dot(this->Along) / this->HalfLength, 2) - std::pow(from.z() / this->HalfHeight, 2));
  }
};

/// Folded horizons of one form, one below the other.
struct WavyLayers
{
  std::vector<double> Depths;
  double Amplitude = 25.0;
  Eigen::Vector2d WaveLength = { 420.0, 560.0 }; // divided by 2 pi
  Eigen::Vector2d Slope = { 0.0, 0.02 };
  std::vector<std::vector<double>> Throws = {}; // by fault and horizon
  double Fade = 0.0; // distance from x = 900 over which throws fall to 1/e; 0 if they do not
  bool IsScissors = false; // Throws grow along y and change their sign in the middle.
  bool IsHalf = false; // Throws grow from the middle along y, and are none before.
  std::vector<std::optional<TipEllipse>> Tips = {}; // by fault; may be shorter

  double Height(std::size_t n, const std::vector<int>& sides, double x, double y) const
  {
    double height = this->Depths[n] +
      this->Amplitude * std::sin(x / this->WaveLength.x()) * std::cos(y / this->WaveLength.y()) +
      this->Slope.x() * (x - 0.5 * Length) + this->Slope.y() * (y - 0.5 * Length);
    const double along = (y - 0.5 * Length) / (0.5 * Length);
    const double part = this->Fade > 0.0 ? std::exp(-std::abs(x - 900.0) / this->Fade)
      : this->IsScissors                 ? along
      : this->IsHalf                     ? std::max(0.0, along)
                                         : 1.0;
    for (std::size_t fault = 0; fault < sides.size(); ++fault)
    {
      const double ofTip =
        fault < this->Tips.size() && this->Tips[fault] ? this->Tips[fault]->PartAt({ x, y, this->Depths[n] }) : 1.0;
      height -= sides[fault] > 0 ? ofTip * part * this->Throws[fault][n] : 0.0;
    }
    return height;
  }
};

struct PickErrors
{
  double Noise = 0.0;
  double WrongSide = 0.0; // distance beyond faults up to which half of the columns have picks
};

/// Once all faults are there.
void AddHorizons(TrueModel& model, const WavyLayers& layers, const PickErrors& errors, Random& random);
SealingFault& AddFault(TrueModel& model, FaultPicks picks, FaultDistance distance);
/// Of S and Z of the plate.
std::vector<Eigen::Vector2d> MakeTipLoop(const FaultPlate& plate, const WavyFault& shape, const TipEllipse& tips);

/// Without horizons and faults.
inline TrueModel MakeBox(const std::string& name, int columns, double top, double base)
{
  TrueModel model;
  model.Name = name;
  model.Input.Step *= Length / (columns - 1);
  model.Input.Greatest = { columns - 1, columns - 1 };
  model.Input.Top = top;
  model.Input.Base = base;
  return model;
}

/// placeAt(stick, n) is a place, or nothing. Numbers are from minus the most to the most.
template <typename PlaceAt>
void AddSticks(FaultPicks& picks, int mostSticks, int mostPlaces, PlaceAt&& placeAt)
{
  for (int stick = -mostSticks; stick <= mostSticks; ++stick)
  {
    std::optional<Eigen::Vector3d> last;
    for (int n = -mostPlaces; n <= mostPlaces; ++n)
    {
      const std::optional<Eigen::Vector3d> next = placeAt(stick, n);
      if (last && next)
      {
        picks.Segments.push_back({ *last, *next });
      }
      last = next;
    }
  }
}

inline bool HoldsRegion(const SealingFault& fault, const std::vector<int>& sides)
{
  return std::all_of(fault.Region.begin(), fault.Region.end(),
    [&sides](const FaultSideOf& side) { return sides[side.Fault] == 0 || (sides[side.Fault] > 0) == side.IsHanging; });
}

template <typename IsThere>
std::vector<int> FindSides(const TrueModel& model, const Eigen::Vector3d& place, IsThere&& isThere)
{
  const std::vector<SealingFault>& faults = model.Input.Faults;
  std::vector<int> sides(faults.size(), 0);
  for (std::size_t n = 0; n < faults.size(); ++n)
  {
    if (HoldsRegion(faults[n], sides) && isThere(faults[n]))
    {
      sides[n] = model.Distances[n](place) > 0.0 ? 1 : -1;
    }
  }
  return sides;
}

/// Of the faults that cut a horizon.
inline std::vector<int> SidesOn(const TrueModel& model, std::size_t horizon, const Eigen::Vector3d& place)
{
  return FindSides(
    model, place, [=](const SealingFault& fault) { return !fault.EndsBelow || *fault.EndsBelow < horizon; });
}

inline bool IsBelow(const TrueModel& model, std::size_t horizon, const Eigen::Vector3d& place)
{
  return place.z() < model.Height(horizon, SidesOn(model, horizon, place), place.x(), place.y());
}

inline std::vector<int> SidesAt(const TrueModel& model, const Eigen::Vector3d& place)
{
  return FindSides(model, place,
    [&](const SealingFault& fault) { return !fault.EndsBelow || IsBelow(model, *fault.EndsBelow, place); });
}

/// All that there may be.
inline std::vector<std::vector<int>> BlocksOf(const std::vector<SealingFault>& faults)
{
  std::vector<std::vector<int>> blocks = { std::vector<int>(faults.size(), 0) };
  for (std::size_t n = 0; n < faults.size(); ++n)
  {
    std::vector<std::vector<int>> next;
    for (std::vector<int>& sides : blocks)
    {
      const bool isThere = HoldsRegion(faults[n], sides);
      for (const int side : { 1, -1, 0 })
      {
        if (side == 0 ? !isThere || faults[n].EndsBelow : isThere)
        {
          sides[n] = side;
          next.push_back(sides);
        }
      }
    }
    blocks = std::move(next);
  }
  return blocks;
}

/// The least distance from the faults of a block, negative beyond one.
inline double DistanceInside(const TrueModel& model, const std::vector<int>& sides, const Eigen::Vector3d& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < sides.size(); ++n)
  {
    least = sides[n] == 0 ? least : std::min(least, sides[n] * model.Distances[n](place));
  }
  return least;
}
}
}

#endif
