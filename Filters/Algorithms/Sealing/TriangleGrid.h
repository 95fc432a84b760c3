// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boxes of any sizes in cells of about their size, so that they can be found, added and removed.

#ifndef SeismicHorizonsTriangleGrid_h
#define SeismicHorizonsTriangleGrid_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
class TriangleGrid
{
public:
  explicit TriangleGrid(double smallest)
    : Smallest(smallest)
  {
  }

  void Add(std::int32_t triangle, const Eigen::AlignedBox3d& box)
  {
    const std::size_t level = this->LevelOf(box);
    if (level >= this->Levels.size())
    {
      this->Levels.resize(level + 1);
    }
    this->Levels[level][this->KeyOf(this->CellOf(box.center(), level))].push_back({ triangle, box });
  }

  void Remove(std::int32_t triangle, const Eigen::AlignedBox3d& box)
  {
    const std::size_t level = this->LevelOf(box);
    std::vector<Entry>& cell = this->Levels[level][this->KeyOf(this->CellOf(box.center(), level))];
    const auto found =
      std::find_if(cell.begin(), cell.end(), [triangle](const Entry& entry) { return entry.Triangle == triangle; });
    *found = cell.back();
    cell.pop_back();
  }

  /// Whether test(triangle) is true for one whose box meets the box.
  template <typename Test>
  bool Any(const Eigen::AlignedBox3d& box, Test&& test) const
  {
    const auto isHit = [&](const std::vector<Entry>& cell)
    {
      return std::any_of(cell.begin(), cell.end(),
        [&](const Entry& entry) { return entry.Box.intersects(box) && test(entry.Triangle); });
    };
    for (std::size_t level = 0; level < this->Levels.size(); ++level)
    {
      // Centres are at most half a cell beyond the box.
      const Eigen::Vector3d beyond = Eigen::Vector3d::Constant(0.5 * this->SizeOf(level));
      const Cell from = this->CellOf(box.min() - beyond, level), to = this->CellOf(box.max() + beyond, level);
      const double cells =
        double(to.x() - from.x() + 1) * double(to.y() - from.y() + 1) * double(to.z() - from.z() + 1);
      if (cells > double(this->Levels[level].size()))
      {
        for (const auto& [key, cell] : this->Levels[level])
        {
          if (isHit(cell))
          {
            return true;
          }
        }
        continue;
      }
      for (std::int64_t z = from.z(); z <= to.z(); ++z)
      {
        for (std::int64_t y = from.y(); y <= to.y(); ++y)
        {
          for (std::int64_t x = from.x(); x <= to.x(); ++x)
          {
            const auto cell = this->Levels[level].find(this->KeyOf({ x, y, z }));
            if (cell != this->Levels[level].end() && isHit(cell->second))
            {
              return true;
            }
          }
        }
      }
    }
    return false;
  }

private:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

  struct Entry
  {
    std::int32_t Triangle;
    Eigen::AlignedBox3d Box;
  };

  double SizeOf(std::size_t level) const { return this->Smallest * std::exp2(double(level)); }
  std::size_t LevelOf(const Eigen::AlignedBox3d& box) const
  {
    return std::size_t(std::max(0.0, std::ceil(std::log2(box.sizes().maxCoeff() / this->Smallest))));
  }
  Cell CellOf(const Eigen::Vector3d& place, std::size_t level) const
  {
    return (place / this->SizeOf(level)).array().floor().cast<std::int64_t>();
  }
  static std::uint64_t KeyOf(const Cell& cell)
  {
    constexpr std::uint64_t bits = (1U << 21U) - 1U;
    return (std::uint64_t(cell.x()) & bits) << 42U | (std::uint64_t(cell.y()) & bits) << 21U |
      (std::uint64_t(cell.z()) & bits);
  }

  double Smallest;
  std::vector<std::unordered_map<std::uint64_t, std::vector<Entry>>> Levels; // by size of boxes
};
}

#endif
