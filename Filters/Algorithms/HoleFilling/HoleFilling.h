// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// New points in the gaps of a horizon, before it has an outline.
//
// A gap is a group of empty columns, connected side by side, that a patch encloses. Each is closed for itself, by the
// known columns around it:
//  - Plate: a thin plate over the gap and a ring of known columns, that least sum of u_xx^2 + 2 u_xy^2 + u_yy^2 which
//    comes near to the heights of the ring (Briggs 1974, whose surface goes through them). So the noise of single
//    columns does not become the slope of the whole. Then what the ring differs from the plate is carried inwards by a
//    membrane, so that there is no step at the rim.
//  - Membrane: each new column is the mean of its four neighbours (Laplace's equation).
//
// A gap that cuts divide is filled part by part. No stencil and no link of a membrane leads over a cut.

#ifndef SeismicHorizonsHoleFilling_h
#define SeismicHorizonsHoleFilling_h

#include "Common/LinkCuts.h"
#include "Common/Monitor.h"
#include "Common/PlaneGeometry.h"
#include "Common/Types.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
enum class FillMethod
{
  Plate = 0,
  Membrane = 1,
  Automatic = 2 // a plate whose smoothing and rim are chosen by how rough the horizon is
};

struct HoleFillingOptions
{
  /// Gaps of more columns stay open.
  std::int64_t LargestHoleSize = 2500;
  FillMethod Method = FillMethod::Automatic;
  /// Of Plate. How much a plate may differ from the ring: the inverse of the strength of the springs that hold it to
  /// each known column. 0 makes it go through them.
  double RimSmoothing = 1.0;
  /// How many columns wide the ring is.
  int RimWidth = 3;
  /// Columns outside that are at most so many steps, each to one of eight neighbours, from a known one are filled, too.
  int ExtrapolationDistance = 0;
  /// Where these have to be: the columns of a survey; anywhere without any.
  std::optional<PlaneBox> Survey = std::nullopt;
};

constexpr int LargestRimWidth = 64;
constexpr double LargestRimSmoothing = 1e6;
constexpr int LargestExtrapolationDistance = 10000;

/// A number for each point that is filled by a membrane; places where it is not finite count as unknown.
using PointValue = std::function<double(PointId)>;

struct FilledColumns
{
  std::vector<PlanePoint> Column;
  std::vector<double> Height;
  /// The known point nearest to each, counted in steps to one of four neighbours within the gap, of equally near ones
  /// that of the lowest number.
  std::vector<PointId> Nearest;
  /// The values of each attribute; nan where none is known on the rim.
  std::vector<std::vector<double>> Attribute;
  /// The entry that the columns outside begin with.
  std::size_t FirstOutside = 0;
  std::int64_t FilledGaps = 0; // those enclosed
  /// Gaps that are too large, or have a part that is cut off from all known columns.
  std::int64_t OpenGaps = 0;
  /// Of the plates, as given or chosen.
  double RimSmoothing = 0.0;
  int RimWidth = 0;
};

/// `columns` and `heights` have an entry for each point, no two points in one column (InputError). New columns are in
/// the order of their gaps, which rows from the least y meet, and in that of their rows within a gap; those outside,
/// whose groups are gaps of any size, come last. The result does
/// not depend on the number of threads. Memory beyond the result: that of the index, about 600 bytes for each column of
/// the largest gap, whatever its bounding box is, and up to 20 megabytes for each thread.
FilledColumns FillHoles(PlanePoints columns, const std::vector<double>& heights,
  const std::vector<PointValue>& attributes, const HoleFillingOptions& options, const LinkCuts* cuts = nullptr,
  const Monitor& monitor = Monitor());
}

#endif
