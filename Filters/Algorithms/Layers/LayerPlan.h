// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// One triangulation in plan for a stack of horizons, with a height of each at every vertex. Heights at vertices are in
// order and surfaces linear in between, so that no thickness is negative. Steps:
//
//   1. Horizons are put in order (Crossings.h) and missing heights put in (MissingHeights.cxx).
//   2. The outline is simplified with all horizons within the error (LayerRegions.h).
//   3. Pinch-out lines (PinchOuts.h) and borders of layers (LayerRegions.h) become edges.
//   4. Points are inserted where the error of any horizon is largest, and the plan is improved (Decimation.h).

#ifndef SeismicHorizonsLayerPlan_h
#define SeismicHorizonsLayerPlan_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/Ledger.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "OrderedStack.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// With the larger angles that simulators want.
struct LayerQuality : MeshQuality
{
  LayerQuality() { this->SmallestAngle = 10.0; }
};

/// With the domain EachLayer, only a radius and a smallest hole of 1 and an outline tolerance of 0 are allowed.
struct LayerOptions
  : StackOptions
  , LayerQuality
{
  /// In lattice units: at least 0.
  double MaximumError = ErrorOfWholeVoxels;
  /// In columns; ToleranceOfOutlines by default. The next two are chosen by default as in SurfaceOptions.
  std::optional<double> OutlineTolerance;
  std::optional<int> Radius;
  std::optional<std::int64_t> SmallestHoleSize;
  /// Whether the thickness of layers is within the error, too; else within twice the error.
  bool BoundThickness = false;
  /// Whether areas of at least SmallestPinch columns without a thickness have lines around them (PinchOuts.h).
  bool PinchOutLines = true;
  std::int64_t SmallestPinch = 25;
};

struct LayerPlan
{
  std::vector<PlanePoint> Columns; // by vertex
  HeightStack Heights; // by horizon and vertex; that of its neighbour where no layer has the horizon
  bool HeightsGrowDownwards = false;
  /// Three vertices per triangle, counter-clockwise seen from +z on the lattice.
  RawVector<PointId> Triangles;
  std::vector<std::vector<unsigned char>> IsIn; // by layer and triangle; empty if all layers are everywhere
  /// Between the two sides of cracks, where no layer is.
  RawVector<PointId> FaultTriangles;
  std::vector<std::vector<unsigned char>> IsAround; // the same for fault triangles: 1 with the layer on all sides
  double FaultShare = 1.0; // of fault triangles that layers without cuts would fill

  bool HasLayer(std::size_t layer, std::size_t triangle) const
  {
    return this->IsIn.empty() || this->IsIn[layer][triangle] != 0;
  }
  bool HasHorizon(std::size_t horizon, std::size_t triangle) const
  {
    return (horizon > 0 && this->HasLayer(horizon - 1, triangle)) ||
      (horizon < this->NumberOfLayers() && this->HasLayer(horizon, triangle));
  }
  std::size_t NumberOfHorizons() const { return this->Heights.size(); }
  std::size_t NumberOfLayers() const { return this->Heights.empty() ? 0 : this->Heights.size() - 1; }
  std::size_t NumberOfTriangles() const { return this->Triangles.size() / 3; }
  std::array<PlanePoint, 3> CornersOf(std::size_t triangle) const
  {
    const auto at = [&](std::size_t corner) { return this->Columns[std::size_t(this->Triangles[corner])]; };
    return { at(3 * triangle), at(3 * triangle + 1), at(3 * triangle + 2) };
  }
  /// At least 0, and 0 only if the two heights are equal.
  double Thickness(std::size_t layer, PointId vertex) const
  {
    const double difference = this->Heights[layer][std::size_t(vertex)] - this->Heights[layer + 1][std::size_t(vertex)];
    return this->HeightsGrowDownwards ? 0.0 - difference : difference;
  }
};

/// Both ends of each side of fault triangles, ascending, with the triangle to the left.
std::vector<std::array<PointId, 2>> FindFaultSides(const LayerPlan& plan);

// The ledgers of layers and their horizons account for all columns.

/// A column is extrapolated where a horizon follows another one, and left out if it has no cell, but would have one if
/// holes and gaps were closed and horizons followed others.
struct LayerLedger
{
  Ledger Columns;
  std::array<double, LedgerEntries> Volumes = {}; // columns times lattice units
  /// Up to the columns at which the cells around end.
  double AreaWithout = 0.0; // columns
  double VolumeWithout = 0.0; // columns times lattice units
};

struct LayerLedgers
{
  std::vector<LayerLedger> OfLayers;
  std::vector<Ledger> OfHorizons;
  std::vector<std::int64_t> PointsOutside; // by horizon: all points in no layer that were read
};

struct Layers
{
  OrderedStack Stack; // without its filled horizons
  LayerPlan Plan;
  std::vector<double> LargestErrors; // by horizon, at columns inside the plan
  std::vector<double> LargestSideErrors; // by horizon, where inner edges cross lines between columns
  std::vector<double> LargestThicknessErrors; // by layer; empty unless they are bound
  LayerLedgers Ledgers;
  std::size_t PinchOutLines = 0; // edges of pinch-out lines
  std::size_t LinesLeftOut = 0; // of these, those that cross others or have ends outside
};

/// Horizons are on one lattice, the uppermost first, with heights in lattice units. Throws InputError as MakeStack does.
Layers MakeLayers(const std::vector<HorizonView>& horizons, const LayerOptions& options = LayerOptions(),
  const Monitor& monitor = Monitor());

/// `indices` of the horizons are needed if the plan has triangles.
LayerLedgers MakeLayerLedgers(const LayerPlan& plan, const OrderedStack& stack,
  const std::vector<HorizonView>& horizons, const std::vector<ColumnIndex>& indices,
  const Monitor& monitor = Monitor());
}

#endif
