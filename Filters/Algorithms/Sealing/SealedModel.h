// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A sealed model: horizons, faults, and the walls of a box, which share the vertices of the lines where they meet and
// enclose bodies without gaps.
//
// Each surface is made larger than needed and meshed within its error (BlockHeights.h, Sheets.h). All are cut along
// their common lines (Arrangement.h). Blocks are leaves of a tree of faults, and each place has a layer in its block
// (BlockTree.h): a triangle stays if both of its sides differ. So bodies are closed whatever the surfaces are. Last,
// vertices beside lines are removed while nothing is pierced and errors hold (SealedImprover.h).
//
// A fault that dies out is cut along its tip line, too, by planes across it (ribbons). Beyond, what is alike on both sides
// becomes one, and the strips of the fault between the sides of horizons, which differ by their errors, are closed.

#ifndef SeismicHorizonsSealedModel_h
#define SeismicHorizonsSealedModel_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Cutoffs/Cutoffs.h"
#include "Filters/Algorithms/Cutoffs/FaultPlate.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A side of a fault that comes earlier in order.
struct FaultSideOf
{
  std::size_t Fault;
  bool IsHanging;
};

struct SealingFault
{
  FaultPlate Plate; // x and y from column (0, 0) along the axes of the lattice
  /// The fault is where all of these hold, and ends at their faults. A fault that ends before counts neither.
  std::vector<FaultSideOf> Region;
  /// The fault ends at this horizon from below, and does not cut those above.
  std::optional<std::size_t> EndsBelow;
  /// This is another part of that earlier fault.
  std::optional<std::size_t> PartOf;
  /// The fault dies out at this closed line, of S and Z of the plate; empty if it goes on up to its region and the walls.
  std::vector<Eigen::Vector2d> TipLoop = {};

  bool IsBeyondTips(const FaultPlace& place) const;
};

struct SealingHorizon
{
  std::string Name;
  std::vector<PlanePoint> Columns; // A column may have several picks, as of reverse faults.
  std::vector<double> Heights;
  /// By fault; empty to follow the picks alone. Picks that do not agree are not used.
  std::vector<HorizonCutoffs> AtFault = {};
};

struct SealingInput
{
  Eigen::Vector2d Step = Eigen::Vector2d::Ones(); // between columns
  PlanePoint Least = { 0, 0 }; // columns of the walls
  PlanePoint Greatest = { 1, 1 };
  double Top = 0.0;
  double Base = 0.0;
  /// Corners of the walls, clockwise, inside the box, no three on one line; empty for the box.
  std::vector<PlanePoint> Outline;
  std::vector<SealingFault> Faults;
  std::vector<SealingHorizon> Horizons; // from the uppermost on

  Eigen::AlignedBox3d Box() const
  {
    return { Eigen::Vector3d(this->Step.x() * this->Least.X, this->Step.y() * this->Least.Y, this->Base),
      Eigen::Vector3d(this->Step.x() * this->Greatest.X, this->Step.y() * this->Greatest.Y, this->Top) };
  }

  /// Of the walls, clockwise. Those of the box begin in the south-west.
  std::vector<Eigen::Vector2d> Corners() const
  {
    std::vector<PlanePoint> columns = this->Outline;
    if (columns.empty())
    {
      columns = { this->Least, { this->Least.X, this->Greatest.Y }, this->Greatest,
        { this->Greatest.X, this->Least.Y } };
    }
    std::vector<Eigen::Vector2d> corners;
    for (const PlanePoint& column : columns)
    {
      corners.emplace_back(this->Step.x() * column.X, this->Step.y() * column.Y);
    }
    return corners;
  }
};

/// Whether a place is inside a closed line.
bool IsInside(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& place);

struct SealingOptions
{
  double MaximumError = 1.0; // of heights of horizons
  double FaultError = 1.0; // of faults, across strike
  double DropDistance = 0.5; // columns; nearer picks are not used
};

enum class SealedSurfaceType : unsigned char
{
  Horizon = 0,
  Fault = 1,
  Wall = 2,
  Limit = 3 // top and base
};

struct SealedSurface
{
  std::string Name;
  SealedSurfaceType Type;
};

struct SealedTriangle
{
  /// Counter-clockwise seen from above, of faults from the hanging wall, and of walls from inside.
  std::array<std::int32_t, 3> Corners;
  std::int32_t Surface;
  /// Before and behind the triangle; -1 outside. The same where a fault dies out in a body.
  std::array<std::int32_t, 2> Body;
};

/// A part of a layer in a block.
struct SealedBody
{
  std::size_t Layer = 0; // 0 is above the first horizon
  std::size_t Block = 0;
  double Volume = 0.0;
};

/// A horizon in a block without enough picks.
struct SealedGuess
{
  std::size_t Horizon;
  std::vector<signed char> Sides; // of the block, as in Blocks
};

enum class VertexSource : unsigned char
{
  Picks = 0, // within two columns, or inside the picks of a fault
  Continued = 1,
  OtherHorizon = 2
};

/// What became of the picks of a horizon: each is in one of the first five.
struct PickAccount
{
  std::size_t Used = 0;
  std::size_t BesideFaults = 0; // nearer than the drop distance
  std::size_t NotAgreeing = 0; // HorizonCutoffs::Dropped
  std::size_t Doubled = 0; // in the column of another pick of the block
  std::size_t Outside = 0; // of the box
  std::size_t Moved = 0; // of those used, away from the horizon above, or the top or base
  double LargestMove = 0.0;
  std::size_t Columns = 0; // of the horizon in the box
  std::size_t Continued = 0; // of these, without a pick that is used
};

/// A fault that picks continue beyond its tips, and by how much.
struct TipStep
{
  std::string Fault;
  double Distance = 0.0;
};

struct SealedModel
{
  std::vector<Eigen::Vector3d> Vertices;
  std::vector<VertexSource> Sources; // by vertex; the farthest of its surfaces
  std::vector<SealedTriangle> Triangles;
  std::vector<SealedSurface> Surfaces; // horizons, faults, walls, top and base
  std::vector<SealedBody> Bodies;
  std::vector<std::vector<signed char>> Blocks; // sides by fault: 1 hanging wall, -1 footwall, 0 not there
  std::vector<std::string> FaultNames; // by fault, those of parts included
  std::vector<SealedGuess> Guessed;
  std::vector<PickAccount> Accounts; // by horizon
  std::vector<TipStep> Steps;
  std::vector<std::int32_t> BeyondTips; // surfaces of faults that are left beyond their tips, as horizons step there
  double LargestError = 0.0; // of picks that are used, and not moved
  double LeastAngle = 0.0; // between triangles at edges, in degrees
  std::size_t Slivers = 0; // triangles thinner than a thousandth of a column
};

/// Throws InputError if surfaces cannot be sealed.
SealedModel SealModel(
  SealingInput input, const SealingOptions& options = SealingOptions(), const Monitor& monitor = Monitor());
}

#endif
