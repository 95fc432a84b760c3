// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnPoints_h
#define SeismicHorizonsColumnPoints_h

#include "Common/LatticePlacement.h"
#include "Common/Parallel.h"
#include "DataArrays.h"

#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>

namespace SeismicHorizons
{
/// Points over the columns (i[n], j[n]) of a lattice, at the world z that elevation(n) gives, in double precision.
/// Arrays are vectors of any kind.
template <typename Indices, typename Elevation>
vtkSmartPointer<vtkPoints> MakeColumnPoints(
  const Indices& i, const Indices& j, const LatticeMatrix& toWorld, Elevation&& elevation)
{
  constexpr std::int64_t grain = 1 << 14; // points that a thread makes at a time
  auto coordinates = NewArray<vtkDoubleArray>("Points", static_cast<vtkIdType>(i.size()), 3);
  double* const world = coordinates->GetPointer(0);
  ParallelFor(static_cast<std::int64_t>(i.size()), grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto n = static_cast<std::size_t>(first); n < static_cast<std::size_t>(last); ++n)
      {
        world[3 * n] = toWorld[0] * i[n] + toWorld[1] * j[n] + toWorld[3];
        world[3 * n + 1] = toWorld[4] * i[n] + toWorld[5] * j[n] + toWorld[7];
        world[3 * n + 2] = elevation(n);
      }
    });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}
}

#endif
