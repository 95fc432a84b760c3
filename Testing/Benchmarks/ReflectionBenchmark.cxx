// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Speed and memory of the extraction of horizons from a cube, step by step on one thread unless told, and beside what else makes
// surfaces of a cube: zero crossings (vtkFlyingEdges3D) and their connected parts. Prints Markdown: processor seconds,
// the least of several runs, and the growth of memory.
//
//   ReflectionBenchmark [COLUMNS ROWS SAMPLES]     size of the generated cube; without it 400 x 300 x 500

#include "BenchmarkTools.h"
#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/Reflections/ReflectionExtraction.h"
#include "Filters/Algorithms/Reflections/SurfaceJoining.h"
#include "Generator/CubeGenerator.h"

#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataConnectivityFilter.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace SeismicHorizons;
using namespace BenchmarkTools;

namespace
{
/// A hard cube with noise, as an image: i runs fastest.
struct Cube
{
  explicit Cube(const std::array<int, 3>& size)
  {
    this->Options = HardCube(5);
    this->Options.Size = size;
    this->Options.NoiseFraction = 0.2;
    const std::vector<float> traces = CubeGenerator(this->Options).MakeTraces();
    this->Image->SetDimensions(size.data());
    this->Image->AllocateScalars(VTK_FLOAT, 1);
    auto* const samples = static_cast<float*>(this->Image->GetScalarPointer());
    const std::size_t columns = std::size_t(size[0]) * std::size_t(size[1]);
    for (std::size_t n = 0; n < traces.size(); ++n)
    {
      const float sample = traces[n];
      samples[n / std::size_t(size[2]) + n % std::size_t(size[2]) * columns] = sample == sample ? sample : 0.0F;
    }
    StridedSamples<float> view;
    view.First = samples;
    view.Strides = { 1, size[0], std::ptrdiff_t(columns) };
    this->Traces = MakeTraceCube(size, view);
  }

  double Samples() const { return double(this->Image->GetNumberOfPoints()); }

  CubeGeneratorOptions Options;
  vtkNew<vtkImageData> Image;
  TraceCube Traces;
};

void PrintRow(const std::string& name, double seconds, double count, const char* unit)
{
  std::printf("| %s | %.3f | %.0f million %s/s |\n", name.c_str(), seconds, count / seconds / 1e6, unit);
}

void MeasureSteps(const Cube& cube)
{
  std::printf("| step, one thread | seconds | speed |\n| --- | --- | --- |\n");
  CubeReflections found;
  PrintRow(
    "reflections and thinning", Time([&]() { found = FindReflections(cube.Traces); }), cube.Samples(), "samples");
  const double picks = double(found.CountPicks());
  LinkOptions options;
  options.LargestStep = PickDepth(0.3 * found.Period * DepthsPerSample);
  options.HalfWidth = int(std::lround(3.5 * found.Period));
  const auto forEachSign = [&](auto&& work)
  {
    for (const ReflectionPicks& sign : found.BySign)
    {
      work(sign);
    }
  };
  PrintRow("components",
    Time(
      [&]()
      {
        forEachSign([&](const ReflectionPicks& sign)
          { FindConnectedPicks(sign, ColumnConnectivity::Four, options.LargestStep); });
      }),
    picks, "picks");
  std::vector<ReflectionLinks> links;
  PrintRow("links",
    Time(
      [&]()
      {
        links.clear();
        forEachSign([&](const ReflectionPicks& sign) { links.emplace_back(cube.Traces, sign, options); });
      }),
    picks, "picks");
  for (ReflectionLinks& sign : links)
  {
    sign.Drop(0.85 * sign.MedianCorrelation());
  }
  PrintRow("joining, best first",
    Time(
      [&]()
      {
        for (std::size_t sign = 0; sign < 2; ++sign)
        {
          BestFirstJoining(found.BySign[sign]).Run(links[sign], JoiningRules(), Monitor());
        }
      }),
    picks, "picks");
  std::printf("\n%.0f million samples, %.1f million picks\n\n", cube.Samples() / 1e6, picks / 1e6);
}

/// Parts of a surface: how many, the share of the largest, points above others of their part, and points on the smaller
/// side of the fault.
class Parts
{
public:
  explicit Parts(const Cube& cube)
    : Truth(cube.Options)
    , Width(cube.Options.Size[0])
  {
  }

  void Add(std::int64_t part, double i, double j, double sample)
  {
    ++this->Sizes[part];
    const auto column = std::int64_t(std::floor(i)) + std::int64_t(std::floor(j)) * this->Width;
    this->Repeated += this->Columns[part].insert(column).second ? 0 : 1;
    const double distance = this->Truth.FaultDistance(i, j, sample);
    constexpr double unclear = 1.5;
    if (std::abs(distance) >= unclear)
    {
      ++this->Sides[part][distance > 0.0 ? 1 : 0];
    }
  }

