// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StageInput.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Fuzz
{
using namespace SeismicHorizons;

namespace
{
using Numbers = std::numeric_limits<double>;
using ColumnSet = std::set<PlanePoint>;

// The largest heights that distances can be measured at.
constexpr double GreatHeight = LargestCoordinate / 2;

/// Takes the column out of the set, or puts it in.
void Flip(ColumnSet& columns, const PlanePoint& column)
{
  if (columns.erase(column) == 0)
  {
    columns.insert(column);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
Patches::Columns StageInput::TakeColumns()
{
  const int kind = this->TakeBelow(4);
  Patches::Columns columns = kind < 2 ? this->TakeBitmap() : (kind == 2 ? this->TakeShape() : this->TakeScattered());
  if (columns.empty())
  {
    columns.push_back({ 3, 5 });
  }
  Patches::Random random = this->TakeRandom();
  for (std::size_t n = columns.size(); n > 1; --n)
  {
    std::swap(columns[n - 1], columns[std::size_t(random.Below(int(n)))]);
  }
  return columns;
}

//----------------------------------------------------------------------------------------------------------------------
Patches::Columns StageInput::TakeBitmap()
{
  const int width = 1 + this->TakeBelow(20);
  const int height = 1 + this->TakeBelow(20);
  const std::vector<unsigned char> bits = this->Bytes.TakeContents(std::size_t(width * height + 7) / 8);
  Patches::Columns columns;
  for (int n = 0; n < width * height && std::size_t(n / 8) < bits.size(); ++n)
  {
    if ((bits[std::size_t(n / 8)] >> (n % 8) & 1) != 0)
    {
      columns.push_back({ n % width, n / width });
    }
  }
  return columns;
}

//----------------------------------------------------------------------------------------------------------------------
Patches::Columns StageInput::TakeShape()
{
  Patches::Random random = this->TakeRandom();
  const Patches::Columns shape = Patches::Make(Patches::Shape(this->TakeBelow(int(Patches::Shape::Count))), random);
  ColumnSet columns(shape.begin(), shape.end());
  for (int flips = this->TakeBelow(12); flips > 0; --flips)
  {
    const int x = this->TakeBelow(24);
    Flip(columns, { x, this->TakeBelow(24) });
  }
  return { columns.begin(), columns.end() };
}

//----------------------------------------------------------------------------------------------------------------------
Patches::Columns StageInput::TakeScattered()
{
  const int size = this->TakeBool() ? 40 : 700;
  ColumnSet columns;
  for (int points = this->TakeBelow(30); points > 0; --points)
  {
    const int x = this->TakeBelow(size);
    columns.insert({ x, this->TakeBelow(size) });
  }
  return { columns.begin(), columns.end() };
}

//----------------------------------------------------------------------------------------------------------------------
std::shared_ptr<const LinkCuts> StageInput::TakeCuts(const Patches::Columns& columns)
{
  if (this->TakeBool())
  {
    return nullptr;
  }
  const PlaneBox box(columns);
  const int width = box.Greatest.X - box.Least.X + 1;
  const int height = box.Greatest.Y - box.Least.Y + 1;
  const auto cuts = std::make_shared<LinkCuts>(box);
  const auto cut = [&](int x, int y, bool isEast)
  {
    if (x < width && y < height)
    {
      const PlanePoint column{ box.Least.X + x, box.Least.Y + y };
      isEast ? cuts->CutEast(column) : cuts->CutNorth(column);
    }
  };
  for (int lines = this->TakeBelow(8); lines > 0; --lines)
  {
    const int x = this->TakeBelow(width);
    const int y = this->TakeBelow(height);
    const bool isEast = this->TakeBool(); // across which links
    for (int length = this->TakeBelow(16); length >= 0; --length)
    {
      cut(isEast ? x : x + length, isEast ? y + length : y, isEast);
    }
  }
  Patches::Random random = this->TakeRandom();
  for (int links = this->TakeBool() ? 0 : this->TakeBelow(200); links > 0; --links)
  {
    cut(random.Below(width), random.Below(height), random.Chance(0.5));
  }
  return cuts;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> StageInput::TakeHeights(const Patches::Columns& columns)
{
  const int kind = this->TakeBelow(8);
  Patches::Random random = this->TakeRandom();
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(this->TakeHeight(kind, column, random));
  }
  return heights;
}

//----------------------------------------------------------------------------------------------------------------------
double StageInput::TakeHeight(int kind, const PlanePoint& column, Patches::Random& random)
{
  switch (kind)
  {
    case 0: // level
      return 0.0;
    case 1: // on a plane
      return 0.5 * column.X + 0.25 * column.Y;
    case 2: // cliffs
      return (column.X / 5) % 2 == 0 ? 0.0 : 40.0;
    case 3: // extremes
      return GreatHeight * (random.Below(3) - 1);
    case 4: // noise between extremes
      return GreatHeight * random.Fraction();
    case 5: // by the fuzzer
      return this->TakeBelow(64);
    default: // a fold
      return std::round(20.0 + 5.0 * std::sin(0.3 * column.X + 0.2 * column.Y) + random.Fraction());
  }
}

//----------------------------------------------------------------------------------------------------------------------
BoundaryOptions StageInput::TakeBoundaryOptions()
{
  BoundaryOptions options;
  const int odd[] = { 0, -5, LargestRadius + 1, std::numeric_limits<int>::max() };
  options.Radius = this->TakeBelow(16) == 0 ? odd[this->TakeBelow(4)] : 1 + this->TakeBelow(6);
  options.Growth = this->TakeBool() ? GrowthStrategy::Clockwise : GrowthStrategy::Distance;
  options.KeepHoles = this->TakeBool();
  options.SmallestHoleSize = this->TakeSize();
  options.MinimumPatchSize = this->TakeSize();
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t StageInput::TakeSize()
{
  const std::int64_t sizes[] = { 1, 1, 1, 2, 5, 1000, std::numeric_limits<std::int64_t>::max() };
  return sizes[this->TakeBelow(7)];
}

//----------------------------------------------------------------------------------------------------------------------
BoundarySimplificationOptions StageInput::TakeBoundarySimplificationOptions()
{
  BoundarySimplificationOptions options;
  options.DistanceThreshold = this->TakeNumber(0.0, 3.0);
  options.BoundDeviation = this->TakeBool();
  options.OutlineTolerance = this->TakeBool() ? 0.0 : this->TakeNumber(0.0, 4.0);
  options.Method = this->TakeBool() ? OutlineMethod::Threshold : OutlineMethod::FewestPoints;
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
ElaborateOptions StageInput::TakeCellOptions()
{
  const int odd[] = { 0, -1, 100, 1 << 20, std::numeric_limits<int>::max(), std::numeric_limits<int>::min() };
  ElaborateOptions options(this->TakeBelow(8) == 0 ? odd[this->TakeBelow(6)] : 1 + this->TakeBelow(16));
  options.Representative = this->TakeBool() ? RepresentativeKind::Barycentre : RepresentativeKind::NearestPoint;
  options.ListCells = this->TakeBool();
  if (this->TakeBool())
  {
    options.FlatnessThreshold = this->TakeNumber(0.0, 0.4);
    options.BoundaryDensityThreshold = this->TakeNumber(0.0, 3.0);
    options.BoundaryExtentThreshold = this->TakeNumber(0.0, 12.0);
    options.BoundaryCellSizeThreshold = this->TakeNumber(0.0, 10.0);
    options.GrowthPerRing = this->TakeNumber(1.0, 5.0);
    options.SmallestCellSize = this->TakeNumber(1.0, 6.0);
    options.NeighbourMean = this->TakeBool() ? NeighbourMeanKind::OverCubes : NeighbourMeanKind::OverPieces;
  }
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
BoundaryLimits StageInput::TakeBoundaryLimits()
{
  BoundaryLimits limits;
  limits.LargestAngle = this->TakeNumber(0.0, 180.0);
  limits.LongestEdge = this->TakeBool() ? 0.0 : this->TakeNumber(0.0, 10.0);
  return limits;
}

//----------------------------------------------------------------------------------------------------------------------
DecimationOptions StageInput::TakeDecimationOptions()
{
  DecimationOptions options;
  options.MaximumError = this->TakeBool() ? 0.0 : this->TakeNumber(0.0, 10.0);
  options.MaximumNumberOfPoints = this->TakeBool() ? 0 : std::size_t(this->TakeBelow(1000));
  options.FitHeights = this->TakeBool();
  options.Effort = this->TakeBool() ? DecimationEffort::Fast : DecimationEffort::Best;
  options.Priority = this->TakeBool() ? DecimationPriority::LargestError : DecimationPriority::SumOfSquares;
  options.SmallestAngle = this->TakeNumber(0.0, 60.0);
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
SurfaceOptions StageInput::TakeSurfaceOptions()
{
  SurfaceOptions options;
  options.MaximumError = this->TakeNumber(0.0, 10.0);
  options.MaximumNumberOfTriangles = this->TakeBool() ? 0 : std::size_t(1 + this->TakeBelow(1000));
  const BoundaryOptions boundary = this->TakeBoundaryOptions();
  options.Growth = boundary.Growth;
  options.KeepHoles = boundary.KeepHoles;
  options.MinimumPatchSize = boundary.MinimumPatchSize;
  const BoundarySimplificationOptions simplification = this->TakeBoundarySimplificationOptions();
  if (this->TakeBool())
  {
    options.Radius = boundary.Radius;
    options.OutlineTolerance = simplification.OutlineTolerance;
  }
  if (this->TakeBool())
  {
    options.SmallestHoleSize = boundary.SmallestHoleSize;
    options.DistanceThreshold = simplification.DistanceThreshold;
  }
  const DecimationOptions decimation = this->TakeDecimationOptions();
  options.FitHeights = decimation.FitHeights;
  options.Effort = decimation.Effort;
  options.Priority = decimation.Priority;
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
SurfaceDistanceOptions StageInput::TakeSurfaceDistanceOptions()
{
  SurfaceDistanceOptions options;
  options.SamplesPerPoint = 0.01 + 3.0 * this->Bytes.TakeFraction();
  options.Seed = this->Bytes.TakeNumber(std::numeric_limits<std::uint64_t>::max());
  options.Vertical = this->TakeBool();
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
double StageInput::TakeNumber(double low, double high)
{
  const double odd[] = { Numbers::quiet_NaN(), Numbers::infinity(), -Numbers::infinity(), -1.0, -0.0, Numbers::max(),
    Numbers::denorm_min(), low, high };
  const int kind = this->TakeBelow(32);
  return kind < 9 ? odd[kind] : low + (high - low) * this->Bytes.TakeFraction();
}
}
