// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CrackedPatches.h"

#include "Common/Horizon/PlaneGeometry.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <set>
#include <utility>

namespace CrackedPatches
{
using SeismicHorizons::PlaneBox;

namespace
{
/// Cracks lead over the middles of blocks. A block is given by its least corner.
class CrackPen
{
public:
  CrackPen(const PlaneBox& box, Patches::Random& random)
    : Box(box)
    , Cuts(box)
    , Source(random)
    , Width(box.Greatest.X - box.Least.X + 2)
    , Height(box.Greatest.Y - box.Least.Y + 2)
  {
  }

  /// A walk that rarely turns, from anywhere or from a block of an earlier walk.
  void DrawWalk()
  {
    PlanePoint at = this->Blocks.empty() || this->Source.Chance(0.5)
      ? PlanePoint{ this->Box.Least.X - 1 + this->Source.Below(this->Width),
          this->Box.Least.Y - 1 + this->Source.Below(this->Height) }
      : this->Blocks[std::size_t(this->Source.Below(int(this->Blocks.size())))];
    int direction = this->Source.Below(4);
    const double turns = this->Source.Chance(0.5) ? 0.1 : 0.5;
    for (int left = 1 + this->Source.Below(this->Width + this->Height); left > 0; --left)
    {
      this->Step(at, direction);
      direction = this->Source.Chance(turns) ? (direction + 1 + 2 * this->Source.Below(2)) % 4 : direction;
    }
  }

  void DrawRing()
  {
    PlanePoint at{ this->Box.Least.X - 1 + this->Source.Below(this->Width),
      this->Box.Least.Y - 1 + this->Source.Below(this->Height) };
    const std::array<int, 2> sides = { 1 + this->Source.Below(4), 1 + this->Source.Below(4) };
    for (int direction = 0; direction < 4; ++direction)
    {
      for (int n = 0; n < sides[std::size_t(direction % 2)]; ++n)
      {
        this->Step(at, direction);
      }
    }
  }

  /// Every link by chance.
  void DrawDust(double density)
  {
    for (std::int32_t y = this->Box.Least.Y; y <= this->Box.Greatest.Y; ++y)
    {
      for (std::int32_t x = this->Box.Least.X; x <= this->Box.Greatest.X; ++x)
      {
        this->Source.Chance(density) ? this->Cuts.CutEast({ x, y }) : void();
        this->Source.Chance(density) ? this->Cuts.CutNorth({ x, y }) : void();
      }
    }
  }

  const LinkCuts& Result() const { return this->Cuts; }
  const std::vector<PlanePoint>& VisitedBlocks() const { return this->Blocks; }

private:
  /// To the right, up, to the left or down, through the link between that block and this one.
  void Step(PlanePoint& at, int direction)
  {
    const bool isAlongX = direction % 2 == 0;
    const int sign = direction < 2 ? 1 : -1;
    const PlanePoint next{ at.X + (isAlongX ? sign : 0), at.Y + (isAlongX ? 0 : sign) };
    const PlanePoint greater{ std::max(at.X, next.X), std::max(at.Y, next.Y) };
    const PlanePoint column{ isAlongX ? greater.X : at.X, isAlongX ? at.Y : greater.Y };
    if (this->Box.Contains(column))
    {
      isAlongX ? this->Cuts.CutNorth(column) : this->Cuts.CutEast(column);
    }
    at = next;
    this->Blocks.push_back(at);
  }

  const PlaneBox Box;
  LinkCuts Cuts;
  Patches::Random& Source;
  const int Width;
  const int Height;
  std::vector<PlanePoint> Blocks; // that cracks reached
};

/// A ring of columns around an island. Its right side is where the last crack ends.
void AddMoat(const PlanePoint& end, Patches::Random& random, std::set<PlanePoint>& gone)
{
  const int width = 2 + random.Below(5);
  const int height = 2 + random.Below(5);
  const PlanePoint corner{ end.X + 1 - width, end.Y - random.Below(height) };
  for (int x = 0; x <= width; ++x)
  {
    for (int y = 0; y <= height; ++y)
    {
      if (x % width == 0 || y % height == 0)
      {
        gone.insert({ corner.X + x, corner.Y + y });
      }
    }
  }
}

/// Takes columns away: anywhere, at the corners of blocks that cracks reach, and around islands.
void MakeGaps(Patches::Columns& columns, const std::vector<PlanePoint>& blocks, Patches::Random& random)
{
  std::set<PlanePoint> gone;
  for (int n = random.Below(6); n > 0; --n)
  {
    const bool isBesideCrack = random.Chance(0.7);
    const PlanePoint corner = isBesideCrack ? blocks[std::size_t(random.Below(int(blocks.size())))]
                                            : columns[std::size_t(random.Below(int(columns.size())))];
    const int width = 1 + random.Below(3);
    const int height = 1 + random.Below(3);
    for (int x = 0; x < width; ++x)
    {
      for (int y = 0; y < height; ++y)
      {
        gone.insert({ corner.X + x, corner.Y + y });
      }
    }
  }
  if (random.Chance(0.3))
  {
    AddMoat(blocks.back(), random, gone);
  }
  Patches::Columns left;
  std::copy_if(columns.begin(), columns.end(), std::back_inserter(left),
    [&gone](const PlanePoint& column) { return gone.count(column) == 0; });
  columns = left.empty() ? columns : left;
}
}

//----------------------------------------------------------------------------------------------------------------------
int NumberOfLattices()
{
  const char* const wanted = std::getenv("SEISMICHORIZONS_CRACKED_LATTICES");
  return wanted ? std::atoi(wanted) : 300;
}

//----------------------------------------------------------------------------------------------------------------------
CrackedPatch Make(Patches::Random& random)
{
  Patches::Columns columns;
  const int kind = random.Below(3);
  columns =
    Patches::Make(kind < 2 ? Patches::Shape::Solid : Patches::Shape(random.Below(int(Patches::Shape::Count))), random);
  CrackPen pen(PlaneBox(columns), random);
  for (int n = random.Below(4); n >= 0; --n)
  {
    pen.DrawWalk();
  }
  random.Chance(0.3) ? pen.DrawRing() : void();
  random.Chance(0.1) ? pen.DrawDust(0.4 * random.Fraction()) : void();
  if (kind > 0)
  {
    MakeGaps(columns, pen.VisitedBlocks(), random);
  }
  return { columns, pen.Result() };
}
}
