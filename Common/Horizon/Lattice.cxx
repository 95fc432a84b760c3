// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Lattice.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
// Coordinates stay below 2^29 even half a column outside the lattice (see PlanePoint).
constexpr int CoordinateBits = 29;
// A millionth of a column is finer than any data, and smaller numbers compare faster.
constexpr int MaximumSubVoxelBits = 20;

// Least sine of the angle between column steps. World coordinates have 16 digits, and the conversion to columns
// loses one per leading zero of the sine; seven remain.
constexpr double SmallestSine = 1e-9;
// Relative deviation of the scalar products of steps from a cube, about fifty roundings of a double, which covers
// rotated surveys.
constexpr double RoundingOfProducts = 1e-14;

int BitsFor(std::int64_t size)
{
  int bits = 0;
  while ((std::int64_t(1) << bits) < size + 1)
  {
    ++bits;
  }
  return bits;
}

void CheckDimensions(const std::array<int, 3>& dimensions)
{
  const int largest = std::max(dimensions[0], dimensions[1]);
  const int smallest = std::min({ dimensions[0], dimensions[1], dimensions[2] });
  if (smallest < 1 || largest > MostColumnsPerSide)
  {
    std::ostringstream text;
    text << "lattice of " << dimensions[0] << " x " << dimensions[1] << " x " << dimensions[2]
         << " cells, expected at least 1 and less than 2^28 columns a side";
    throw InputError(text.str());
  }
}

void CheckMap(const Eigen::Matrix4d& toWorld)
{
  if (!toWorld.allFinite() || toWorld.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
  {
    throw InputError("lattice-to-world matrix that is not affine, expected finite numbers and a last row of 0 0 0 1");
  }
  if (toWorld(0, 2) != 0.0 || toWorld(1, 2) != 0.0 || toWorld(2, 0) != 0.0 || toWorld(2, 1) != 0.0)
  {
    throw InputError("lattice-to-world matrix that tilts the columns, expected vertical columns over a level plane");
  }
  if (toWorld(2, 2) == 0.0 || AreParallel(toWorld.block<2, 1>(0, 0), toWorld.block<2, 1>(0, 1)))
  {
    throw InputError("lattice-to-world matrix that cannot be inverted, expected two column steps that are not "
                     "parallel and a vertical step that is not 0");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
bool AreParallel(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  const double lengths = std::hypot(a.x(), a.y()) * std::hypot(b.x(), b.y());
  return !(std::abs(a.x() * b.y() - a.y() * b.x()) > SmallestSine * lengths);
}

//----------------------------------------------------------------------------------------------------------------------
Lattice::Lattice(const std::array<int, 3>& dimensions, const Eigen::Matrix4d& toWorld)
  : Dimensions(dimensions)
{
  CheckDimensions(dimensions);
  CheckMap(toWorld);
  this->IntoWorld.matrix() = toWorld;
  this->FromWorld = this->IntoWorld.inverse(Eigen::Affine);
  this->SubVoxelBits = std::min(MaximumSubVoxelBits, CoordinateBits - BitsFor(std::max(dimensions[0], dimensions[1])));
}

//----------------------------------------------------------------------------------------------------------------------
double Lattice::LargestCoordinate() const
{
  double largest = 0.0;
  for (const double i : { -0.5, this->Dimensions[0] - 0.5 })
  {
    for (const double j : { -0.5, this->Dimensions[1] - 0.5 })
    {
      largest = std::max(largest, this->ToWorld({ i, j, 0.0 }).head<2>().cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

//----------------------------------------------------------------------------------------------------------------------
double Lattice::UniformScale() const
{
  const Eigen::Matrix3d products = this->IntoWorld.linear().transpose() * this->IntoWorld.linear();
  const double squared = products(0, 0);
  return products.isApprox(squared * Eigen::Matrix3d::Identity(), RoundingOfProducts) ? std::sqrt(squared) : 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
void Lattice::ThrowOutside(const Eigen::Vector3d& lattice, PointId point) const
{
  std::ostringstream text;
  text << "point " << point << " at column (" << lattice.x() << ", " << lattice.y() << "), height " << lattice.z()
       << ", expected a place on the lattice of " << this->Dimensions[0] << " x " << this->Dimensions[1]
       << " columns, at most 2^50 vertical indices up or down";
  throw InputError(text.str());
}
}
