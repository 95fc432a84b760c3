// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of layers, and their volumes. Over a triangle of the plan, a layer is a wedge if it has a thickness at three
// corners, a pyramid at two, a tetrahedron at one, and nothing at none. Sides are vertical, and top and base are planes,
// so that volumes are exact for the plan. Sublayers are cells of the same kinds; tetrahedra split these on request.

#ifndef SeismicHorizonsLayerCells_h
#define SeismicHorizonsLayerCells_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/Types.h"
#include "LayerPlan.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// By layers from the uppermost down, and by triangles of the plan.
struct LayerCells
{
  std::vector<PointId> Vertices;
  std::vector<double> Heights;
  std::vector<std::vector<PointId>> PointsOfHorizons; // by horizon and vertex; NoPoint where none of its layers is
  /// 6, 5 or 4 corners per cell, in the order of VTK if x, y and heights upwards are right-handed.
  RawVector<PointId> Corners;
  std::vector<std::int64_t> Ends; // of the corners of each cell
  std::vector<std::int32_t> Layers; // the number of the horizon above
  std::vector<std::int32_t> Sublayers; // from 0 at the top of the layer
  std::vector<std::int32_t> Triangles;
  std::vector<double> Thickness; // the mean, in lattice units
  std::vector<double> Volumes; // columns times lattice units

  std::size_t Size() const { return this->Ends.size(); }
  std::int64_t Begin(std::size_t cell) const { return cell == 0 ? 0 : this->Ends[cell - 1]; }
  std::size_t SizeOf(std::size_t cell) const { return std::size_t(this->Ends[cell] - this->Begin(cell)); }
};

struct LayerCellOptions
{
  /// By layer, at least 1; empty for one each. Each divides the thickness equally, and ends where the layer does.
  std::vector<int> Sublayers;
  /// Splits all cells through their point with the smallest number, so that those of neighbours fit together.
  bool Tetrahedra = false;

  int SublayersOf(std::size_t layer) const { return this->Sublayers.empty() ? 1 : this->Sublayers[layer]; }
};

LayerCells MakeLayerCells(
  const LayerPlan& plan, const LayerCellOptions& options = LayerCellOptions(), const Monitor& monitor = Monitor());

/// The size of a layer in columns and lattice units: the area between four columns is 1.
struct LayerVolume
{
  double Volume = 0.0;
  double Area = 0.0;
  double MeanThickness = 0.0;
  double LeastThickness = 0.0;
  double LargestThickness = 0.0;
  std::array<std::int64_t, 4> Triangles = {}; // by the number of corners with a thickness: [3] are wedges
  /// The strips along faults, if the layer were as thick there as beside them.
  double FaultArea = 0.0;
  double FaultVolume = 0.0;
};

LayerVolume MeasureLayer(const LayerPlan& plan, std::size_t layer);

/// The volume of a layer above a level contact at this height, as of gas above oil.
double VolumeAbove(const LayerPlan& plan, std::size_t layer, double contact);

/// The integral over a triangle of the positive part of a linear function with these values at the corners.
double IntegrateAboveZero(double area, std::array<double, 3> values);
}

#endif
