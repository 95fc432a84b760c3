// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GuidePicks.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Lattice.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"

#include "vtkAbstractArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <map>
#include <string>

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
}
