// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Small horizons for the tests of the filters.

#ifndef SeismicHorizonsHorizonFixtures_h
#define SeismicHorizonsHorizonFixtures_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace HorizonFixtures
{
/// The map of a survey: unit steps, or turned and in metres far from the origin, with depth downwards.
inline vtkSmartPointer<vtkMatrix4x4> UnitSurvey()
{
  return vtkSmartPointer<vtkMatrix4x4>::New();
}

inline vtkSmartPointer<vtkMatrix4x4> RotatedSurvey()
{
  auto map = UnitSurvey();
  const double values[16] = { 10.8, -12.5, 0, 604321.25, 6.25, 21.6, 0, 6079543.5, 0, 0, -4, 100, 0, 0, 0, 1 };
  map->DeepCopy(values);
  return map;
}

inline void AddLattice(vtkPolyData* horizon, const int dimensions[3], vtkMatrix4x4* toWorld)
{
  vtkNew<vtkIntArray> size;
  size->SetName("LatticeDimensions");
  size->SetNumberOfComponents(3);
  size->InsertNextTypedTuple(dimensions);
  horizon->GetFieldData()->AddArray(size);
  vtkNew<vtkDoubleArray> map;
  map->SetName("LatticeToWorld");
  map->SetNumberOfComponents(16);
  map->InsertNextTuple(toWorld->GetData());
  horizon->GetFieldData()->AddArray(map);
}

inline double FoldedHeight(int i, int j)
{
  return 20 + ((i * i + 3 * j) % 17) / 6; // whole, as vertical indices are
}

/// A horizon with the columns marked # in a picture (its last row is j = 0) and the arrays of the reader. Attributes
/// are simple sums of the column's indices, so that averages can be told by hand.
inline vtkSmartPointer<vtkPolyData> FromPicture(
  const std::vector<std::string>& rows, int surfaceId, vtkMatrix4x4* toWorld, double (*height)(int, int) = FoldedHeight)
{
  auto horizon = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> ids;
  ids->SetName("SurfaceId");
  vtkNew<vtkIntArray> index;
  index->SetName("VerticalIndex");
  vtkNew<vtkDoubleArray> amplitude;
  amplitude->SetName("Amplitude");
  for (std::size_t j = 0; j < rows.size(); ++j)
  {
    const std::string& row = rows[rows.size() - 1 - j];
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      if (row[i] != '#')
      {
        continue;
      }
      const double k = height(int(i), int(j));
      const double place[4] = { double(i), double(j), k, 1.0 };
      double world[4];
      toWorld->MultiplyPoint(place, world);
      points->InsertNextPoint(world);
      ids->InsertNextValue(surfaceId);
      index->InsertNextValue(int(k));
      amplitude->InsertNextValue(double(i) + 100.0 * double(j));
    }
  }
  horizon->SetPoints(points);
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(ids), static_cast<vtkDataArray*>(index), static_cast<vtkDataArray*>(amplitude) })
  {
    horizon->GetPointData()->AddArray(array);
  }
  const int dimensions[3] = { int(rows.front().size()), int(rows.size()), 64 };
  AddLattice(horizon, dimensions, toWorld);
  return horizon;
}

/// Collects the errors of an algorithm while it lives. The executive's own, which only repeats that one was there, is
/// kept off the screen.
class Errors
{
public:
  explicit Errors(vtkAlgorithm* algorithm, unsigned long event = vtkCommand::ErrorEvent)
  {
    this->Collect->SetCallback(OnError);
    this->Collect->SetClientData(&this->Messages);
    this->Ignore->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    algorithm->AddObserver(event, this->Collect);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Ignore);
  }
  ~Errors() { this->Collect->SetClientData(nullptr); }
  std::size_t Count() const { return this->Messages.size(); }
  bool FirstContains(const std::string& text) const
  {
    return !this->Messages.empty() && this->Messages.front().find(text) != std::string::npos;
  }
  std::string First() const { return this->Messages.empty() ? std::string() : this->Messages.front(); }

private:
  static void OnError(vtkObject*, unsigned long, void* messages, void* text)
  {
    if (messages)
    {
      static_cast<std::vector<std::string>*>(messages)->push_back(static_cast<const char*>(text));
    }
  }

  std::vector<std::string> Messages;
  vtkNew<vtkCallbackCommand> Collect;
  vtkNew<vtkCallbackCommand> Ignore;
};

inline std::vector<std::string> Rectangle(int width, int height)
{
  return std::vector<std::string>(std::size_t(height), std::string(std::size_t(width), '#'));
}
}

#endif
