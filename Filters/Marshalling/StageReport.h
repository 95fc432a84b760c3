// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsStageReport_h
#define SeismicHorizonsStageReport_h

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
class Ranks;

class StageReport
{
public:
  /// `position` is HorizonLeaf::Position.
  void Add(int position, const std::string& name, vtkPolyData* input, vtkPolyData* output);

  /// Collects the entries of all ranks, sorted by position. Collective.
  void Join(const Ranks& ranks);

  /// One line per horizon, and per figure as panels are narrow: "3 horizons: 900 points in, 100 out", "Horizon 1: 300
  /// points in, 40 out" and so on. Only the first horizons are listed.
  std::string Text() const;

private:
  struct Entry
  {
    int Position;
    std::int64_t PointsIn;
    std::int64_t PointsOut;
    std::string Lines; // empty after the first horizons
  };
  std::vector<Entry> Entries;
};
}

#endif
