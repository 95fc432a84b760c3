// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GuidePicks.h"

#include "Common/Errors.h"
#include "Common/Lattice.h"
#include "HorizonPoints.h"
#include "HorizonTree.h"

#include "vtkAbstractArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <cmath>
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
    : Cube(cube)
    , Grid(
        Dimensions(cube), Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(cube.Frame.ToWorld().data()))
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
          this->CornerText(0) + " to " + this->CornerText(1));
      }
    }
    return std::move(this->Guides);
  }

private:
  static std::array<int, 3> Dimensions(const ImageCube& cube)
  {
    std::array<int, 3> dimensions = cube.Traces.Size;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      dimensions[axis] += cube.FirstIndex[axis];
    }
    return dimensions;
  }

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
    const Eigen::Vector3d place = this->Grid.ToLattice(world) -
      Eigen::Vector3d(this->Cube.FirstIndex[0], this->Cube.FirstIndex[1], this->Cube.FirstIndex[2]);
    const std::array<int, 3>& size = this->Cube.Traces.Size;
    const bool isInside = place.x() >= -0.5 && place.x() < size[0] - 0.5 && place.y() >= -0.5 &&
      place.y() < size[1] - 0.5 && place.z() >= 0.0 && place.z() <= size[2] - 1.0;
    if (!isInside)
    {
      if (guide.Outside++ == 0)
      {
        guide.FirstOutside = ToText(world);
      }
      return;
    }
    guide.Given.Picks.push_back(
      { static_cast<int>(std::floor(place.x() + 0.5)), static_cast<int>(std::floor(place.y() + 0.5)), place.z() });
    guide.Places.push_back({ point[0], point[1], point[2] });
  }

  /// The first or the last corner of the cube in the world.
  std::string CornerText(int which) const
  {
    Eigen::Vector3d corner;
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[axis] = this->Cube.FirstIndex[static_cast<std::size_t>(axis)] +
        which * (this->Cube.Traces.Size[static_cast<std::size_t>(axis)] - 1);
    }
    return ToText(this->Grid.ToWorld(corner));
  }

  const ImageCube& Cube;
  const Lattice Grid;
  std::vector<GuidePicks> Guides;
  std::map<std::string, std::size_t> Numbers; // of guides, by the names that were given
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
