// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImageCube.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Marshalling/HorizonData.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
using Indices = std::array<int, 3>;

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

// ---- Samples ---------------------------------------------------------------------------------------------------------
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

// ---- Lattices --------------------------------------------------------------------------------------------------------
Eigen::Affine3d IndexToWorld(vtkImageData* image)
{
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      map.linear()(row, column) = image->GetDirectionMatrix()->GetElement(row, column) * image->GetSpacing()[column];
    }
    map.translation()(row) = image->GetOrigin()[row];
  }
  return map;
}

bool IsVertical(const Eigen::Affine3d& map)
{
  const auto& axes = map.linear();
  return axes(2, 0) == 0.0 && axes(2, 1) == 0.0 && axes(0, 2) == 0.0 && axes(1, 2) == 0.0;
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
  if (!IsVertical(map))
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
CubePlaces::CubePlaces(const ImageCube& cube)
  : First(cube.FirstIndex[0], cube.FirstIndex[1], cube.FirstIndex[2])
  , Last(cube.Traces.Size[0] - 1, cube.Traces.Size[1] - 1, cube.Traces.Size[2] - 1)
{
  Indices dimensions = cube.Traces.Size;
  std::transform(dimensions.begin(), dimensions.end(), cube.FirstIndex.begin(), dimensions.begin(), std::plus<>());
  this->Lattice = SeismicHorizons::Lattice(
    dimensions, Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(cube.Frame.ToWorld().data()));
}

//----------------------------------------------------------------------------------------------------------------------
bool CubePlaces::HasTrace(const Eigen::Vector3d& place) const
{
  return place.x() >= -0.5 && place.x() < this->Last.x() + 0.5 && place.y() >= -0.5 && place.y() < this->Last.y() + 0.5;
}

//----------------------------------------------------------------------------------------------------------------------
std::array<int, 2> CubePlaces::TraceAt(const Eigen::Vector3d& place) const
{
  return { static_cast<int>(std::floor(place.x() + 0.5)), static_cast<int>(std::floor(place.y() + 0.5)) };
}

//----------------------------------------------------------------------------------------------------------------------
std::string CubePlaces::CornersText() const
{
  return SeismicHorizons::ToText(this->Lattice.ToWorld(this->First)) + " to " +
    SeismicHorizons::ToText(this->Lattice.ToWorld(this->First + this->Last));
}
}
