// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SeamGaps.h"

#include "Common/Base/DisjointSets.h"
#include "Common/Horizon/PlaneGeometry.h"

#include <algorithm>
#include <string>

namespace SeismicHorizons
{
namespace
{
std::string ColumnText(const std::optional<std::int32_t>& row)
{
  return row ? std::to_string(*row) : std::string("none");
}

void CheckRows(PlanePoints columns, const SeamRows& seams)
{
  if (seams.Lower && seams.Upper && *seams.Lower >= *seams.Upper)
  {
    throw InputError("seams at row " + ColumnText(seams.Lower) + " and at row " + ColumnText(seams.Upper) +
      ", expected the lower one at a smaller row");
  }
  const auto beyond = std::find_if(columns.begin(), columns.end(),
    [&seams](const PlanePoint& column)
    { return (seams.Lower && column.Y < *seams.Lower) || (seams.Upper && column.Y > *seams.Upper); });
  if (beyond != columns.end())
  {
    throw InputError("point " + std::to_string(beyond - columns.begin()) + " in row " + std::to_string(beyond->Y) +
      ", expected none beyond the seams (lower: " + ColumnText(seams.Lower) + ", upper: " + ColumnText(seams.Upper) +
      ")");
  }
}

void Renumber(const std::vector<std::int32_t>& joined, PatchComponents& parts)
{
  std::vector<std::int32_t> number(joined.size());
  std::size_t count = 0;
  for (std::size_t part = 0; part < joined.size(); ++part)
  {
    const bool isFirst = joined[part] == std::int32_t(part);
    parts.First[count] = isFirst ? parts.First[part] : parts.First[count];
    number[part] = isFirst ? std::int32_t(count++) : number[joined[part]];
  }
  parts.First.resize(count);
  for (std::int32_t& component : parts.Component)
  {
    component = number[component];
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckSeams(PlanePoints columns, const BoundaryOptions& options)
{
  if (!HasSeams(options.Seams))
  {
    return;
  }
  if (!options.HoleBoundaries)
  {
    throw InputError("a seam without hole boundaries, expected them: a hole may continue beyond the seam");
  }
  if (options.MinimumPatchSize > 1)
  {
    throw InputError("a seam and a minimum patch size of " + std::to_string(options.MinimumPatchSize) +
      " points, expected 1: a patch may continue beyond the seam");
  }
  if (options.Growth == GrowthStrategy::Distance && options.Radius > 1)
  {
    throw InputError("a seam and growth by distance with a radius of " + std::to_string(options.Radius) +
      " columns, expected clockwise growth, or a radius of 1");
  }
  CheckRows(columns, options.Seams);
}

//----------------------------------------------------------------------------------------------------------------------
SeamPresence::SeamPresence(PlanePoints columns, const SeamRows& seams)
{
  const auto has = [&columns](const std::optional<std::int32_t>& row)
  {
    return row &&
      std::any_of(columns.begin(), columns.end(), [&row](const PlanePoint& column) { return column.Y == *row; });
  };
  this->AtLeastRow = has(seams.Lower);
  this->AtGreatestRow = has(seams.Upper);
}

//----------------------------------------------------------------------------------------------------------------------
SeamGaps::SeamGaps(
  PlanePoints columns, const ColumnIndex& index, const BoundaryOptions& options, const SeamPresence& seams)
{
  const PlaneBox box(columns);
  const auto fill = [&](Row& row, std::int32_t y)
  {
    row.First = index.Place({ box.Least.X, y });
    row.IsInGap.assign(std::size_t(std::int64_t(box.Greatest.X) - box.Least.X + 1), false);
    this->Fill(row, index, options);
  };
  if (seams.AtLeastRow)
  {
    fill(this->Rows[0], box.Least.Y);
  }
  if (seams.AtGreatestRow)
  {
    fill(this->Rows[1], box.Greatest.Y);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SeamGaps::Fill(Row& row, const ColumnIndex& index, const BoundaryOptions& options)
{
  std::int64_t last = -1;
  for (std::int64_t column = 0; column < std::int64_t(row.IsInGap.size()); ++column)
  {
    if (!index.Has(row.First + column))
    {
      continue;
    }
    const std::int64_t step = column - last;
    if (last >= 0 && step > options.Radius && step <= options.Seams.LongestEdge)
    {
      std::fill(row.IsInGap.begin() + last + 1, row.IsInGap.begin() + column, true);
      this->Sides.push_back({ row.First + last, row.First + column });
    }
    last = column;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SeamGaps::Join(const ColumnIndex& index, PatchComponents& parts) const
{
  if (this->Sides.empty())
  {
    return;
  }
  DisjointSets sets(parts.First.size());
  const auto component = [&](std::int64_t place) { return parts.Component[index[place]]; };
  for (const std::array<std::int64_t, 2>& sides : this->Sides)
  {
    sets.Join(component(sides[0]), component(sides[1]));
  }
  std::vector<std::int32_t> joined(parts.First.size());
  for (std::size_t part = 0; part < joined.size(); ++part)
  {
    joined[part] = sets.Find(std::int32_t(part));
  }
  Renumber(joined, parts);
}
}
