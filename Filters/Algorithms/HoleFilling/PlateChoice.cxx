// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlateChoice.h"

#include <cmath>
#include <cstdint>

namespace SeismicHorizons
{
namespace
{
constexpr PlateChoice Exact = { 0.0, 3 };
constexpr PlateChoice Little = { 1.0, 3 };
constexpr PlateChoice Much = { 32.0, WidestChosenRim };

// Utilities/Studies/hole_filling.py determined these ratios of the mean squares at l = 2 and l = 1.
constexpr double SmoothRatio = 2.4;
constexpr double NoisyRatio = 1.4;
// Rounding to integers adds a variance of 1 / 12 at each of four corners.
constexpr double RoundingSquare = 4.0 / 12.0;

class TwistSums
{
public:
  TwistSums(
    const ColumnIndex& index, const RasterFrame& frame, const std::vector<double>& heights, const LinkCuts* cuts)
    : Index(index)
    , Frame(frame)
    , Heights(heights)
    , Cuts(cuts)
  {
  }

  void Add(std::int64_t place)
  {
    if (!this->Index.Has(place))
    {
      return;
    }
    const double height = this->Heights[this->Index[place]];
    this->AreWhole = this->AreWhole && height == std::round(height);
    for (const std::int64_t side : { 1, 2 })
    {
      const std::int64_t above = place + side * this->Index.Width();
      if (this->Index.Has(place + side) && this->Index.Has(above) && this->Index.Has(above + side) &&
        this->IsWhole(place, side))
      {
        const double twist = height - this->Heights[this->Index[place + side]] - this->Heights[this->Index[above]] +
          this->Heights[this->Index[above + side]];
        this->Sum[side - 1] += twist * twist;
        ++this->Count[side - 1];
      }
    }
  }

  PlateChoice Choose() const
  {
    if (this->Count[0] == 0 || this->Count[1] == 0)
    {
      return Little;
    }
    const double small = this->Sum[0] / double(this->Count[0]);
    const double large = this->Sum[1] / double(this->Count[1]);
    if (this->AreWhole && small > 0.0 && small <= RoundingSquare)
    {
      return Much;
    }
    return large >= SmoothRatio * small ? Exact : large <= NoisyRatio * small ? Much : Little;
  }

private:
  bool IsWhole(std::int64_t place, std::int64_t side) const
  {
    bool isWhole = true;
    for (std::int64_t n = 0; this->Cuts && isWhole && n < (side + 1) * (side + 1); ++n)
    {
      const std::int64_t x = n % (side + 1);
      const std::int64_t y = n / (side + 1);
      const PlanePoint column = this->Frame.Column(place + y * this->Index.Width() + x);
      isWhole = !(x < side && this->Cuts->IsCutEast(column)) && !(y < side && this->Cuts->IsCutNorth(column));
    }
    return isWhole;
  }

  const ColumnIndex& Index;
  const RasterFrame& Frame;
  const std::vector<double>& Heights;
  const LinkCuts* const Cuts;
  double Sum[2] = { 0.0, 0.0 }; // for l = 1 and 2
  std::int64_t Count[2] = { 0, 0 };
  bool AreWhole = true;
};
}

//----------------------------------------------------------------------------------------------------------------------
PlateChoice ChoosePlate(
  const ColumnIndex& index, const RasterFrame& frame, const std::vector<double>& heights, const LinkCuts* cuts)
{
  constexpr std::int64_t enough = 250000;
  // Sampled rows are spread by the golden ratio, as noise may repeat with the rows.
  constexpr double golden = 0.6180339887498949;
  const std::int64_t width = index.Width();
  const std::int64_t rows = index.Height() - 2; // A square of size 2 reaches two rows further.
  const std::int64_t step = width * index.Height() / enough + 1;
  TwistSums twists(index, frame, heights, cuts);
  double part = 0.0;
  for (std::int64_t first = 0; first < rows; first += step)
  {
    part = part + golden < 1.0 ? part + golden : part + golden - 1.0;
    const std::int64_t row = first + std::int64_t(part * double(step));
    for (std::int64_t x = 0; x < width - 2 && row < rows; ++x)
    {
      twists.Add(row * width + x);
    }
  }
  return twists.Choose();
}
}
