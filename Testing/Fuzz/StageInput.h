// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons and options of all stages out of the bytes of a fuzzer. Options can be out of range.

#ifndef SeismicHorizonsStageInput_h
#define SeismicHorizonsStageInput_h

#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace Fuzz
{
/// Bytes that a fuzzer made up: contents are taken from the front, numbers from the back, so that a number more or less
/// leaves the contents as they are. Where bytes are used up, they are 0.
class ByteSource
{
public:
  ByteSource(const std::uint8_t* data, std::size_t size)
    : First(data)
    , End(data + size)
  {
  }

  std::vector<unsigned char> TakeContents(std::size_t size)
  {
    std::vector<unsigned char> contents(
      this->First, this->First + std::min(size, std::size_t(this->End - this->First)));
    this->First += contents.size();
    return contents;
  }

  /// From 0 to `last`, of as many bytes as that takes.
  std::uint64_t TakeNumber(std::uint64_t last)
  {
    std::uint64_t number = 0;
    for (std::uint64_t left = last; left > 0 && this->First != this->End; left >>= 8U)
    {
      number = number << 8U | *--this->End;
    }
    return last == std::numeric_limits<std::uint64_t>::max() ? number : number % (last + 1);
  }

  /// From 0 to 1.
  double TakeFraction()
  {
    constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
    return double(this->TakeNumber(all)) / double(all);
  }

private:
  const std::uint8_t* First;
  const std::uint8_t* End;
};

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
  /// Faulted links in the box of the columns, along some lines or anywhere; mostly none.
  std::shared_ptr<const SeismicHorizons::LinkCuts> TakeCuts(const Patches::Columns& columns);
  SeismicHorizons::BoundaryOptions TakeBoundaryOptions();
  SeismicHorizons::BoundarySimplificationOptions TakeBoundarySimplificationOptions();
  SeismicHorizons::ElaborateOptions TakeCellOptions();
  SeismicHorizons::BoundaryLimits TakeBoundaryLimits();
  SeismicHorizons::DecimationOptions TakeDecimationOptions();
  SeismicHorizons::SurfaceOptions TakeSurfaceOptions();
  SeismicHorizons::SurfaceDistanceOptions TakeSurfaceDistanceOptions();
  bool TakeBool() { return this->Bytes.TakeNumber(255) % 2 == 1; }
  /// From 0 to below `bound`.
  int TakeBelow(int bound) { return int(this->Bytes.TakeNumber(std::uint64_t(bound) - 1)); }

private:
  Patches::Columns TakeBitmap();
  Patches::Columns TakeShape();
  Patches::Columns TakeScattered();
  Patches::Random TakeRandom()
  {
    return Patches::Random(std::uint32_t(this->Bytes.TakeNumber(std::numeric_limits<std::uint32_t>::max())));
  }
  double TakeHeight(int kind, const SeismicHorizons::PlanePoint& column, Patches::Random& random);
  /// A number from `low` to `high`, or one of those that are often forgotten.
  double TakeNumber(double low, double high);
  std::int64_t TakeSize();

  ByteSource Bytes;
};
}

#endif
