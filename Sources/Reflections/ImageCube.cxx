// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImageCube.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
using Indices = std::array<int, 3>;

constexpr double Infinity = std::numeric_limits<double>::infinity();

std::string CubeText(const Indices& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

std::string CubeText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

void CheckImage(vtkImageData* image, vtkDataArray* amplitudes)
{
  const Indices size = { image->GetDimensions()[0], image->GetDimensions()[1], image->GetDimensions()[2] };
  if (size[0] < 1 || size[1] < 1 || size[2] < 2)
  {
    throw InputError("an image of " + CubeText(size) + " points, expected traces of two samples or more along k");
  }
  if (amplitudes->GetNumberOfComponents() != 1)
  {
    throw InputError("array " + std::string(amplitudes->GetName() ? amplitudes->GetName() : "") + " of " +
      std::to_string(amplitudes->GetNumberOfComponents()) + " components, expected amplitudes, one for each point");
  }
  RequireTuples(amplitudes, image->GetNumberOfPoints(), "points");
  if (image->GetPointGhostArray())
  {
    RequireTuples(image->GetPointGhostArray(), image->GetNumberOfPoints(), "points");
  }
}

// ---- Samples --------------------------------------------------------------------------------------------------------
template <typename Sample>
TraceCube MakeTraces(const Sample* first, const Indices& size, vtkUnsignedCharArray* ghosts)
{
  StridedSamples<Sample> samples;
  samples.First = first;
  samples.Strides = { 1, size[0], std::ptrdiff_t(size[0]) * size[1] };
  if (ghosts)
  {
    samples.Marks = ghosts->GetPointer(0);
    samples.MissingMask = vtkDataSetAttributes::HIDDENPOINT;
  }
  return MakeTraceCube(size, samples);
}

TraceCube MakeTraces(vtkImageData* image, vtkDataArray* amplitudes)
{
  const Indices size = { image->GetDimensions()[0], image->GetDimensions()[1], image->GetDimensions()[2] };
  vtkUnsignedCharArray* const ghosts = image->GetPointGhostArray();
  switch (amplitudes->GetDataType())
  {
    vtkTemplateMacro(return MakeTraces(static_cast<VTK_TT*>(amplitudes->GetVoidPointer(0)), size, ghosts));
    default:
      throw InputError("array " + std::string(amplitudes->GetName() ? amplitudes->GetName() : "") + " of " +
        amplitudes->GetDataTypeAsString() + "s, expected numbers");
  }
}

// ---- Lattices -------------------------------------------------------------------------------------------------------
Eigen::Affine3d IndexToWorld(vtkImageData* image)
{
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(image->GetDirectionMatrix()->GetData());
  map.linear() = axes * Eigen::Vector3d(image->GetSpacing()).asDiagonal();
  map.translation() = Eigen::Vector3d(image->GetOrigin());
  return map;
}

/// VerticalDirection in the field data counts before the map.
LatticeFrame MakeFrame(vtkImageData* image, const Indices& size, const Eigen::Matrix4d& map)
{
  const bool isDown = FirstValue(image->GetFieldData(), FieldArray::VerticalDirection, map(2, 2)) < 0.0;
  return MakeLatticeFrame(size, map, isDown ? VerticalDirection::Down : VerticalDirection::Up);
}

/// The lattice begins at the first point of the image.
void PlaceByImage(vtkImageData* image, ImageCube& cube)
{
  const Eigen::Affine3d map = IndexToWorld(image);
  const auto& axes = map.linear();
  if (axes(2, 0) != 0.0 || axes(2, 1) != 0.0 || axes(0, 2) != 0.0 || axes(1, 2) != 0.0)
  {
    throw InputError("an image whose k axis is not vertical, or whose i and j axes are not level, expected traces "
                     "along z: turn it by Transform or Permute");
  }
  const int* const extent = image->GetExtent();
  const Eigen::Vector3d first(extent[0], extent[2], extent[4]);
  const Eigen::Affine3d fromFirst = map * Eigen::Translation3d(first);
  Lattice(cube.Traces.Size, fromFirst.matrix()); // This throws on invalid lattices.
  cube.Frame = MakeFrame(image, cube.Traces.Size, fromFirst.matrix());
}

/// Resample, Extract Subset and Transform do not change the lattice in the field data. An image with the default map
/// has nothing to compare.
void CheckPlaces(vtkImageData* image, const Lattice& lattice)
{
  const Eigen::Affine3d map = IndexToWorld(image);
  if (map.isApprox(Eigen::Affine3d::Identity(), 0.0))
  {
    return;
  }
  const double deviation = FirstValue(image->GetFieldData(), "ImageDeviation", 0.0);
  const double most = 0.25 + (deviation > 0.0 ? deviation : 0.0);
  const int* const extent = image->GetExtent();
  for (int corner = 0; corner < 8; ++corner)
  {
    const Eigen::Vector3d index(extent[corner & 1], extent[2 + (corner >> 1 & 1)], extent[4 + (corner >> 2)]);
    const double distance = (lattice.ToLattice(map * index) - index).lpNorm<Eigen::Infinity>();
    if (!(distance <= most))
    {
      throw InputError("a point of the image is " + CubeText(distance) +
        " columns or samples from where LatticeToWorld places it, expected 0: the image was moved or resampled; "
        "without its field data arrays LatticeDimensions and LatticeToWorld, its own lattice is used");
    }
  }
}

void PlaceByFields(vtkImageData* image, ImageCube& cube)
{
  const Indices dimensions = ReadLatticeDimensions(image);
  const Eigen::Matrix4d map = ReadLatticeMap(image);
  const Lattice lattice(dimensions, map);
  const int* const extent = image->GetExtent();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (extent[2 * axis] < 0 || extent[2 * axis + 1] >= dimensions[axis])
    {
      throw InputError("an image of the extent " + std::to_string(extent[2 * axis]) + " to " +
        std::to_string(extent[2 * axis + 1]) + " along axis " + std::to_string(axis) + ", expected 0 to " +
        std::to_string(dimensions[axis] - 1) + " as LatticeDimensions has " + CubeText(dimensions));
    }
    cube.FirstIndex[axis] = extent[2 * axis];
  }
  CheckPlaces(image, lattice);
  cube.Frame = MakeFrame(image, dimensions, map);
}

