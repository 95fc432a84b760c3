// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonStack_h
#define SeismicHorizonsHorizonStack_h

#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/Layers/CommonColumns.h"
#include "Filters/Algorithms/Layers/Crossings.h"
#include "Filters/Common/LatticePoints.h"
#include "Filters/Common/PlacedPoints.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct StackedHorizon
{
  std::string Name;
  LatticePoints Points; // on the horizon's own lattice
  PlacedPoints Placed; // on the lattice of the stack
  std::vector<unsigned char> IsFilled; // array Filled by point; empty without it
};

class HorizonStack
{
public:
  /// Skips horizons without visible points. Throws InputError as ReadColumns, and on simplified meshes.
  void Add(const std::string& name, const Horizon& horizon);

  /// Uses the lattice with the smallest bins, or the first of these, and the smallest vertical index. Throws InputError
  /// for less than two horizons, if points are off its columns, or z or the unit of x and y differ.
  void PlaceTogether();

  std::size_t Size() const { return this->Horizons.size(); }
  const StackedHorizon& operator[](std::size_t n) const { return this->Horizons[n]; }
  const Lattice& CommonLattice() const { return this->Together; }
  /// Empty unless vertical directions of the files differ.
  const std::string& GetDoubt() const { return this->Doubt; }
  /// Joined from all horizons.
  const SurveyDescription& GetSurvey() const { return this->Survey; }
  /// True if the uppermost horizon has the least heights in lattice units.
  bool HeightsGrowDownwards() const;

  std::vector<std::string> Names() const;
  /// `order` has indices of horizons.
  void Reorder(const std::vector<std::size_t>& order);
  /// Views refer to the memory of the stack.
  std::vector<HorizonView> Views() const;
  /// World z as given, by horizon and point.
  HeightStack WorldHeights() const;

  /// If a step of a horizon spans several links of the stack, all of them are cut.
  std::optional<LinkCuts> FindCuts() const;

  void WriteFields(ArrayTable& data) const;

private:
  void RefineHeights();
  void CoverAll();

  std::vector<StackedHorizon> Horizons;
  Horizon Frame; // horizon whose lattice is used
  SurveyDescription Survey;
  std::string Doubt;
  PlanePoint Shift; // columns by which CoverAll moved the origin
  std::array<int, 3> Dimensions = {};
  Eigen::Matrix4d Map;
  Lattice Together; // lattice of Map and Dimensions
  PlaneBox Box; // box of all columns
};
}

#endif
