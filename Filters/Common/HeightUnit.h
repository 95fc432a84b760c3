// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHeightUnit_h
#define SeismicHorizonsHeightUnit_h

#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/HeightNoise.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"

#include <optional>
#include <vector>

namespace SeismicHorizons
{
enum class HeightUnit
{
  Steps = 0, // of the vertical index
  World = 1, // z
  Diagonal = 2 // diagonal of the bounding box of all points, in lattice units
};

/// A maximum error of a mesh.
struct ErrorLimit
{
  double Indices = 0.0; // vertical indices
  std::optional<HeightNoise> Noise; // if the limit is automatic, six times this noise
};

/// Always positive; z per vertical index.
double WorldPerIndex(const Lattice& lattice);

/// The columns and heights of all points give the diagonal.
double IndicesPerUnit(HeightUnit unit, PlanePoints columns, const std::vector<double>& height, const Lattice& lattice);

double LengthOfDiagonal(const PlaneBox& columns, double leastHeight, double greatestHeight);

/// The noise is in vertical indices.
void WriteHeightNoise(const HeightNoise& noise, ArrayTable& figures);
}

#endif