// ---- Guides and limits ----------------------------------------------------------------------------------------------

/// Places are in columns and samples from the first trace and sample of the cube.
class CubePlaces
{
public:
  explicit CubePlaces(const ImageCube& cube)
    : First(cube.FirstIndex[0], cube.FirstIndex[1], cube.FirstIndex[2])
    , Last(cube.Traces.Size[0] - 1, cube.Traces.Size[1] - 1, cube.Traces.Size[2] - 1)
  {
    Indices dimensions = cube.Traces.Size;
    std::transform(dimensions.begin(), dimensions.end(), cube.FirstIndex.begin(), dimensions.begin(), std::plus<>());
    this->Lattice = SeismicHorizons::Lattice(
      dimensions, Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(cube.Frame.ToWorld().data()));
  }

  Eigen::Vector3d ToCube(const Eigen::Vector3d& world) const { return this->Lattice.ToLattice(world) - this->First; }

  bool HasTrace(const Eigen::Vector3d& place) const
  {
    return place.x() >= -0.5 && place.x() < this->Last.x() + 0.5 && place.y() >= -0.5 &&
      place.y() < this->Last.y() + 0.5;
  }

  bool HasSample(const Eigen::Vector3d& place) const
  {
    return this->HasTrace(place) && place.z() >= 0.0 && place.z() <= this->Last.z();
  }

  std::array<int, 2> TraceAt(const Eigen::Vector3d& place) const
  {
    assert(this->HasTrace(place));
    return { static_cast<int>(std::floor(place.x() + 0.5)), static_cast<int>(std::floor(place.y() + 0.5)) };
  }

  /// "(...) to (...)": world coordinates of the first and last corner
  std::string CornersText() const
  {
    return ToText(this->Lattice.ToWorld(this->First)) + " to " +
      ToText(this->Lattice.ToWorld(this->First + this->Last));
  }

private:
  SeismicHorizons::Lattice Lattice;
  Eigen::Vector3d First; // lattice index
  Eigen::Vector3d Last; // last trace and sample, in cube units
};

void AddPoint(const double* point, const CubePlaces& places, GuidePicks& guide)
{
  const Eigen::Vector3d world(point);
  if (!world.allFinite())
  {
    throw InputError("guide \"" + guide.Given.Name + "\": a point at " + ToText(world) + ", expected finite numbers");
  }
  const Eigen::Vector3d place = places.ToCube(world);
  if (places.HasSample(place))
  {
    const auto [i, j] = places.TraceAt(place);
    guide.Given.Picks.push_back({ i, j, place.z() });
    guide.Places.push_back({ point[0], point[1], point[2] });
  }
  else if (guide.Outside++ == 0)
  {
    guide.FirstOutside = ToText(world);
  }
}

void RequirePicks(const std::vector<GuidePicks>& guides, const CubePlaces& places)
{
  if (guides.empty())
  {
    throw InputError("guides without points, expected picks");
  }
  for (const GuidePicks& guide : guides)
  {
    if (guide.Given.Picks.empty())
    {
      throw InputError("guide \"" + guide.Given.Name + "\": none of its " + std::to_string(guide.Outside) +
        " points is on the cube, the first is at " + guide.FirstOutside + ", expected points from " +
        places.CornersText());
    }
  }
}

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
ImageCube MakeImageCube(vtkImageData* image, vtkDataArray* amplitudes)
{
  CheckImage(image, amplitudes);
  ImageCube cube;
  cube.Traces = MakeTraces(image, amplitudes);
  vtkFieldData* const fields = image->GetFieldData();
  const bool hasLattice =
    fields->HasArray(FieldArray::LatticeDimensions) || fields->HasArray(FieldArray::LatticeToWorld);
  hasLattice ? PlaceByFields(image, cube) : PlaceByImage(image, cube);
  return cube;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<GuidePicks> ReadGuides(vtkDataObject* points, const ImageCube& cube)
{
  const CubePlaces places(cube);
  std::vector<GuidePicks> guides;
  std::map<std::string, std::size_t> numbers; // by given names
  for (const HorizonLeaf& leaf : ListHorizons(points, {}))
  {
    CheckArraySizes(leaf.Input);
    const vtkSmartPointer<vtkPolyData> shown = WithoutHiddenPoints(leaf.Input);
    vtkAbstractArray* const names = shown->GetPointData()->GetAbstractArray("Horizon");
    if (names && names->GetNumberOfComponents() != 1)
    {
      throw InputError("guide array Horizon of " + std::to_string(names->GetNumberOfComponents()) +
        " components, expected the number or the name of the horizon of each point");
    }
    for (vtkIdType n = 0; n < shown->GetNumberOfPoints(); ++n)
    {
      const std::string name = names ? names->GetVariantValue(n).ToString() : leaf.Name;
      const auto [number, isNew] = numbers.insert({ name, guides.size() });
      if (isNew)
      {
        guides.emplace_back();
        guides.back().Given.Name = name.empty() ? "Guide " + std::to_string(guides.size()) : name;
      }
      AddPoint(shown->GetPoint(n), places, guides[number->second]);
    }
  }
  RequirePicks(guides, places);
  return guides;
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
