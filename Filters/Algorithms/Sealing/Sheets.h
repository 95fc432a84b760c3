// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces of a sealed model before they are cut: meshes of heights over a plane, each larger than needed.

#ifndef SeismicHorizonsSheets_h
#define SeismicHorizonsSheets_h

#include "BoxTree.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
using SealId = std::int32_t; // of vertices, triangles and sheets
using SheetCorners = std::array<SealId, 3>;

struct Sheet
{
  /// Rows: two directions of the plane, and its normal; right-handed.
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();
  std::vector<Eigen::Vector3d> Vertices;
  std::vector<SheetCorners> Triangles; // counter-clockwise against the normal
  bool IsPlane = false; // walls, top and base
  /// The coordinate that all vertices share.
  std::optional<int> LevelAxis;

  double Level() const { return this->Vertices.front()[*this->LevelAxis]; }
};

/// Heights over the plane, by row.
struct SheetHeights
{
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero(); // of the first row and column
  Eigen::Vector2d Step = Eigen::Vector2d::Ones();
  int Width = 0;
  std::vector<double> Heights; // NaN where the sheet does not reach

  Eigen::Vector3d At(std::size_t node) const
  {
    const auto width = std::size_t(this->Width);
    const Eigen::Vector3d place(this->Origin.x() + this->Step.x() * double(node % width),
      this->Origin.y() + this->Step.y() * double(node / width), this->Heights[node]);
    return this->Axes.transpose() * place;
  }
};

/// Decimates the heights within an error.
Sheet MeshSheet(const SheetHeights& heights, double error, const Monitor& monitor = Monitor());

/// A rectangle from a corner along two directions at a right angle, in squares of about the size. The normal is their cross
/// product.
Sheet MakePlaneSheet(
  const Eigen::Vector3d& corner, const Eigen::Vector3d& along, const Eigen::Vector3d& up, double size);

/// Moves each vertex by up to `distance`, those of planes on it, so that no four are on a plane. `round`
/// gives other moves.
void Shake(std::vector<Sheet>& sheets, double distance, unsigned round);

/// Finds how far places are from a sheet along its normal.
class SheetLocator
{
public:
  explicit SheetLocator(const Sheet& sheet);

  /// Nothing beside the sheet.
  std::optional<double> HeightAbove(const Eigen::Vector3d& place) const;

private:
  const Sheet& Given;
  BoxTree Triangles; // on the plane
};
}

#endif
