// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCellWriter_h
#define SeismicHorizonsCellWriter_h

#include "Common/Horizon/Horizon.h"

#include <cstdint>

namespace SeismicHorizons
{
/// Places and cells of an output that is no horizon, such as lines.
class CellWriter
{
public:
  /// Returns the number of the point.
  std::int64_t AddPoint(const Eigen::Vector3d& place)
  {
    this->Places.append(place.data(), place.data() + 3);
    return this->NumberOfPoints() - 1;
  }
  std::int64_t NumberOfPoints() const { return std::int64_t(this->Places.size() / 3); }

  /// Adds to the cell that is not closed yet.
  void Use(std::int64_t point) { this->Points.push_back(point); }
  void Add(const Eigen::Vector3d& place) { this->Use(this->AddPoint(place)); }
  void Close() { this->Offsets.push_back(std::int64_t(this->Points.size())); }

  void Finish(Horizon& output, Cells Horizon::*kind)
  {
    output.Places = DataArray::Take(this->Places, 3);
    output.*kind = { DataArray::Take(this->Offsets), DataArray::Take(this->Points) };
  }

private:
  HeapArray<double> Places;
  HeapArray<std::int64_t> Points;
  HeapArray<std::int64_t> Offsets = { 0 };
};
}

#endif
