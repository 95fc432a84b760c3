// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceWriter.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace SeismicHorizons
{
namespace
{
struct SurfaceSize
{
  std::size_t Sign = 0;
  PointId Surface = NoPoint;
  PointId First = NoPoint; // pick
  PointId Columns = 0;

  friend bool operator<(const SurfaceSize& a, const SurfaceSize& b)
  {
    return std::tie(b.Columns, a.Sign, a.First) < std::tie(a.Columns, b.Sign, b.First);
  }
};

/// For the picks of one sign.
class SignWriter
{
public:
  SignWriter(const ReflectionPicks& picks, const RawVector<PointId>& surfaces)
    : Picks(picks)
    , Surfaces(surfaces)
  {
  }

  /// Calls visit(column, pick) for each pick of a surface.
  template <typename Visit>
  void ForEachPick(Visit&& visit) const
  {
    for (std::size_t column = 0; column + 1 < this->Picks.Starts.size(); ++column)
    {
      for (PointId pick = this->Picks.Starts[column]; pick < this->Picks.Starts[column + 1]; ++pick)
      {
        if (this->Surfaces[std::size_t(pick)] != NoPoint)
        {
          visit(std::int32_t(column), pick);
        }
      }
    }
  }

  /// Appends the surfaces of at least that many columns.
  void ListSizes(std::size_t sign, std::int64_t smallestSize, std::vector<SurfaceSize>& sizes) const
  {
    struct Extent
    {
      PointId First = NoPoint;
      PointId Columns = 0;
      std::int32_t LastColumn = -1;
    };
    std::vector<Extent> extents(this->Picks.Picks.size());
    this->ForEachPick(
      [&](std::int32_t column, PointId pick)
      {
        Extent& extent = extents[std::size_t(this->Surfaces[std::size_t(pick)])];
        extent.First = extent.First == NoPoint ? pick : extent.First;
        extent.Columns += extent.LastColumn == column ? 0 : 1;
        extent.LastColumn = column;
      });
    for (std::size_t surface = 0; surface < extents.size(); ++surface)
    {
      if (extents[surface].Columns >= smallestSize)
      {
        sizes.push_back({ sign, PointId(surface), extents[surface].First, extents[surface].Columns });
      }
    }
  }

  /// Fills the voxels of the surfaces of this sign; position[n] is the number of sizes[n] among all voxels.
  void Write(std::size_t sign, const std::vector<SurfaceSize>& sizes, std::vector<HorizonVoxels>& horizons) const
  {
    constexpr std::int32_t none = -1;
    std::vector<std::int32_t> positions(this->Picks.Picks.size(), none);
    for (std::size_t n = 0; n < sizes.size(); ++n)
    {
      if (sizes[n].Sign == sign)
      {
        positions[std::size_t(sizes[n].Surface)] = std::int32_t(n);
      }
    }
    this->ForEachPick(
      [&](std::int32_t column, PointId pick)
      {
        const std::int32_t position = positions[std::size_t(this->Surfaces[std::size_t(pick)])];
        if (position != none)
        {
          this->Add(horizons[std::size_t(position)], column, this->Picks[pick]);
        }
      });
  }

private:
  void Add(HorizonVoxels& horizon, std::int32_t column, const Reflection& pick) const
  {
    const int i = column % this->Picks.Columns[0];
    const int j = column / this->Picks.Columns[0];
    if (!horizon.I.empty() && horizon.I.back() == i && horizon.J.back() == j)
    {
      ++horizon.DroppedDuplicates;
      if (std::abs(pick.Amplitude) <= std::abs(horizon.Amplitude.back()))
      {
        return;
      }
      ForEachVoxelArray(horizon, [](auto& values) { values.pop_back(); });
    }
    horizon.I.push_back(i);
    horizon.J.push_back(j);
    horizon.K.push_back(NearestSample(pick.Place));
    horizon.Thickness.push_back(pick.Thickness);
    horizon.Amplitude.push_back(pick.Amplitude);
    horizon.RealZ.push_back(InSamples(pick.Place));
  }

  const ReflectionPicks& Picks;
  const RawVector<PointId>& Surfaces;
};
}

//----------------------------------------------------------------------------------------------------------------------
void WriteSurfaces(const std::array<ReflectionPicks, 2>& picks, const std::array<RawVector<PointId>, 2>& surfaces,
  std::int64_t smallestSize, std::int64_t largestNumber, Extraction& result)
{
  std::vector<SurfaceSize> sizes;
  for (const std::size_t sign : { 0, 1 })
  {
    SignWriter(picks[sign], surfaces[sign]).ListSizes(sign, smallestSize, sizes);
  }
  std::sort(sizes.begin(), sizes.end());
  result.NumberOfSurfaces = std::int64_t(sizes.size());
  sizes.resize(std::size_t(std::min(largestNumber, result.NumberOfSurfaces)));
  result.Surfaces.resize(sizes.size());
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    result.Surfaces[n].SurfaceId = int(n) + 1;
  }
  for (const std::size_t sign : { 0, 1 })
  {
    SignWriter(picks[sign], surfaces[sign]).Write(sign, sizes, result.Surfaces);
  }
}
}
