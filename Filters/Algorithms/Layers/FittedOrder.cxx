// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FittedOrder.h"

#include <cmath>
#include <cstdint>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void FittedOrder::Apply(const HeightMesh& mesh, std::vector<InnerHeights>& fitted) const
{
  const std::size_t first = mesh.NumberOfHorizons() - this->Heights.size(); // 1 with a level one before the stack
  std::vector<double> heights;
  std::vector<unsigned char> isOne;
  std::vector<std::size_t> known;
  const std::vector<VertexId>& vertices = fitted.front().Vertices;
  for (std::size_t n = 0; n < vertices.size(); ++n)
  {
    const PointId point = mesh.SourceOf(vertices[n]);
    heights.clear();
    isOne.clear();
    known.clear();
    for (std::size_t horizon = 0; horizon < this->Horizons; ++horizon)
    {
      if (!std::isnan(this->Heights[horizon][std::size_t(point)]))
      {
        heights.push_back(fitted[first + horizon].Heights[n]);
        isOne.push_back(horizon + 1 < this->Horizons && this->AreOne(horizon, point) ? 1 : 0);
        known.push_back(horizon);
      }
    }
    OrderColumn(heights, isOne, this->GrowDownwards);
    for (std::size_t horizon = 0, next = 0; horizon < this->Horizons; ++horizon)
    {
      next += next + 1 < known.size() && known[next + 1] == horizon ? 1 : 0; // absent ones get the height above
      fitted[first + horizon].Heights[n] = heights[next];
    }
    for (std::size_t layer = 0; this->Horizons + layer < this->Heights.size(); ++layer)
    {
      fitted[first + this->Horizons + layer].Heights[n] =
        fitted[first + layer].Heights[n] - fitted[first + layer + 1].Heights[n];
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool FittedOrder::AreOne(std::size_t layer, PointId point) const
{
  const auto thickness = [&](PointId at) {
    return this->Heights[layer][std::size_t(at)] - this->Heights[layer + 1][std::size_t(at)];
  }; // nan without the layer
  if (thickness(point) != 0.0 || this->IsOnLine[std::size_t(point)] != 0)
  {
    return thickness(point) == 0.0;
  }
  const std::int64_t place = this->Index.Place(this->Index.Columns()[std::size_t(point)]);
  for (std::int64_t row = place - this->Index.Width(); row <= place + this->Index.Width(); row += this->Index.Width())
  {
    for (std::int64_t neighbour = row - 1; neighbour <= row + 1; ++neighbour)
    {
      const PointId other = this->Index[neighbour];
      if (other != NoPoint && std::abs(thickness(other)) > 0.0)
      {
        return false;
      }
    }
  }
  return true;
}
}
