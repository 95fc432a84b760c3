// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerBoundary.h"

#include "Common/Base/DisjointSets.h"
#include "Common/Base/Errors.h"
#include "Common/Horizon/VolumeGrid.h"

#include <unordered_map>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<const char*, 4> OuterNames = { "Top", "Base", "Sides", "Faults" };
constexpr int Inside = OuterNames.size();

/// Three points that no other face has, the layer, the cell and the number of the face.
using CellFace = std::array<std::int64_t, 6>;

/// The kind, the first and the last horizon, the region, the other one, and the connected part.
using SurfaceKey = std::array<int, 6>;

/// Joins items whose values before them are equal. Gives the part of each item, from 0.
template <std::size_t Item, typename Value, std::size_t Size>
std::vector<int> FindParts(std::size_t count, const std::vector<std::array<Value, Size>>& sorted)
{
  DisjointSets sets(count);
  for (std::size_t n = 1; n < sorted.size(); ++n)
  {
    if (std::equal(sorted[n].begin(), sorted[n].begin() + Item, sorted[n - 1].begin()))
    {
      sets.Join(std::int32_t(sorted[n - 1][Item]), std::int32_t(sorted[n][Item]));
    }
  }
  std::vector<int> parts(count);
  int number = 0;
  for (std::size_t item = 0; item < count; ++item)
  {
    const auto first = std::size_t(sets.Find(std::int32_t(item)));
    parts[item] = first == item ? number++ : parts[first];
  }
  return parts;
}

class BoundaryFinder
{
public:
  explicit BoundaryFinder(const VolumeCells& cells)
    : Cells(cells)
  {
  }

  LayerBoundary Run(const Monitor& monitor)
  {
    this->FindFaces(monitor.Step(0.0, 0.5));
    this->Result.Regions = FindParts<4>(this->Cells.Size(), this->Faces);
    for (std::size_t n = 0, end = 0; n < this->Faces.size(); n = end)
    {
      for (end = n + 1;
           end < this->Faces.size() && std::equal(&this->Faces[n][0], &this->Faces[n][3], &this->Faces[end][0]);)
      {
        ++end;
      }
      this->AddFace(this->Faces[n], end - n);
    }
    monitor.Progress(0.8);
    this->FindSurfaces();
    monitor.Progress(1.0);
    return std::move(this->Result);
  }

private:
  BoundaryFace FaceOf(std::size_t cell, std::size_t number) const
  {
    BoundaryFace face = { {}, std::int64_t(cell), number };
    for (const std::size_t corner : FacesOfCell(this->Cells.SizeOf(cell))[number])
    {
      face.Points.push_back(this->Cells.Corners[std::size_t(this->Cells.FirstCorner(cell)) + corner]);
    }
    return face;
  }

  void FindFaces(const Monitor& monitor)
  {
    ForEach(this->Cells.Size(), monitor,
      [this](std::size_t cell)
      {
        const int layer = this->Cells.Layers[cell];
        for (std::size_t number = 0; number < FacesOfCell(this->Cells.SizeOf(cell)).size(); ++number)
        {
          std::vector<std::int64_t> points = this->FaceOf(cell, number).Points;
          std::sort(points.begin(), points.end());
          this->Faces.push_back({ points[0], points[1], points[2], layer, std::int64_t(cell), std::int64_t(number) });
        }
        auto& [least, largest] = this->Extents.try_emplace(this->Cells.Triangles[cell], layer, layer).first->second;
        least = std::min(least, layer);
        largest = std::max(largest, layer);
      });
    std::sort(this->Faces.begin(), this->Faces.end());
  }

