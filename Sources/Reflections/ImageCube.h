// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsImageCube_h
#define SeismicHorizonsImageCube_h

#include "Common/Horizon/DataArray.h"
#include "Common/Survey/LatticeFrame.h"
#include "Filters/Algorithms/Reflections/TraceCube.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>

namespace SeismicHorizons
{
/// An image with traces along k.
struct SeismicImage
{
  std::array<int, 6> Extent = { 0, -1, 0, -1, 0, -1 }; // first and last i, j and k
  Eigen::Affine3d ToWorld = Eigen::Affine3d::Identity(); // of indices
  DataArray Amplitudes; // i runs fastest
  TraceCube InFile; // takes the place of amplitudes that are not in memory
  std::optional<DataArray> Ghosts; // of the type unsigned char
  ArrayTable FieldData;

  std::array<int, 3> Size() const
  {
    return { this->Extent[1] - this->Extent[0] + 1, this->Extent[3] - this->Extent[2] + 1,
      this->Extent[5] - this->Extent[4] + 1 };
  }
};

struct ImageCube
{
  SeismicImage Image;
  TraceCube Traces; // refers to the memory of the image, or to a file
  std::array<int, 3> FirstIndex = { 0, 0, 0 }; // lattice index of the first trace and sample
  LatticeFrame Frame;
};

/// Hidden points and infinite numbers are no samples. A lattice in the field data precedes the image's own. Throws
/// InputError on an invalid array or lattice.
ImageCube MakeImageCube(SeismicImage image);
}

#endif
