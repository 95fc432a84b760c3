// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of layers, and their volumes. Over a triangle of the plan, a layer is
//
//   a wedge          where it has a thickness at all three corners
//   a pyramid        where it has none at one of them
//   a tetrahedron    where it has none at two
//   nothing          where it has none at all.
//
// Sides of cells are vertical, top and base are planes: so volumes are exact for the plan, to the rounding of sums.

#ifndef SeismicHorizonsLayerCells_h
#define SeismicHorizonsLayerCells_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Types.h"
#include "LayerPlan.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// The cells of all layers, layer by layer from the uppermost, in each by the triangles of the plan.
struct LayerCells
{
  /// Points that layers share: one for each vertex of the plan and each height that horizons have there.
  std::vector<PointId> Vertices;
  std::vector<double> Heights;
  /// For each horizon the point at each vertex; NoPoint where none of its layers is.
  std::vector<std::vector<PointId>> PointsOfHorizons;

  /// Cells have 6, 5 or 4 corners: from Ends[n - 1] on, or 0, to before Ends[n]. Their order is that of VTK where x, y
  /// and heights are a right-handed system, heights upwards: of a wedge first the triangle whose normal points
  /// outwards, of a pyramid first the quadrangle whose normal points to the apex, which is its last corner, of a
  /// tetrahedron first the triangle whose normal points to the last corner.
  RawVector<PointId> Corners;
  std::vector<std::int64_t> Ends;
  std::vector<std::int32_t> Layers; // the number of the horizon above
  std::vector<std::int32_t> Triangles; // of the plan
  std::vector<double> Thickness; // the mean, in lattice units
  std::vector<double> Volumes; // columns times lattice units

  std::size_t Size() const { return this->Ends.size(); }
};

LayerCells MakeLayerCells(const LayerPlan& plan, const Monitor& monitor = Monitor());

/// Of one layer, in columns and lattice units: an area of 1 is that between four columns.
struct LayerVolume
{
  double Volume = 0.0;
  double Area = 0.0; // of the cells
  double MeanThickness = 0.0; // over that area
  double LeastThickness = 0.0; // of its corners
  double LargestThickness = 0.0;
  std::array<std::int64_t, 4> Triangles = {}; // by how many corners have a thickness: [3] counts wedges, [0] no cells
  /// What the layer leaves out between the two sides of faults, were it there as thick as beside them.
  double FaultArea = 0.0;
  double FaultVolume = 0.0;
};

LayerVolume MeasureLayer(const LayerPlan& plan, std::size_t layer);

/// The volume of a layer above a level contact at this height, as of gas above oil: the integral of the positive part
/// of top - contact less that of base - contact, each linear over a triangle, in closed form.
double VolumeAbove(const LayerPlan& plan, std::size_t layer, double contact);

/// The integral, over a triangle, of the positive part of a linear function with these values at its corners.
double IntegrateAboveZero(double area, std::array<double, 3> values);
}

#endif
