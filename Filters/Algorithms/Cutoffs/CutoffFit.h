// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a horizon meets a fault, from the picks on one side of it. At a place along the fault:
//
// 1. Picks within six columns are kept if they agree with a surface through those farther away, a curved one or a plane:
//    trackers follow the wrong side for some columns, or climb the fault.
// 2. Surfaces of second order through the picks kept, weighted by the distance from the foot, are continued to the
//    fault. Of several widths, the largest counts whose confidence interval meets those of all smaller ones (Lepski's
//    rule), so that noise is averaged where the surface is plain, and followed where it bends.

#ifndef SeismicHorizonsCutoffFit_h
#define SeismicHorizonsCutoffFit_h

#include "Common/Horizon/Types.h"
#include "FaultPlate.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
struct CutoffFitOptions
{
  double Column = 1.0; // the distance of columns across the fault, which distances from it are counted in
  double Row = 1.0; // the distance of columns along the fault
  double Noise = 0.0; // standard deviation of heights
  double LeastSpread = 0.0; // Rounding does not average out.
  double DropDistance = 0.5; // columns; nearer picks are not used
  double DropNoise = 4.0; // Picks off by more deviations do not agree; 0 keeps all.
  double LargestGap = 20.0; // columns
};

/// Faults near another one, by number.
constexpr std::size_t MostOthers = 256;
using FaultBits = std::bitset<MostOthers>;

/// A pick of a horizon beside a fault.
struct SidePick
{
  FaultPlace Place;
  double Distance = 0.0; // from the fault, at least 0
  std::size_t Number = 0; // of the horizon's picks
  FaultBits Near; // The other fault reaches as far as the pick.
  FaultBits Hanging; // The pick is on its hanging wall.
};

/// Faults near another one, which divide its sides further.
class OtherFaults
{
public:
  /// Those within `reach` count. `margin` is added to their extent. Throws InputError for more than MostOthers.
  OtherFaults(const FaultPlate& fault, const std::vector<const FaultPlate*>& others, double margin, double reach);

  void Mark(const Eigen::Vector3d& world, SidePick& pick) const;
  /// Whether a fault is within the margin of the place.
  bool IsAt(const Eigen::Vector3d& world) const;
  static bool AreBetween(const SidePick& a, const SidePick& b)
  {
    return ((a.Near | b.Near) & (a.Hanging ^ b.Hanging)).any();
  }

private:
  std::vector<const FaultPlate*> Faults;
  double Margin;
};

/// Picks of one side in strips along the fault.
class FaultSide
{
public:
  /// Strips of a width between two places along the fault. Picks of a strip stay in the order of their parts.
  FaultSide(double first, double last, double width, const std::vector<std::vector<SidePick>>& parts);

  /// Calls visit(pick) for the picks between two places along the fault, in a fixed order.
  template <typename Visitor>
  void ForEach(double from, double to, Visitor&& visit) const
  {
    for (std::size_t n = this->Begins[this->StripOf(from)]; n < this->Begins[this->StripOf(to) + 1]; ++n)
    {
      if (this->Picks[n].Place.S >= from && this->Picks[n].Place.S <= to)
      {
        visit(this->Picks[n]);
      }
    }
  }

private:
  std::size_t StripOf(double s) const;

  double First;
  double Width;
  std::size_t Strips;
  std::vector<SidePick> Picks;
  std::vector<std::size_t> Begins;
};

struct CutoffPlace
{
  double Height = NoValue; // NaN if unknown
  double Offset = NoValue; // of the fault there
  double Spread = NoValue; // standard deviation of the height as far as noise explains it
  double Gap = NoValue; // columns to the nearest pick that was kept
  bool IsChecked = true; // Picks near the fault were compared with others.
  std::vector<std::size_t> Dropped; // picks in the strip of one column that do not agree, by number
};

/// By wall, the footwall first.
std::array<CutoffPlace, 2> FitCutoffs(const FaultPlate& fault, const OtherFaults& others,
  const std::array<FaultSide, 2>& sides, double s, const CutoffFitOptions& options);
}

#endif
