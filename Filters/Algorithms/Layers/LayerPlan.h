// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// One triangulation in plan for a stack of horizons, with a height of each at every vertex: what lies between two
// horizons over a triangle is then a wedge with vertical sides, and layers share their points.
//
//   1. The domain is the columns in which all horizons have heights; or those of all layers together, whose borders the
//      plan then has (LayerRegions.h). Neighbouring horizons that cross there are put in order (Crossings.h), and where
//      points are missing, heights may be put in (MissingHeights.h).
//   2. The outline is that of the domain (ExteriorBoundary.h), with the fewest points for which all horizons are within
//      the error along it (BoundarySimplification.h).
//   3. Where two horizons become one over an area, vertices and edges are put on the line around it.
//   4. Points are inserted where the largest error over all horizons is largest (Decimation.h).
//   5. With the best effort, and for fitted heights, as Decimation.h does, with the errors of all horizons. At each
//      vertex heights stay in order, and those of horizons that are one all around the column stay the same.
//
// All heights at a vertex are in order, and surfaces are linear in between: so no thickness is negative anywhere.

#ifndef SeismicHorizonsLayerPlan_h
#define SeismicHorizonsLayerPlan_h

#include "Common/LinkCuts.h"
#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Types.h"
#include "Decimation/Decimation.h"
#include "LayerLedger.h"
#include "OrderedStack.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
struct LayerOptions
{
  /// Where each layer has a domain of its own, outlines and borders stay as they are in plan: Radius and
  /// SmallestHoleSize are 1 and the outline tolerance is 0, and other values are refused.
  LayerDomain Domain = LayerDomain::Common;
  /// What is done where horizons have no point.
  MissingOptions Missing;
  /// The largest vertical distance of a point of any horizon from its surface, and of sides of the plan from lines
  /// between neighbouring columns that they cross, in lattice units: at least 0.
  double MaximumError = ErrorOfWholeVoxels;
  /// Of the outline, in columns; ToleranceOfOutlines (Surface.h) where it has no value.
  std::optional<double> OutlineTolerance;
  /// As in SurfaceOptions; chosen where they have no value.
  std::optional<int> Radius;
  std::optional<std::int64_t> SmallestHoleSize;
  bool HoleBoundaries = true;
  std::int64_t MinimumPatchSize = 1;
  /// Where faults cut any of the horizons, or null. Layers end at both cutoffs of a fault, and have a crack between
  /// them.
  const LinkCuts* Cuts = nullptr;
  /// Which horizon is uppermost, and what is done where they cross.
  CrossingOptions Crossings;
  /// What the plan is like: as in DecimationQuality. Simulators want larger angles than surfaces do.
  bool FitHeights = true;
  DecimationEffort Effort = DecimationEffort::Best;
  double SmallestAngle = 10.0;
  /// Whether the thickness of each layer is within the error as well; else its errors are up to twice that.
  bool BoundThickness = false;
  /// Whether the plan has the lines around areas where a layer has no thickness (PinchOuts.h), of so many columns.
  bool PinchOutLines = true;
  std::int64_t SmallestPinch = 25;
};

struct LayerPlan
{
  /// The place of each vertex, all of which are corners of triangles, be it at faults, and for each horizon its height.
  std::vector<PlanePoint> Columns;
  HeightStack Heights;
  bool HeightsGrowDownwards = false;
  /// Three vertices per triangle, counter-clockwise seen from +z on the lattice.
  RawVector<PointId> Triangles;
  /// For each layer, by triangle, 1 where it is. Empty where all layers are everywhere. Where no layer at a vertex has
  /// a horizon, that has the height of its neighbour in the stack.
  std::vector<std::vector<unsigned char>> IsIn;
  /// Triangles between the two sides of cracks, alike, in which no layer is: they show what the layers leave out there.
  RawVector<PointId> FaultTriangles;
  /// For each layer, by such triangle, 1 where it is on all sides of it. Empty where all layers are everywhere.
  std::vector<std::vector<unsigned char>> IsAround;
  /// How much of these triangles layers without cuts would fill: less than 1 where gaps lie along faults.
  double FaultShare = 1.0;

  bool HasLayer(std::size_t layer, std::size_t triangle) const
  {
    return this->IsIn.empty() || this->IsIn[layer][triangle] != 0;
  }
  /// Whether a layer above or below a horizon has a triangle.
  bool HasHorizon(std::size_t horizon, std::size_t triangle) const
  {
    return (horizon > 0 && this->HasLayer(horizon - 1, triangle)) ||
      (horizon < this->NumberOfLayers() && this->HasLayer(horizon, triangle));
  }
  std::size_t NumberOfHorizons() const { return this->Heights.size(); }
  std::size_t NumberOfLayers() const { return this->Heights.empty() ? 0 : this->Heights.size() - 1; }
  std::size_t NumberOfTriangles() const { return this->Triangles.size() / 3; }
  /// Of the layer below a horizon at a vertex: at least 0, and 0 only where the two heights are the same number.
  double Thickness(std::size_t layer, PointId vertex) const
  {
    const double difference = this->Heights[layer][std::size_t(vertex)] - this->Heights[layer + 1][std::size_t(vertex)];
    return this->HeightsGrowDownwards ? 0.0 - difference : difference;
  }
};

struct Layers
{
  OrderedStack Stack; // what the plan was made of
  LayerPlan Plan;
  /// With which the outline was found.
  int Radius = 1;
  std::int64_t SmallestHoleSize = 1;
  double OutlineTolerance = 0.0;
  /// For each horizon the largest error at columns inside the plan, vertices included, and that of inner sides.
  std::vector<double> LargestErrors;
  std::vector<double> LargestSideErrors;
  /// For each layer that of its thickness, where that is bound; else empty.
  std::vector<double> LargestThicknessErrors;
  LayerLedgers Ledgers;
  /// How many edges pinch-out lines have, and how many of them are no sides of the plan, as they cross others or have
  /// ends outside.
  std::size_t PinchOutLines = 0;
  std::size_t LinesLeftOut = 0;
};

/// The uppermost horizon first, all on one lattice; heights are finite and in lattice units. Empty horizons and those
/// without a column in common are refused, as are those that RepairCrossings refuses (InputError). The result does not
/// depend on the order of points or the number of threads.
Layers MakeLayers(const std::vector<HorizonView>& horizons, const LayerOptions& options = LayerOptions(),
  const Monitor& monitor = Monitor());
}

#endif
