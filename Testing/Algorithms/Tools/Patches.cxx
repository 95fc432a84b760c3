// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Patches.h"

#include <algorithm>
#include <cmath>

namespace Patches
{
namespace
{
class Picture
{
public:
  Picture(int width, int height)
    : Width(width)
    , Height(height)
    , Filled(std::size_t(width * height), false)
  {
  }

  void Set(int x, int y, bool filled = true)
  {
    if (x >= 0 && y >= 0 && x < this->Width && y < this->Height)
    {
      this->Filled[std::size_t(y * this->Width + x)] = filled;
    }
  }

  /// Fills where inside(x, y) says so.
  template <typename Inside>
  void Fill(Inside&& inside, bool filled = true)
  {
    for (int y = 0; y < this->Height; ++y)
    {
      for (int x = 0; x < this->Width; ++x)
      {
        if (inside(x, y))
        {
          this->Set(x, y, filled);
        }
      }
    }
  }

  Columns Occupied() const
  {
    Columns columns;
    for (int n = 0; n < this->Width * this->Height; ++n)
    {
      if (this->Filled[std::size_t(n)])
      {
        columns.push_back({ n % this->Width, n / this->Width });
      }
    }
    return columns;
  }

  const int Width;
  const int Height;

private:
  std::vector<bool> Filled;
};

void FillDiscs(Picture& picture, Random& random, int discs, bool filled)
{
  for (int n = 0; n < discs; ++n)
  {
    const int x = random.Below(picture.Width);
    const int y = random.Below(picture.Height);
    const int radius = 1 + random.Below(1 + picture.Width / 4);
    picture.Fill([=](int i, int j) { return (i - x) * (i - x) + (j - y) * (j - y) <= radius * radius; }, filled);
  }
}

void DrawLine(Picture& picture, Random& random)
{
  int x = random.Below(picture.Width);
  int y = random.Below(picture.Height);
  const int stepX = random.Below(3) - 1;
  const int stepY = random.Below(3) - 1;
  for (int n = random.Below(picture.Width); n >= 0; --n)
  {
    picture.Set(x, y);
    x += stepX;
    y += stepY;
  }
}

void DrawSpiral(Picture& picture, int gap)
{
  int x = 0;
  int y = 0;
  int stepX = 1;
  int stepY = 0;
  for (int length = picture.Width - 1; length > 0; length -= stepX == 0 ? gap : 0)
  {
    for (int n = 0; n < length; ++n, x += stepX, y += stepY)
    {
      picture.Set(x, y);
    }
    std::swap(stepX, stepY);
    stepX = -stepX;
  }
}

void Draw(Picture& picture, Shape shape, Random& random)
{
  const int period = 2 + random.Below(3);
  switch (shape)
  {
    case Shape::Sparse:
      picture.Fill([&](int, int) { return random.Chance(0.35); });
      break;
    case Shape::Solid:
      picture.Fill([](int, int) { return true; });
      break;
    case Shape::Blob:
      FillDiscs(picture, random, 6, true);
      FillDiscs(picture, random, 2, false);
      picture.Fill([&](int, int) { return random.Chance(0.04); }, false);
      break;
    case Shape::Comb:
      picture.Fill([=](int x, int y) { return y < 2 || x % period == 0; });
      break;
    case Shape::Spiral:
      DrawSpiral(picture, period);
      break;
    case Shape::Spurs:
      FillDiscs(picture, random, 2, true);
      for (int n = 0; n < 8; ++n)
      {
        DrawLine(picture, random);
      }
      break;
    case Shape::Pinched:
      picture.Fill([=](int x, int y) { return ((x / period) + (y / period)) % 2 == 0; });
      break;
    case Shape::Checkerboard:
      picture.Fill([](int x, int y) { return (x + y) % 2 == 0; });
      break;
    case Shape::Rings:
      picture.Fill([&](int x, int y)
        { return std::max(std::abs(x - picture.Width / 2), std::abs(y - picture.Height / 2)) % period == 0; });
      picture.Fill([&](int, int) { return random.Chance(0.03); }, false);
      break;
    case Shape::SinglePoint:
    case Shape::Count:
      break;
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::uint64_t Random::Next()
{
  // splitmix64 (Steele, Lea and Flood 2014)
  std::uint64_t z = (this->State += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

//----------------------------------------------------------------------------------------------------------------------
Columns Make(Shape shape, Random& random)
{
  Picture picture(4 + random.Below(17), 4 + random.Below(17));
  Draw(picture, shape, random);
  Columns columns = picture.Occupied();
  if (columns.empty())
  {
    columns.push_back({ random.Below(picture.Width), random.Below(picture.Height) });
  }
  for (std::size_t n = columns.size(); n > 1; --n)
  {
    std::swap(columns[n - 1], columns[std::size_t(random.Below(int(n)))]);
  }
  return columns;
}

//----------------------------------------------------------------------------------------------------------------------
Columns FromPicture(const std::vector<std::string>& rows)
{
  Columns columns;
  for (std::size_t y = 0; y < rows.size(); ++y)
  {
    const std::string& row = rows[rows.size() - 1 - y];
    for (std::size_t x = 0; x < row.size(); ++x)
    {
      if (row[x] == '#')
      {
        columns.push_back({ std::int32_t(x), std::int32_t(y) });
      }
    }
  }
  return columns;
}
}
