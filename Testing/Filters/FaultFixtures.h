// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A horizon with a fault between two rows.

#ifndef SeismicHorizonsFaultFixtures_h
#define SeismicHorizonsFaultFixtures_h

#include "HorizonFixtures.h"
#include "vtkHorizonAlgorithm.h"

#include <array>
#include <vector>

namespace FaultFixtures
{
constexpr int Side = 32; // of the lattice
constexpr double Throw = 15.0;
constexpr int LastRowBelow = 11; // of the fault
constexpr int FirstColumn = 2; // of its links
constexpr int LastColumn = 20;

inline double FaultedHeight(int i, int j)
{
  const bool isThrown = j > LastRowBelow && i >= FirstColumn && i <= LastColumn;
  return 10.0 + (isThrown ? Throw : 0.0);
}

inline void AddLinks(vtkPolyData* horizon, const std::vector<std::array<int, 3>>& links)
{
  vtkNew<vtkIntArray> array;
  array->SetName("FaultedLinks");
  array->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> throws;
  throws->SetName("FaultThrow");
  for (const std::array<int, 3>& link : links)
  {
    array->InsertNextTypedTuple(link.data());
    throws->InsertNextValue(Throw);
  }
  horizon->GetFieldData()->AddArray(array);
  horizon->GetFieldData()->AddArray(throws);
}

/// Cut between two rows from a column to another one, or the whole lattice from side to side.
inline vtkSmartPointer<vtkPolyData> MakeFaulted(
  vtkMatrix4x4* survey, int firstColumn = FirstColumn, int lastColumn = LastColumn)
{
  auto horizon = HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(Side, Side), 3, survey, FaultedHeight);
  std::vector<std::array<int, 3>> links;
  for (int i = firstColumn; i <= lastColumn; ++i)
  {
    links.push_back({ i, LastRowBelow, 1 });
  }
  AddLinks(horizon, links);
  return horizon;
}

inline double Figure(vtkPolyData* horizon, const char* name)
{
  vtkDataArray* const array = horizon->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : -1.0;
}

inline vtkPolyData* Update(vtkHorizonAlgorithm* stage)
{
  stage->Update();
  return stage->GetPolyDataOutput();
}
}

#endif
