// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons of one survey, on one lattice: what layers lie between.

#ifndef SeismicHorizonsHorizonStack_h
#define SeismicHorizonsHorizonStack_h

#include "Common/Lattice.h"
#include "Common/LinkCuts.h"
#include "Common/PlaneGeometry.h"
#include "LatticePoints.h"
#include "Layers/CommonColumns.h"
#include "Layers/Crossings.h"
#include "PlacedPoints.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace SeismicHorizons
{
struct StackedHorizon
{
  std::string Name;
  LatticePoints Points; // on its own lattice
  PlacedPoints Placed; // on that of the stack
  std::vector<unsigned char> IsFilled; // by point, as in its array; empty without that
};

class HorizonStack
{
public:
  /// The points of one more horizon, none of them hidden. Throws InputError as ReadColumns does, and on a mesh whose
  /// points stand for more points than there are.
  void Add(const std::string& name, vtkPolyData* points);

  /// Brings all to the lattice of the one with the smallest bins, of several the first, and to the smallest vertical
  /// index of all. Throws InputError where points of another one stand between its columns, and where z, or the
  /// unit of x and y, is not the same for all.
  void PlaceTogether();

  std::size_t Size() const { return this->Horizons.size(); }
  const StackedHorizon& operator[](std::size_t n) const { return this->Horizons[n]; }
  const Lattice& CommonLattice() const { return this->Together; }
  /// What is known of it from any of the horizons.
  const SurveyDescription& GetSurvey() const { return this->Survey; }
  /// Whether the uppermost horizon has the least heights in lattice units.
  bool HeightsGrowDownwards() const;

  std::vector<std::string> Names() const;
  /// Keeps the order that it is given: numbers of horizons.
  void Reorder(const std::vector<std::size_t>& order);
  /// Into its own memory.
  std::vector<HorizonView> Views() const;
  /// By horizon and point: z of the world, as it was given.
  HeightStack WorldHeights() const;

  /// The links that faults of any horizon cut. Where steps of its lattice are several of the stack, all in between are.
  std::optional<LinkCuts> FindCuts() const;

  /// Writes the lattice, and what the survey is.
  void WriteFields(vtkFieldData* data) const;

private:
  void RefineHeights();
  void CoverAll();

  std::vector<StackedHorizon> Horizons;
  vtkSmartPointer<vtkPolyData> Frame; // the one whose lattice it is
  SurveyDescription Survey;
  PlanePoint Shift; // of the lattice since, in columns
  std::array<int, 3> Dimensions = {};
  Eigen::Matrix4d Map;
  Lattice Together; // of both
  PlaneBox Box; // of all columns
};
}

#endif
