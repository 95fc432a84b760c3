// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTSurf_h
#define SeismicHorizonsTSurf_h

#include "Common/Horizon/Types.h"
#include "SurveyDescription.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
enum class VerticalPositive
{
  Elevation = 0, ///< z increases upwards.
  Depth = 1 ///< z increases downwards, also for time.
};

struct TSurfProperty
{
  std::string Name;
  std::string Unit;
  std::size_t Size = 1; // Numbers per vertex.
  std::vector<double> Values; // By vertex; nan for null values.
};

struct TSurf
{
  using Triangle = std::array<PointId, 3>;

  std::string Name;
  std::optional<std::array<double, 3>> Colour; // red, green and blue, 0 to 1
  VerticalPositive Positive = VerticalPositive::Elevation;
  bool HasPositive = false; // the file states ZPOSITIVE
  SurveyDescription Survey;
  std::vector<TSurfProperty> Properties;
  std::vector<std::array<double, 3>> Vertices; // z increases as Positive says.
  std::vector<Triangle> Triangles;
  std::vector<std::int32_t> Parts; // TFACE of each triangle, from 0; empty if there is one.
  std::vector<PointId> BorderStones; // Vertices that divide the border into sections.
  std::vector<std::array<PointId, 2>> Borders; // First two vertices of each section.
};
}

#endif