  /// `count` cells have the face; the second one is next.
  void AddFace(const CellFace& own, std::size_t count)
  {
    const int layer = int(own[3]);
    const auto cell = std::size_t(own[4]);
    const BoundaryFace face = this->FaceOf(cell, std::size_t(own[5]));
    SurfaceKey key = { Inside, layer + 1, layer + 1, this->Result.Regions[cell], -1, 0 };
    if (count > 2)
    {
      throw InputError("a face of " + std::to_string(count) + " cells, such as " + std::to_string(cell) +
        ", expected layers as Horizon Layers makes them");
    }
    if (count == 2)
    {
      const CellFace& other = *(&own + 1);
      key[2] = int(other[3]);
      key[4] = this->Result.Regions[std::size_t(other[4])];
    }
    else
    {
      const auto [least, largest] = this->Extents.at(this->Cells.Triangles[cell]);
      const double area = this->AreaOnMap(face);
      const bool isFault = (this->Cells.FaultFaces[cell] >> face.Number & 1) != 0;
      const bool isEnd = area > 0.0 ? layer == least : layer == largest;
      key[0] = area == 0.0 ? (isFault ? 3 : 2) : !isEnd ? Inside : area > 0.0 ? 0 : 1;
      key[1] = key[2] = key[0] < Inside ? 0 : area > 0.0 ? layer : layer + 1;
    }
    if (key[1] <= key[2]) // Otherwise both cells are of one layer.
    {
      this->Found.emplace_back(key, face);
    }
  }

  /// Exactly 0 if the face is vertical, as two of any three points are above each other; positive for a top.
  double AreaOnMap(const BoundaryFace& face) const
  {
    const auto at = [&](std::size_t n) { return this->Cells.Points[std::size_t(face.Points[n])]; };
    return (at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) - (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]);
  }

  void FindSurfaces()
  {
    std::vector<std::array<std::int64_t, 8>> edges; // the key, both ends, and the face
    for (std::size_t face = 0; face < this->Found.size(); ++face)
    {
      const auto& [key, own] = this->Found[face];
      for (std::size_t n = 0; n < own.Points.size(); ++n)
      {
        const auto [a, b] = std::minmax({ own.Points[n], own.Points[(n + 1) % own.Points.size()] });
        edges.push_back({ key[0], key[1], key[2], key[3], key[4], a, b, std::int64_t(face) });
      }
    }
    std::sort(edges.begin(), edges.end());
    const std::vector<int> parts = FindParts<7>(this->Found.size(), edges);
    for (std::size_t face = 0; face < this->Found.size(); ++face)
    {
      this->Found[face].first[5] = parts[face];
    }
    std::stable_sort(
      this->Found.begin(), this->Found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    SurfaceKey last = { -1, 0, 0, 0, 0, 0 };
    for (auto& [key, face] : this->Found)
    {
      if (!std::equal(key.begin(), key.begin() + 3, last.begin()))
      {
        this->AddNames(key);
      }
      if (key != last)
      {
        this->Result.Surfaces.push_back({ this->Result.Names.size() - 1, key[3], key[4], {} });
      }
      last = key;
      this->Result.Surfaces.back().Faces.push_back(std::move(face));
    }
  }

  void AddNames(const SurfaceKey& key)
  {
    std::vector<std::string>& names = this->Result.Names;
    if (key[0] < Inside)
    {
      names.emplace_back(OuterNames[std::size_t(key[0])]);
      this->Result.PlainNames.push_back(names.back());
      return;
    }
    const std::string numbers = std::to_string(key[1] + 1) + (key[1] < key[2] ? "_" + std::to_string(key[2] + 1) : "");
    std::string name;
    for (auto horizon = std::size_t(key[1]); horizon <= std::size_t(key[2]); ++horizon)
    {
      name += (name.empty() ? "" : ", ") + (horizon < this->Cells.Horizons.size() ? this->Cells.Horizons[horizon] : "");
    }
    const bool isTaken = name.empty() || std::find(names.begin(), names.end(), name) != names.end();
    this->Result.PlainNames.push_back("H" + numbers + "_" + PlainName(name));
    names.push_back(isTaken ? "Horizon " + numbers : name);
  }

  const VolumeCells& Cells;
  std::vector<CellFace> Faces;
  std::unordered_map<std::int64_t, std::pair<int, int>> Extents; // uppermost and lowest layer by triangle
  std::vector<std::pair<SurfaceKey, BoundaryFace>> Found;
  LayerBoundary Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
LayerBoundary FindBoundary(const VolumeCells& cells, const Monitor& monitor)
{
  return BoundaryFinder(cells).Run(monitor);
}

//----------------------------------------------------------------------------------------------------------------------
std::string PlainName(const std::string& name)
{
  constexpr std::size_t longest = 60;
  std::string plain = name.substr(0, longest);
  std::replace_if(
    plain.begin(), plain.end(),
    [](char c) { return static_cast<unsigned char>(c) >= 0x80 || !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return plain;
}
}
