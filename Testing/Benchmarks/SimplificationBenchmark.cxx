// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Speed of the simplifications of the inside, beside VTK's filters for the same task in the same run.
//
// Arguments: the numbers of points (default: 886639 and 5000000). Each size is a square with a folded height, where
// every tenth column of every tenth row is missing. The best of five runs counts. Ours is timed twice: the method
// alone, on plain data, and the whole filter with its attributes. VTK's filters take the full triangulation of the same
// points, which they need, and bins of the same size; they leave the outline unprotected.

#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Common/HorizonData.h"

#include "vtkBinnedDecimation.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonTriangulation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkQuadricClustering.h"
#include "vtkSMPTools.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace SeismicHorizons;

constexpr int Runs = 5;
constexpr vtkIdType MostPointsForPeers = 10000000;

/// A line of /proc/self/status in bytes, or 0 where there is none.
double MemoryStatus(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (status >> word)
  {
    if (word == name + ":" && status >> kilobytes)
    {
      return 1024.0 * kilobytes;
    }
  }
  return 0.0;
}

/// Starts to measure the peak anew, and returns what is in use now.
double StartPeak()
{
  malloc_trim(0); // what is free but not given back would hide what is taken
  std::ofstream("/proc/self/clear_refs") << 5;
  return MemoryStatus("VmRSS");
}

vtkSmartPointer<vtkPolyData> MakeHorizon(int side)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      if (i % 10 != 5 || j % 10 != 5)
      {
        points->InsertNextPoint(i, j, std::round(30.0 + 20.0 * std::sin(0.02 * i) * std::cos(0.013 * j)));
      }
    }
  }
  auto horizon = vtkSmartPointer<vtkPolyData>::New();
  horizon->SetPoints(points);
  vtkNew<vtkIntArray> dimensions;
  dimensions->SetName("LatticeDimensions");
  dimensions->SetNumberOfComponents(3);
  dimensions->InsertNextTuple3(side, side, 64);
  horizon->GetFieldData()->AddArray(dimensions);
  vtkNew<vtkDoubleArray> map;
  map->SetName("LatticeToWorld");
  map->SetNumberOfComponents(16);
  const double identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  map->InsertNextTuple(identity);
  horizon->GetFieldData()->AddArray(map);
  return horizon;
}

void Report(const std::string& name, vtkIdType points, const std::function<std::size_t()>& run)
{
  double best = 1e300;
  double memory = 0.0;
  std::size_t left = 0;
  for (int n = 0; n < Runs; ++n)
  {
    const double before = StartPeak();
    const auto start = std::chrono::steady_clock::now();
    left = run();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    memory = std::max(memory, MemoryStatus("VmHWM") - before);
  }
  std::cout << "  " << std::left << std::setw(44) << name << std::right << std::fixed << std::setprecision(3)
            << std::setw(9) << best << " s " << std::setprecision(1) << std::setw(8) << double(points) / best * 1e-6
            << " million points/s " << std::setw(10) << left << " points left " << std::setw(6)
            << memory / double(points) << " bytes/point" << std::endl;
}

template <typename Filter>
std::size_t RunFilter(Filter* filter, vtkDataObject* input)
{
  filter->SetInputDataObject(input);
  filter->Modified();
  filter->Update();
  return std::size_t(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints());
}

void BenchmarkMethods(vtkPolyData* bounded)
{
  const vtkIdType size = bounded->GetNumberOfPoints();
  const BoundedHorizon horizon = ReadBoundedHorizon(ReadPoints(bounded, {}));
  for (const int cell : { 3, 6, 8 })
  {
    Report("rough " + std::to_string(cell) + ", method alone", size,
      [&]() { return SimplifyRough(horizon, cell).Source.size(); });
  }
  for (const double flatness : { 0.0, 0.03, 0.12 })
  {
    Report("elaborate 8, flatness " + std::to_string(flatness).substr(0, 4) + ", method alone", size,
      [&]() { return SimplifyElaborate(horizon, ElaborateOptions(8, flatness)).Source.size(); });
  }
}

void BenchmarkFilters(vtkPolyData* bounded)
{
  const vtkIdType size = bounded->GetNumberOfPoints();
  vtkNew<vtkHorizonRoughSimplification> rough;
  Report("vtkHorizonRoughSimplification 3", size, [&]() { return RunFilter(rough.Get(), bounded); });
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  Report("vtkHorizonElaborateSimplification 8", size, [&]() { return RunFilter(elaborate.Get(), bounded); });
}

void BenchmarkPeers(vtkPolyData* bounded, int side)
{
  const vtkIdType size = bounded->GetNumberOfPoints();
  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetInputDataObject(bounded);
  mesh->Update();
  vtkNew<vtkPolyData> triangles;
  triangles->SetPoints(mesh->GetPolyDataOutput()->GetPoints());
  triangles->SetPolys(mesh->GetPolyDataOutput()->GetPolys());
  const int bins = side / 3 + 1;
  vtkNew<vtkBinnedDecimation> binned;
  binned->SetNumberOfDivisions(bins, bins, 1);
  binned->AutoAdjustNumberOfDivisionsOff();
  binned->SetPointGenerationModeToBinAverages();
  Report("vtkBinnedDecimation, bins of 3", size, [&]() { return RunFilter(binned.Get(), triangles.Get()); });
  vtkNew<vtkQuadricClustering> quadric;
  quadric->SetNumberOfDivisions(bins, bins, 1);
  quadric->AutoAdjustNumberOfDivisionsOff();
  Report("vtkQuadricClustering, bins of 3", size, [&]() { return RunFilter(quadric.Get(), triangles.Get()); });
}
}

int main(int argc, char* argv[])
{
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(0);
  std::vector<double> sizes = { 886639, 5000000 };
  if (argc > 1)
  {
    sizes.clear();
    for (int n = 1; n < argc; ++n)
    {
      sizes.push_back(std::strtod(argv[n], nullptr));
    }
  }
  for (const double size : sizes)
  {
    const int side = int(std::ceil(std::sqrt(size / 0.99)));
    vtkNew<vtkHorizonExteriorBoundary> boundary;
    boundary->SetInputDataObject(MakeHorizon(side));
    boundary->Update();
    std::cout << boundary->GetPolyDataOutput()->GetNumberOfPoints() << " points, "
              << vtkSMPTools::GetEstimatedNumberOfThreads() << " threads" << std::endl;
    BenchmarkMethods(boundary->GetPolyDataOutput());
    BenchmarkFilters(boundary->GetPolyDataOutput());
    if (boundary->GetPolyDataOutput()->GetNumberOfPoints() <= MostPointsForPeers)
    {
      BenchmarkPeers(boundary->GetPolyDataOutput(), side);
    }
  }
  return EXIT_SUCCESS;
}
