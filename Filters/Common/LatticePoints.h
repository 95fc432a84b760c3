// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The only place where points get columns. All functions throw InputError on a horizon that breaks the data model
// (Documentation/DataModel.md).

#ifndef SeismicHorizonsLatticePoints_h
#define SeismicHorizonsLatticePoints_h

#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Types.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
struct LatticePoints
{
  /// Computes the height from coordinates, for when heights are not kept.
  double HeightAt(std::size_t point) const;

  SeismicHorizons::Horizon Horizon; // the input with the array Column, in double precision
  SeismicHorizons::Lattice Lattice;
  PlanePoints Column; // the memory of the array Column; NoColumn for merged points
  std::vector<double> Height; // lattice units; empty unless kept
  bool AreMerged = false; // True if some points are merged.
  std::optional<double> Deviation; // the largest distance from a column, if the array Column was made
};

/// Stages that need few heights save the memory and time.
enum class KeptHeights
{
  All,
  None
};

/// Points must be visible, unmerged, and at columns to 0.01 or the rounding of single precision. Without a valid array
/// Column, nearest columns are used.
LatticePoints ReadColumns(const Horizon& horizon, KeptHeights heights = KeptHeights::All);

/// The same for a part of a horizon, whose heights are checked together with others (HeightCheck).
LatticePoints ReadColumnsOfPart(const Horizon& part);

/// Throws InputError unless there are less than 2^29.
void CheckNumberOfPoints(std::int64_t size);

/// Points may be merged. Without the array Column, if any point is beside a column, all but those exactly at one count
/// as merged.
LatticePoints ReadPoints(const Horizon& horizon, KeptHeights heights = KeptHeights::All);

/// Adds LatticeDeviation if points were placed in their nearest columns.
void WriteDeviation(const LatticePoints& points, std::vector<Horizon>& outputs);

/// For a horizon from ReadColumns, ReadPoints or a stage.
PlanePoints ColumnsOf(const Horizon& horizon);

/// Merged points included.
std::vector<PlanePoint> ToSubVoxels(const LatticePoints& points);
}

#endif
