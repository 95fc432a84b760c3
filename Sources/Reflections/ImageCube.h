// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsImageCube_h
#define SeismicHorizonsImageCube_h

#include "Common/Horizon/Lattice.h"
#include "Common/Survey/LatticeFrame.h"
#include "Filters/Algorithms/Reflections/TraceCube.h"

#include <Eigen/Core>

#include <array>
#include <string>

class vtkDataArray;
class vtkImageData;

namespace SeismicHorizons
{
struct ImageCube
{
  TraceCube Traces; // refers to the memory of the image
  std::array<int, 3> FirstIndex = { 0, 0, 0 }; // lattice index of the first trace and sample
  LatticeFrame Frame;
};

/// Hidden points and infinite numbers are no samples. A lattice in the field data precedes the image's own. Throws
/// InputError on an invalid array or lattice. `image` must outlive the cube.
ImageCube MakeImageCube(vtkImageData* image, vtkDataArray* amplitudes);

/// Places are in columns and samples from the first trace and sample of the cube.
class CubePlaces
{
public:
  explicit CubePlaces(const ImageCube& cube);

  Eigen::Vector3d ToCube(const Eigen::Vector3d& world) const { return this->Lattice.ToLattice(world) - this->First; }
  bool HasTrace(const Eigen::Vector3d& place) const;
  /// The place must have a trace.
  std::array<int, 2> TraceAt(const Eigen::Vector3d& place) const;
  bool HasSample(const Eigen::Vector3d& place) const
  {
    return this->HasTrace(place) && place.z() >= 0.0 && place.z() <= this->Last.z();
  }
  /// "(...) to (...)": world coordinates of the first and last corner
  std::string CornersText() const;

private:
  SeismicHorizons::Lattice Lattice;
  Eigen::Vector3d First; // lattice index
  Eigen::Vector3d Last; // last trace and sample, in cube units
};
}

#endif
