// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointPyramid.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PointPyramid::PointPyramid(const SearchGrid& points)
  : Points(points)
{
  this->MakeRuns();
  this->MakeLowest();
  while (this->Levels.back().Boxes.size() > 1)
  {
    this->MakeNext();
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PointPyramid::MakeRuns()
{
  const PointId count = this->Points.EndOf(this->Points.Voxels().Size() - 1);
  this->Runs.emplace_back(std::size_t((count - 1) / RunSize + 1));
  PlaneBox* run = this->Runs.back().data();
  for (PointId first = 0; first < count; first += RunSize, ++run)
  {
    for (PointId point = first; point < std::min(first + RunSize, count); ++point)
    {
      run->Add(this->Points.At(point));
    }
  }
  while (this->Runs.back().size() > 1)
  {
    const std::vector<PlaneBox>& below = this->Runs.back();
    std::vector<PlaneBox> runs(((below.size() - 1) >> RunShift) + 1);
    for (std::size_t n = 0; n < below.size(); ++n)
    {
      runs[n >> RunShift].Add(below[n]);
    }
    this->Runs.push_back(std::move(runs));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PointPyramid::MakeLowest()
{
  const CellGrid& voxels = this->Points.Voxels();
  Level level{ (voxels.SizeX() - 1) / BaseSize + 1, (voxels.SizeY() - 1) / BaseSize + 1, {} };
  level.Boxes.resize(std::size_t(level.SizeX * level.SizeY));
  for (std::int64_t y = 0; y < voxels.SizeY(); ++y)
  {
    PlaneBox* box = level.Boxes.data() + y / BaseSize * level.SizeX;
    for (std::int64_t x = 0; x < voxels.SizeX(); x += BaseSize, ++box)
    {
      const std::int64_t last = std::min(x + BaseSize, voxels.SizeX()) - 1;
      const PointId end = this->Points.EndOf(voxels.Index(last, y));
      for (PointId point = this->Points.FirstIn(voxels.Index(x, y)); point < end; ++point)
      {
        box->Add(this->Points.At(point));
      }
    }
  }
  this->Levels.push_back(std::move(level));
}

//----------------------------------------------------------------------------------------------------------------------
void PointPyramid::MakeNext()
{
  const Level& below = this->Levels.back();
  Level level{ (below.SizeX + 1) / 2, (below.SizeY + 1) / 2, {} };
  level.Boxes.resize(std::size_t(level.SizeX * level.SizeY));
  for (std::int64_t y = 0; y < below.SizeY; ++y)
  {
    for (std::int64_t x = 0; x < below.SizeX; ++x)
    {
      const PlaneBox& box = below.Boxes[std::size_t(y * below.SizeX + x)];
      level.Boxes[std::size_t(y / 2 * level.SizeX + x / 2)].Add(box);
    }
  }
  this->Levels.push_back(std::move(level));
}
}
