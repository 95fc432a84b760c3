// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a stage made of its horizons, as a text to read.

#ifndef SeismicHorizonsStageReport_h
#define SeismicHorizonsStageReport_h

#include <cstdint>
#include <string>

class vtkPolyData;

namespace SeismicHorizons
{
class StageReport
{
public:
  /// Adds a horizon with the figures that the stage put into its field data.
  void Add(const std::string& name, vtkPolyData* input, vtkPolyData* output);

  /// "3 horizons: 900 points in, 100 out", and below it "Horizon 1: 300 points in, 40 out" and so on, each with its
  /// figures on lines of their own, as panels are narrow. Of many horizons the first ones. Empty without any.
  std::string Text() const;

private:
  std::int64_t Horizons = 0;
  std::int64_t PointsIn = 0;
  std::int64_t PointsOut = 0;
  std::string Lines;
};
}

#endif
