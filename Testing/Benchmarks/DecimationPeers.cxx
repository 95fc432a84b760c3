// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DecimationPeers.h"

#include "BenchmarkTools.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkGreedyTerrainDecimation.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <cmath>
#include <vector>

using namespace SeismicHorizons;
using DecimationErrors::Surface;

namespace DecimationPeers
{
namespace
{
/// The heights of the whole box.
vtkSmartPointer<vtkImageData> FillBox(const Surface& surface)
{
  const PlaneBox box(surface.Columns);
  const int width = box.Greatest.X - box.Least.X + 1;
  const int height = box.Greatest.Y - box.Least.Y + 1;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->SetOrigin(box.Least.X, box.Least.Y, 0.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetNumberOfTuples(vtkIdType(width) * height);
  heights->FillValue(NAN);
  for (std::size_t point = 0; point < surface.Columns.size(); ++point)
  {
    const PlanePoint& column = surface.Columns[point];
    const vtkIdType place = vtkIdType(column.Y - box.Least.Y) * width + (column.X - box.Least.X);
    heights->SetValue(place, float(surface.Horizon.Height[point]));
  }
  float last = float(surface.Horizon.Height.front());
  for (vtkIdType place = 0; place < heights->GetNumberOfTuples(); ++place)
  {
    last = std::isnan(heights->GetValue(place)) ? last : heights->GetValue(place);
    heights->SetValue(place, last);
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}
}

//----------------------------------------------------------------------------------------------------------------------
Result RunGreedyTerrain(const Surface& surface, std::size_t triangles)
{
  const vtkSmartPointer<vtkImageData> image = FillBox(surface);
  vtkNew<vtkGreedyTerrainDecimation> greedy;
  greedy->SetInputData(image);
  greedy->SetErrorMeasureToNumberOfTriangles();
  greedy->SetNumberOfTriangles(vtkIdType(triangles));
  greedy->BoundaryVertexDeletionOn();
  Result result;
  result.Seconds = BenchmarkTools::Time(
    [&]()
    {
      greedy->Modified();
      greedy->Update();
    });
  vtkPolyData* const output = greedy->GetOutput();
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    const double* const place = output->GetPoint(point);
    result.Mesh.Vertices.push_back({ std::round(place[0]), std::round(place[1]), place[2] });
  }
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (output->GetPolys()->InitTraversal(); output->GetPolys()->GetNextCell(size, corners) != 0;)
  {
    result.Mesh.Triangles.push_back({ std::size_t(corners[0]), std::size_t(corners[1]), std::size_t(corners[2]) });
  }
  return result;
}

#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
//----------------------------------------------------------------------------------------------------------------------
Result RunMeshoptimizer(const Surface& surface, std::size_t triangles)
{
  const RawVector<PointId> all = Triangulate(surface.Horizon).Triangles;
  const std::vector<unsigned int> indices(all.begin(), all.end());
  std::vector<float> places;
  for (std::size_t point = 0; point < surface.Columns.size(); ++point)
  {
    places.insert(places.end(),
      { float(surface.Columns[point].X), float(surface.Columns[point].Y), float(surface.Horizon.Height[point]) });
  }
  std::vector<unsigned int> left(indices.size());
  Result result;
  result.Seconds = BenchmarkTools::Time(
    [&]()
    {
      left.resize(indices.size());
      left.resize(meshopt_simplify(left.data(), indices.data(), indices.size(), places.data(), surface.Columns.size(),
        3 * sizeof(float), 3 * triangles, 1.0F, meshopt_SimplifyLockBorder));
    });
  std::vector<std::size_t> number(surface.Columns.size(), surface.Columns.size());
  for (std::size_t first = 0; first < left.size(); first += 3)
  {
    std::array<std::size_t, 3> triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::size_t point = left[first + corner];
      if (number[point] == surface.Columns.size())
      {
        number[point] = result.Mesh.Vertices.size();
        result.Mesh.Vertices.push_back(
          { double(surface.Columns[point].X), double(surface.Columns[point].Y), surface.Horizon.Height[point] });
      }
      triangle[corner] = number[point];
    }
    result.Mesh.Triangles.push_back(triangle);
  }
  return result;
}
#endif
}
