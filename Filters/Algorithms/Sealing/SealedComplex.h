// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles between places that differ: each has a label on both sides. Around an edge, what faces each other has the
// same label, so that bodies are closed.

#ifndef SeismicHorizonsSealedComplex_h
#define SeismicHorizonsSealedComplex_h

#include "Arrangement.h"
#include "Common/Base/Monitor.h"
#include "Sheets.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
using SealedLabel = std::int32_t;
constexpr SealedLabel OutsideLabel = -1;
constexpr double DegreesPerRadian = 57.29577951308232;

struct LabelledTriangle
{
  SheetCorners Corners;
  std::int32_t Sheet;
  std::array<SealedLabel, 2> Labels; // before and behind; the same where a fault dies out in a body
  bool IsBeyondTips = false; // of its fault
};

struct SealedComplex
{
  std::vector<Eigen::Vector3d> Vertices;
  std::vector<LabelledTriangle> Triangles;
};

/// The label just before a place of a sheet (side 0), or behind.
using LabelFinder = std::function<SealedLabel(const Eigen::Vector3d& place, std::int32_t sheet, int side)>;

/// Keeps the triangles whose sides differ. Parts of a sheet between lines are alike, so that one place is enough.
SealedComplex KeepDifferent(Arrangement arrangement, const LabelFinder& labelAt, const Monitor& monitor = Monitor());

/// Drops vertices without a triangle.
void DropUnused(SealedComplex& complex);

inline Eigen::Vector3d CentreOf(const std::vector<Eigen::Vector3d>& vertices, const SheetCorners& corners)
{
  const auto& [a, b, c] = corners;
  return (vertices[std::size_t(a)] + vertices[std::size_t(b)] + vertices[std::size_t(c)]) / 3.0;
}

/// Bodies by triangle and side, -1 outside.
struct ComplexBodies
{
  std::vector<std::array<std::int32_t, 2>> OfTriangles;
  std::vector<SealedLabel> Labels;
  std::vector<double> Volumes;
  double LeastAngle = 180.0; // between triangles at an edge, in degrees
};

/// Throws InputError with the place where bodies are not closed.
ComplexBodies FindBodies(const SealedComplex& complex);
}

#endif
