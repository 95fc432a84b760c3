// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cutoffs of a horizon at a fault: the lines where it meets the fault on the footwall and on the hanging wall.
//
//         footwall        hanging wall
//      -----------o                        o  cutoffs, on the fault
//                  \                       throw: the height of the upper line above the lower one
//                   \                      heave: how far they are apart on the map, across strike
//                    o-----------

#ifndef SeismicHorizonsCutoffs_h
#define SeismicHorizonsCutoffs_h

#include "Common/Base/Monitor.h"
#include "CutoffFit.h"
#include "FaultPlate.h"

#include <array>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
enum FaultWall : std::size_t
{
  Footwall = 0,
  HangingWall = 1
};

enum class HeightSource : unsigned char
{
  Picks = 0, // within two columns of the cutoff
  Extrapolated = 1,
  Interpolated = 2 // along the fault, or at a tip
};

/// A place along the fault, with both walls.
struct CutoffPair
{
  double S = 0.0;
  std::array<CutoffPlace, 2> Wall;
  std::array<HeightSource, 2> Source = { HeightSource::Picks, HeightSource::Picks };

  double Throw() const { return this->Wall[Footwall].Height - this->Wall[HangingWall].Height; }
  double Heave() const { return this->Wall[HangingWall].Offset - this->Wall[Footwall].Offset; }
  /// NaN at a fault of unknown dip.
  double Heave(const FaultPlate& fault) const { return fault.HasDip() ? this->Heave() : NoValue; }
  Eigen::Vector3d Place(const FaultPlate& fault, FaultWall wall) const
  {
    return fault.ToWorld({ this->S, this->Wall[wall].Offset, this->Wall[wall].Height });
  }
  bool IsGuessed() const
  {
    return this->Source[Footwall] != HeightSource::Picks || this->Source[HangingWall] != HeightSource::Picks;
  }
};

/// A part of a fault that cuts the horizon, along strike. At a tip both cutoffs are one.
struct CutoffPiece
{
  std::vector<CutoffPair> Pairs;
  std::array<bool, 2> IsTip = { false, false };

  double Length(const FaultPlate& fault, FaultWall wall) const;
};

struct HorizonPicks
{
  std::vector<Eigen::Vector3d> Places;
  Eigen::Matrix2d Steps = Eigen::Matrix2d::Identity(); // columns of the matrix: on the map from column to column
  double Noise = 0.0; // standard deviation of z
  bool IsRounded = false; // The noise is that of rounding.

  double LargestStep() const { return this->Steps.colwise().norm().maxCoeff(); }
};

struct HorizonCutoffs
{
  std::vector<CutoffPiece> Pieces;
  std::size_t Short = 0; // pieces left out
  std::array<std::vector<std::size_t>, 2> Dropped; // picks that do not agree, by wall and number
};

/// One pair per column of the horizon along the fault. `faults` are all that cut the horizon. Pieces of less than
/// `leastLength` columns are left out.
HorizonCutoffs FindCutoffs(const FaultPlate& fault, const std::vector<const FaultPlate*>& faults,
  const HorizonPicks& horizon, CutoffFitOptions options, double leastLength, const Monitor& monitor = Monitor());

double SumOfThrows(const HorizonCutoffs& cutoffs);

/// For upright faults, whose hanging wall is where horizons lie lower.
void SwapWalls(HorizonCutoffs& cutoffs);

/// Returns numbers of pairs, the first and the last included, so that the line through the places of these on a wall is
/// within `heightError` and `offsetError` of all others. Pairs where the source of the height changes are kept.
std::vector<std::size_t> SimplifyCutoff(
  const CutoffPiece& piece, FaultWall wall, double heightError, double offsetError);
}

#endif
