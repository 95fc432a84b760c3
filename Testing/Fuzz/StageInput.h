// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons and options of all stages out of the bytes of a fuzzer. Options can be out of range.

#ifndef SeismicHorizonsStageInput_h
#define SeismicHorizonsStageInput_h

#include "Boundary/ExteriorBoundary.h"
#include "BoundarySimplification/BoundarySimplification.h"
#include "CellSimplification/ElaborateSimplification.h"
#include "Decimation/Decimation.h"
#include "Surface/Surface.h"
#include "SurfaceDistance/SurfaceDistance.h"
#include "Tools/Patches.h"
#include "Triangulation/OutsideTriangles.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <memory>
#include <vector>

namespace Fuzz
{
class StageInput
{
public:
  StageInput(const std::uint8_t* data, std::size_t size)
    : Bytes(data, size)
  {
  }

  /// At least one column, no two the same, in any order.
  Patches::Columns TakeColumns();
  /// One finite height per column.
  std::vector<double> TakeHeights(const Patches::Columns& columns);
  /// Cut links in the box of the columns, along some lines or anywhere; mostly none.
  std::shared_ptr<const SeismicHorizons::LinkCuts> TakeCuts(const Patches::Columns& columns);
  SeismicHorizons::BoundaryOptions TakeBoundaryOptions();
  SeismicHorizons::BoundarySimplificationOptions TakeBoundarySimplificationOptions();
  SeismicHorizons::ElaborateOptions TakeCellOptions();
  SeismicHorizons::BoundaryLimits TakeBoundaryLimits();
  SeismicHorizons::DecimationOptions TakeDecimationOptions();
  SeismicHorizons::SurfaceOptions TakeSurfaceOptions();
  SeismicHorizons::SurfaceDistanceOptions TakeSurfaceDistanceOptions();
  bool TakeBool() { return this->Bytes.ConsumeBool(); }
  /// From 0 to below `bound`.
  int TakeBelow(int bound) { return this->Bytes.ConsumeIntegralInRange(0, bound - 1); }

private:
  Patches::Columns TakeBitmap();
  Patches::Columns TakeShape();
  Patches::Columns TakeScattered();
  Patches::Random TakeRandom() { return Patches::Random(this->Bytes.ConsumeIntegral<std::uint32_t>()); }
  double TakeHeight(int kind, const SeismicHorizons::PlanePoint& column, Patches::Random& random);
  /// A number from `low` to `high`, or one of those that are often forgotten.
  double TakeNumber(double low, double high);
  std::int64_t TakeSize();

  FuzzedDataProvider Bytes;
};
}

#endif
