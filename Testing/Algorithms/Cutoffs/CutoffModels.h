// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons cut by a fault, with their true surfaces: a box of 2 km with bins of 25 m, folded horizons, and sticks.

#ifndef SeismicHorizonsCutoffModels_h
#define SeismicHorizonsCutoffModels_h

#include "Filters/Algorithms/Cutoffs/Cutoffs.h"

#include <functional>
#include <random>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct CutoffModel
{
  std::string Name;
  FaultPicks Fault;
  /// Positive in the hanging wall: the horizontal distance from the true fault.
  std::function<double(const Eigen::Vector3d&)> Distance;
  /// The height of horizon `n` on a wall, continued beyond the fault.
  std::function<double(std::size_t n, FaultWall wall, double x, double y)> Height;
  std::vector<HorizonPicks> Horizons;
};

struct PickErrors
{
  double Noise = 0.0;
  double WrongSide = 0.0; // columns that picks of one wall go on beyond the fault
  double WrongPart = 1.0; // part of these columns
};

enum class FaultForm
{
  Straight,
  Oblique,
  Steep,
  Upright,
  Reverse,
  Listric,
  Flat // level horizons
};

CutoffModel MakeCutoffModel(FaultForm form, const PickErrors& errors, std::mt19937& random);

/// Root mean square and largest height of cutoffs above the true surfaces at their places.
struct CutoffErrors
{
  double Mean = 0.0;
  double Largest = 0.0;
  double OffFault = 0.0; // largest distance from the true fault
  std::size_t Places = 0;
};

/// What one would write without thinking: a least squares plane through the picks of a wall within three columns, continued
/// to the fault. Errors as of MeasureCutoffs, at the same places.
CutoffErrors MeasurePlain(
  const CutoffModel& model, std::size_t horizon, const FaultPlate& fault, const HorizonCutoffs& cutoffs);

CutoffErrors MeasureCutoffs(
  const CutoffModel& model, std::size_t horizon, const FaultPlate& fault, const HorizonCutoffs& cutoffs);
}

#endif
