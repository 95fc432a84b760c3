// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellSides.h"

#include <algorithm>
#include <array>

namespace SeismicHorizons
{
namespace
{
constexpr std::int32_t NoSide = -1;
}

//----------------------------------------------------------------------------------------------------------------------
CellSides::CellSides(const LinkCuts& cuts, std::int32_t width, std::int32_t height)
  : Cuts(cuts)
  , Width(width)
  , Height(height)
{
}

//----------------------------------------------------------------------------------------------------------------------
bool CellSides::HasCut(const PlanePoint& cell) const
{
  for (std::int32_t y = cell.Y; y < cell.Y + this->Height; ++y)
  {
    for (std::int32_t x = cell.X; x < cell.X + this->Width; ++x)
    {
      if ((x + 1 < cell.X + this->Width && this->Cuts.IsCutEast({ x, y })) ||
        (y + 1 < cell.Y + this->Height && this->Cuts.IsCutNorth({ x, y })))
      {
        return true;
      }
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
void CellSides::Find(const PlanePoint& cell)
{
  this->Cell = cell;
  this->ReadCuts();
  for (std::int32_t y = 0; y + 1 < this->Height; ++y)
  {
    for (std::int32_t x = 0; x + 1 < this->Width; ++x)
    {
      this->CarryOn(x, y);
    }
  }
  this->Side.assign(this->East.size(), NoSide);
  std::int32_t sides = 0;
  for (std::size_t place = 0; place < this->Side.size(); ++place)
  {
    if (this->Side[place] == NoSide)
    {
      this->NumberSide(place, sides++);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CellSides::ReadCuts()
{
  const std::size_t columns = std::size_t(this->Width) * std::size_t(this->Height);
  this->East.assign(columns, 0);
  this->North.assign(columns, 0);
  for (std::int32_t y = 0; y < this->Height; ++y)
  {
    for (std::int32_t x = 0; x < this->Width; ++x)
    {
      const PlanePoint column{ this->Cell.X + x, this->Cell.Y + y };
      this->East[this->Place(x, y)] = this->Cuts.IsCutEast(column) ? 1 : 0;
      this->North[this->Place(x, y)] = this->Cuts.IsCutNorth(column) ? 1 : 0;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Where one side of the block with a column as its least corner is cut, cuts that on the other side of the block, and
// goes on from there.
void CellSides::CarryOn(std::int32_t x, std::int32_t y)
{
  while (x >= 0 && y >= 0 && x + 1 < this->Width && y + 1 < this->Height)
  {
    // Below, above, to the left and to the right; the other side is the other one of a pair.
    const std::array<unsigned char*, 4> sides = { &this->East[this->Place(x, y)], &this->East[this->Place(x, y + 1)],
      &this->North[this->Place(x, y)], &this->North[this->Place(x + 1, y)] };
    if (std::count_if(sides.begin(), sides.end(), [](const unsigned char* side) { return *side != 0; }) != 1)
    {
      return;
    }
    const auto cut = std::find_if(sides.begin(), sides.end(), [](const unsigned char* side) { return *side != 0; });
    const std::size_t ahead = std::size_t(cut - sides.begin()) ^ 1U;
    *sides[ahead] = 1;
    constexpr std::array<PlanePoint, 4> steps = { { { 0, -1 }, { 0, 1 }, { -1, 0 }, { 1, 0 } } };
    x += steps[ahead].X;
    y += steps[ahead].Y;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CellSides::NumberSide(std::size_t first, std::int32_t number)
{
  const std::size_t row = std::size_t(this->Width);
  this->Open.assign(1, first);
  this->Side[first] = number;
  const auto reach = [&](bool isJoined, std::size_t place)
  {
    if (isJoined && this->Side[place] == NoSide)
    {
      this->Side[place] = number;
      this->Open.push_back(place);
    }
  };
  while (!this->Open.empty())
  {
    const std::size_t place = this->Open.back();
    this->Open.pop_back();
    const std::size_t x = place % row;
    reach(x + 1 < row && this->East[place] == 0, place + 1);
    reach(place + row < this->Side.size() && this->North[place] == 0, place + row);
    reach(x > 0 && this->East[place - 1] == 0, place - 1);
    reach(place >= row && this->North[place - row] == 0, place - row);
  }
}
}