  void Print(const std::string& name, double seconds, double bytes, double cubeBytes) const
  {
    constexpr std::int64_t large = 200;
    std::int64_t points = 0;
    std::int64_t largest = 0;
    std::int64_t leaked = 0;
    std::int64_t judged = 0;
    int parts = 0;
    for (const auto& [part, size] : this->Sizes)
    {
      points += size;
      largest = std::max(largest, size);
      parts += size >= large ? 1 : 0;
      const auto sides = this->Sides.find(part);
      if (size >= large && sides != this->Sides.end())
      {
        leaked += std::min(sides->second[0], sides->second[1]);
        judged += sides->second[0] + sides->second[1];
      }
    }
    std::printf("| %s | %.2f | %.1f | %d | %.0f %% | %.1f %% | %.1f %% |\n", name.c_str(), seconds, bytes / cubeBytes,
      parts, 100.0 * double(largest) / double(points), 100.0 * double(this->Repeated) / double(points),
      100.0 * double(leaked) / double(judged));
  }

private:
  CubeReflectors Truth;
  std::int64_t Width;
  std::map<std::int64_t, std::int64_t> Sizes;
  std::map<std::int64_t, std::set<std::int64_t>> Columns;
  std::map<std::int64_t, std::array<std::int64_t, 2>> Sides;
  std::int64_t Repeated = 0;
};

void MeasureExtraction(const Cube& cube, const char* name, const ExtractionOptions& options)
{
  Extraction result;
  const double bytes = PeakBytes([&]() { result = ExtractReflections(cube.Traces, options); });
  const double seconds = Time([&]() { result = ExtractReflections(cube.Traces, options); });
  Parts parts(cube);
  for (const LatticeHorizon& surface : result.Surfaces)
  {
    for (std::size_t n = 0; n < surface.Column.size(); ++n)
    {
      parts.Add(surface.SurfaceId, surface.Column[n].X, surface.Column[n].Y, surface.RealZ[n]);
    }
  }
  parts.Print(name, seconds, bytes, 4.0 * cube.Samples());
}

void MeasurePeer(const Cube& cube)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(cube.Image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  vtkNew<vtkPolyDataConnectivityFilter> connectivity;
  connectivity->SetInputConnection(contour->GetOutputPort());
  connectivity->SetExtractionModeToAllRegions();
  connectivity->ColorRegionsOn();
  const double bytes = PeakBytes([&]() { connectivity->Update(); });
  const double seconds = Time(
    [&]()
    {
      contour->Modified();
      connectivity->Update();
    });
  vtkPolyData* const surface = connectivity->GetOutput();
  vtkDataArray* const regions = surface->GetPointData()->GetArray("RegionId");
  Parts parts(cube);
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    const double* const place = surface->GetPoint(point);
    // Points between columns are not over each other.
    if (place[0] == std::floor(place[0]) && place[1] == std::floor(place[1]))
    {
      parts.Add(std::int64_t(regions->GetTuple1(point)), place[0], place[1], place[2]);
    }
  }
  parts.Print("zero crossings and connectivity", seconds, bytes, 4.0 * cube.Samples());
}

void Compare(const Cube& cube)
{
  std::printf(
    "| surfaces | seconds | memory, in cubes | parts of 200 points or more | largest part | over others "
    "of their part | over the fault |\n| --- | --- | --- | --- | --- | --- | --- |\n");
  ExtractionOptions options;
  options.SmallestSize = 200;
  options.LargestNumber = 1000000;
  MeasureExtraction(cube, "best first", options);
  Detail::NumberOfThreads() = 2;
  MeasureExtraction(cube, "best first, two threads", options);
  Detail::NumberOfThreads() = 1;
  options.Joining = SurfaceJoining::Components;
  options.Connectivity = ColumnConnectivity::Eight;
  options.LargestStep = 1.0;
  options.Reflections.Position = ReflectionPosition::Middle;
  options.Reflections.AmplitudePercentile = 70.0;
  MeasureExtraction(cube, "components, as in the thesis", options);
  MeasurePeer(cube);
}
}

int main(int argc, char* argv[])
{
  std::array<int, 3> size = { 400, 300, 500 };
  for (int n = 0; n < 3 && argc > 3; ++n)
  {
    size[std::size_t(n)] = std::atoi(argv[n + 1]);
  }
  Detail::NumberOfThreads() = 1;
  const Cube cube(size);
  MeasureSteps(cube);
  Compare(cube);
  return EXIT_SUCCESS;
}
