// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a stage made of its horizons, as a text to read.

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
  /// Adds a horizon with the figures that the stage put into its field data. `position` is as in HorizonLeaf.
  void Add(int position, const std::string& name, vtkPolyData* input, vtkPolyData* output);

  /// Makes this that of the horizons of all ranks, by their positions. Collective.
  void Join(const Ranks& ranks);

  /// "3 horizons: 900 points in, 100 out", and below it "Horizon 1: 300 points in, 40 out" and so on, each with its
  /// figures on lines of their own, as panels are narrow. Of many horizons the first ones. Empty without any.
  std::string Text() const;

private:
  struct Entry
  {
    int Position;
    std::int64_t PointsIn;
    std::int64_t PointsOut;
    std::string Lines; // empty behind the first horizons
  };
  std::vector<Entry> Entries;
};
}

#endif
