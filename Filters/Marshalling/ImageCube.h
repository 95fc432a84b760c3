// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From images to seismic cubes.

#ifndef SeismicHorizonsImageCube_h
#define SeismicHorizonsImageCube_h

#include "Common/Lattice.h"
#include "Common/Survey/LatticeFrame.h"
#include "Reflections/TraceCube.h"

#include <Eigen/Core>

#include <array>
#include <string>

class vtkDataArray;
class vtkImageData;

namespace SeismicHorizons
{
struct ImageCube
{
  TraceCube Traces; // into the memory of the image
  std::array<int, 3> FirstIndex = { 0, 0, 0 }; // of the lattice, at the first trace and sample
  LatticeFrame Frame;
};

/// A cube whose traces run along k. Points that are hidden have no sample, and neither have numbers that are not
/// finite.
///
/// With the field data arrays LatticeDimensions and LatticeToWorld the extent of the image counts on that lattice, and
/// its points have to lie there. Without them the lattice is that of the image. Throws InputError on an array that is
/// not one number for each point, on images whose k axis is not vertical, or that have no sample, and on wrong
/// lattices. The image has to outlive the cube.
ImageCube MakeImageCube(vtkImageData* image, vtkDataArray* amplitudes);

/// Places in the world, in columns and samples from the first trace and sample of a cube on.
class CubePlaces
{
public:
  explicit CubePlaces(const ImageCube& cube);

  Eigen::Vector3d ToCube(const Eigen::Vector3d& world) const { return this->Lattice.ToLattice(world) - this->First; }
  bool HasTrace(const Eigen::Vector3d& place) const;
  /// The nearest to a place that has one.
  std::array<int, 2> TraceAt(const Eigen::Vector3d& place) const;
  bool HasSample(const Eigen::Vector3d& place) const
  {
    return this->HasTrace(place) && place.z() >= 0.0 && place.z() <= this->Last.z();
  }
  /// "(...) to (...)": the first and the last corner of the cube in the world.
  std::string CornersText() const;

private:
  SeismicHorizons::Lattice Lattice;
  Eigen::Vector3d First; // index of the lattice
  Eigen::Vector3d Last; // trace and sample
};
}

#endif
