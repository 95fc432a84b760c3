// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A horizon with a step, fault lines on it, and errors of the filter for faults.

#ifndef SeismicHorizonsFaultLineFixtures_h
#define SeismicHorizonsFaultLineFixtures_h

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkHorizonFaults.h"
#include "vtkMatrix4x4.h"

#include <array>
#include <iostream>
#include <string>
#include <vector>

namespace FaultLineFixtures
{
using HorizonFixtures::Errors;

/// A step of 7 downwards between the columns 14 and 15.
inline double Torn(int i, int)
{
  return i < 15 ? 20.0 : 27.0;
}

inline double Level(int, int)
{
  return 20.0;
}

inline vtkSmartPointer<vtkPolyData> Horizon(double (*height)(int, int), vtkMatrix4x4* survey)
{
  return HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(30, 25), 7, survey, height);
}

/// A polyline through places in columns.
inline vtkSmartPointer<vtkPolyData> Line(
  const std::vector<std::array<double, 2>>& places, vtkMatrix4x4* survey, bool isPolygon)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(int(places.size()));
  for (const std::array<double, 2>& place : places)
  {
    const double lattice[4] = { place[0], place[1], -500.0, 1.0 };
    double world[4];
    survey->MultiplyPoint(lattice, world);
    cells->InsertCellPoint(points->InsertNextPoint(world));
  }
  lines->SetPoints(points);
  isPolygon ? lines->SetPolys(cells) : lines->SetLines(cells);
  return lines;
}

inline vtkPolyData* Faults(vtkHorizonFaults* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
}

inline void CheckError(vtkHorizonFaults* filter, const std::string& message)
{
  const Errors errors(filter);
  filter->Modified();
  filter->Update();
  CHECK_EQUAL(errors.Count(), 1U);
  if (!CHECK(errors.FirstContains(message)))
  {
    std::cerr << errors.First() << '\n';
  }
  CHECK_EQUAL(filter->GetPolyDataOutput()->GetNumberOfPoints(), 0);
}
}

#endif
