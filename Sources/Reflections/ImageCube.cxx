// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImageCube.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Filters/Common/HorizonData.h"

#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

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

void CheckImage(const SeismicImage& image)
{
  const Indices size = image.Size();
  if (size[0] < 1 || size[1] < 1 || size[2] < 2)
  {
    throw InputError("an image of " + CubeText(size) + " points, expected traces of two samples or more along k");
  }
  if (image.InFile.Read)
  {
    return;
  }
  const DataArray& amplitudes = image.Amplitudes;
  if (amplitudes.Components() != 1)
  {
    throw InputError("array " + amplitudes.Name + " of " + std::to_string(amplitudes.Components()) +
      " components, expected amplitudes, one for each point");
  }
  const std::int64_t points = std::int64_t(size[0]) * size[1] * size[2];
  RequireTuples(amplitudes, points, "points");
  if (image.Ghosts)
  {
    RequireTuples(*image.Ghosts, points, "points");
  }
}

// ---- Samples --------------------------------------------------------------------------------------------------------
template <typename Sample>
TraceCube MakeTraces(const Sample* first, const Indices& size, const unsigned char* ghosts)
{
  StridedSamples<Sample> samples;
  samples.First = first;
  samples.Strides = { 1, size[0], std::ptrdiff_t(size[0]) * size[1] };
  samples.Marks = ghosts;
  samples.MissingMask = GhostMark::HiddenPoint;
  return MakeTraceCube(size, samples);
}

TraceCube MakeTraces(const SeismicImage& image)
{
  TraceCube traces = image.InFile;
  const unsigned char* const ghosts = image.Ghosts ? image.Ghosts->As<unsigned char>() : nullptr;
  if (!traces.Read)
  {
    image.Amplitudes.WithNumbers([&](const auto* samples) { traces = MakeTraces(samples, image.Size(), ghosts); });
  }
  return traces;
}

// ---- Lattices -------------------------------------------------------------------------------------------------------
/// VerticalDirection in the field data counts before the map.
LatticeFrame MakeFrame(const SeismicImage& image, const Indices& size, const Eigen::Matrix4d& map)
{
  const bool isDown = FirstValue(image.FieldData, FieldArray::VerticalDirection, map(2, 2)) < 0.0;
  return MakeLatticeFrame(size, map, isDown ? VerticalDirection::Down : VerticalDirection::Up);
}

/// The lattice begins at the first point of the image.
void PlaceByImage(const SeismicImage& image, ImageCube& cube)
{
  const Eigen::Affine3d& map = image.ToWorld;
  const auto& axes = map.linear();
  if (axes(2, 0) != 0.0 || axes(2, 1) != 0.0 || axes(0, 2) != 0.0 || axes(1, 2) != 0.0)
  {
    throw InputError("an image whose k axis is not vertical, or whose i and j axes are not level, expected traces "
                     "along z: turn it by Transform or Permute");
  }
  const std::array<int, 6>& extent = image.Extent;
  const Eigen::Vector3d first(extent[0], extent[2], extent[4]);
  const Eigen::Affine3d fromFirst = map * Eigen::Translation3d(first);
  Lattice(cube.Traces.Size, fromFirst.matrix()); // This throws on invalid lattices.
  cube.Frame = MakeFrame(image, cube.Traces.Size, fromFirst.matrix());
}

/// Resample, Extract Subset and Transform do not change the lattice in the field data. An image with the default map
/// has nothing to compare.
void CheckPlaces(const SeismicImage& image, const Lattice& lattice)
{
  const Eigen::Affine3d& map = image.ToWorld;
  if (map.isApprox(Eigen::Affine3d::Identity(), 0.0))
  {
    return;
  }
  const double deviation = FirstValue(image.FieldData, FieldArray::ImageDeviation);
  const double most = 0.25 + (deviation > 0.0 ? deviation : 0.0);
  const std::array<int, 6>& extent = image.Extent;
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

void PlaceByFields(const SeismicImage& image, ImageCube& cube)
{
  Horizon fields;
  fields.FieldData = image.FieldData;
  const Indices dimensions = ReadLatticeDimensions(fields);
  const Eigen::Matrix4d map = ReadLatticeMap(fields);
  const Lattice lattice(dimensions, map);
  const std::array<int, 6>& extent = image.Extent;
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
ImageCube MakeImageCube(SeismicImage image)
{
  CheckImage(image);
  ImageCube cube;
  cube.Traces = MakeTraces(image);
  const bool hasLattice =
    image.FieldData.Has(FieldArray::LatticeDimensions) || image.FieldData.Has(FieldArray::LatticeToWorld);
  hasLattice ? PlaceByFields(image, cube) : PlaceByImage(image, cube);
  cube.Image = std::move(image);
  return cube;
}
}
