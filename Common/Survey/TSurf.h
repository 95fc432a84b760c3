// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTSurf_h
#define SeismicHorizonsTSurf_h

#include "Common/Types.h"
#include "SurveyDescription.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Where z of a GOCAD object grows to, its ZPOSITIVE.
enum class VerticalPositive
{
  Elevation = 0, ///< upwards
  Depth = 1 ///< downwards, also for time
};

/// Numbers that belong to the vertices of a TSurf.
struct TSurfProperty
{
  std::string Name;
  std::string Unit; // empty where none is stated
  std::size_t Size = 1; // numbers for each vertex
  std::vector<double> Values; // vertex after vertex; nan where there is none
};

/// A triangulated surface as GOCAD has it.
struct TSurf
{
  using Triangle = std::array<PointId, 3>;

  std::string Name; // empty where there is none
  std::optional<std::array<double, 3>> Colour; // red, green, blue from 0 to 1
  VerticalPositive Positive = VerticalPositive::Elevation;
  SurveyDescription Survey;
  std::vector<TSurfProperty> Properties;
  std::vector<std::array<double, 3>> Vertices; // z grows as Positive says
  std::vector<Triangle> Triangles;
  std::vector<std::int32_t> Parts; // of each triangle the number of its TFACE, from 0; empty where there is one
  std::vector<PointId> BorderStones; // vertices that part the border into sections
  std::vector<std::array<PointId, 2>> Borders; // of each section its first two vertices
};
}

#endif
