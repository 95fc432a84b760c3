// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Turns horizons on a lattice into the points that the stages work on (Documentation/DataModel.md).

#ifndef SeismicHorizonsSurveyDataSet_h
#define SeismicHorizonsSurveyDataSet_h

#include "Common/LatticePlacement.h"
#include "Common/Survey/SurveyHorizons.h"
#include "Common/Survey/VerticalSampling.h"

#include "vtkSmartPointer.h"

class vtkFieldData;
class vtkPolyData;

namespace SeismicHorizons
{
/// What the horizons of a survey have in common.
struct SurveyAxes
{
  SurveyDescription Survey;
  SurveyLattice Lattice;
  double LatticeDeviation = 0.0;
  VerticalSampling Sampling;
  VerticalDirection Direction = VerticalDirection::Down;

  LatticeMatrix ToWorld() const;
};

/// Adds what the data model says of a survey: the lattice and its place in the world, line numbers and units.
void AddSurveyAxes(const SurveyAxes& axes, vtkFieldData* data);

/// Makes a point and a vertex cell of each column of a horizon. Its memory is freed on the way.
vtkSmartPointer<vtkPolyData> MakeSurveyPoints(LatticeHorizon horizon, int surfaceId, const SurveyAxes& axes);
}

#endif
