// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ExtractionLimits.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Lattice.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"

#include "vtkAbstractArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
class GuideReader
{
public:
  explicit GuideReader(const ImageCube& cube)
    : Places(cube)
  {
  }

  void Add(const std::string& name, vtkPolyData* points)
  {
    vtkAbstractArray* const names = points->GetPointData()->GetAbstractArray("Horizon");
    if (names && names->GetNumberOfComponents() != 1)
    {
      throw InputError("guide array Horizon of " + std::to_string(names->GetNumberOfComponents()) +
        " components, expected the number or the name of the horizon of each point");
    }
    for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
    {
      this->AddPoint(names ? names->GetVariantValue(n).ToString() : name, points->GetPoint(n));
    }
  }

  std::vector<GuidePicks> Take()
  {
    if (this->Guides.empty())
    {
      throw InputError("guides without points, expected picks");
    }
    for (const GuidePicks& guide : this->Guides)
    {
      if (guide.Given.Picks.empty())
      {
        throw InputError("guide \"" + guide.Given.Name + "\": none of its " + std::to_string(guide.Outside) +
          " points is on the cube, the first is at " + guide.FirstOutside + ", expected points from " +
          this->Places.CornersText());
      }
    }
    return std::move(this->Guides);
  }

private:
  GuidePicks& Find(const std::string& name)
  {
    const auto found = this->Numbers.insert({ name, this->Guides.size() });
    if (found.second)
    {
      this->Guides.emplace_back();
      this->Guides.back().Given.Name = name.empty() ? "Guide " + std::to_string(this->Guides.size()) : name;
    }
    return this->Guides[found.first->second];
  }

  void AddPoint(const std::string& name, const double* point)
  {
    const Eigen::Vector3d world(point[0], point[1], point[2]);
    GuidePicks& guide = this->Find(name);
    if (!world.allFinite())
    {
      throw InputError("guide \"" + guide.Given.Name + "\": a point at " + ToText(world) + ", expected finite numbers");
    }
    const Eigen::Vector3d place = this->Places.ToCube(world);
    if (!this->Places.HasSample(place))
    {
      if (guide.Outside++ == 0)
      {
        guide.FirstOutside = ToText(world);
      }
      return;
    }
    const auto [i, j] = this->Places.TraceAt(place);
    guide.Given.Picks.push_back({ i, j, place.z() });
    guide.Places.push_back({ point[0], point[1], point[2] });
  }

  const CubePlaces Places;
  std::vector<GuidePicks> Guides;
  std::map<std::string, std::size_t> Numbers; // Guides are found by their given names.
};

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// nan without a point on the trace
std::vector<double> ReadSamples(const HorizonLeaf& leaf, const ImageCube& cube, const CubePlaces& places)
{
  const std::array<int, 3>& size = cube.Traces.Size;
  std::vector<double> samples(std::size_t(size[0]) * std::size_t(size[1]), std::nan(""));
  CheckArraySizes(leaf.Input);
  const vtkSmartPointer<vtkPolyData> shown = WithoutHiddenPoints(leaf.Input);
  bool isOnTraces = false;
  bool isOnSamples = false;
  for (vtkIdType n = 0; n < shown->GetNumberOfPoints(); ++n)
  {
    const Eigen::Vector3d world(shown->GetPoint(n));
    if (!world.allFinite())
    {
      throw InputError("limit \"" + leaf.Name + "\": a point at " + ToText(world) + ", expected finite numbers");
    }
    const Eigen::Vector3d place = places.ToCube(world);
    if (places.HasTrace(place))
    {
      const auto [i, j] = places.TraceAt(place);
      double& sample = samples[std::size_t(i) + std::size_t(size[0]) * std::size_t(j)];
      if (!std::isnan(sample))
      {
        throw InputError("limit \"" + leaf.Name + "\": two points on one trace, the second at " + ToText(world) +
          ", expected one: a horizon on the traces of the cube");
      }
      sample = place.z();
      isOnTraces = true;
      isOnSamples = isOnSamples || places.HasSample(place);
    }
  }
  if (isOnTraces && !isOnSamples) // This happens if z has the other sign.
  {
    throw InputError("limit \"" + leaf.Name +
      "\": all of its points are above or below the samples of the cube, expected points from " + places.CornersText());
  }
  return samples;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<GuidePicks> ReadGuides(vtkDataObject* points, const ImageCube& cube)
{
  GuideReader reader(cube);
  for (const HorizonLeaf& leaf : ListHorizons(points, {}))
  {
    CheckArraySizes(leaf.Input);
    reader.Add(leaf.Name, WithoutHiddenPoints(leaf.Input));
  }
  return reader.Take();
}

//----------------------------------------------------------------------------------------------------------------------
ExtractionLimits ReadLimits(const std::vector<vtkDataObject*>& horizons, const ImageCube& cube, LimitSide side)
{
  std::vector<HorizonLeaf> leaves;
  for (vtkDataObject* const some : horizons)
  {
    const std::vector<HorizonLeaf> more = ListHorizons(some, {});
    leaves.insert(leaves.end(), more.begin(), more.end());
  }
  if (leaves.empty() || leaves.size() > 2)
  {
    throw InputError("limits of " + std::to_string(leaves.size()) + " horizons, expected one or two");
  }
  const CubePlaces places(cube);
  ExtractionLimits limits;
  limits.Traces.First = ReadSamples(leaves.front(), cube, places);
  if (leaves.size() == 2)
  {
    limits.Traces.Last = ReadSamples(leaves.back(), cube, places);
  }
  else
  {
    limits.Traces.Last = limits.Traces.First;
    std::vector<double>& open = side == LimitSide::Below ? limits.Traces.Last : limits.Traces.First;
    std::transform(open.begin(), open.end(), open.begin(),
      [&](double sample) { return std::isnan(sample)    ? sample
                             : side == LimitSide::Below ? Infinity
                                                        : -Infinity; });
  }
  for (std::size_t trace = 0; trace < limits.Traces.First.size(); ++trace)
  {
    double& first = limits.Traces.First[trace];
    double& last = limits.Traces.Last[trace];
    if (last < first)
    {
      std::swap(first, last);
    }
    limits.Limited += first <= last ? 1 : 0; // nan fails the comparison.
  }
  if (limits.Limited == 0)
  {
    throw InputError("limits on no trace of the cube, expected horizons with points from " + places.CornersText());
  }
  return limits;
}
}
