// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of a segment near a box of columns. Given lines may lie anywhere, and the time they take must not depend on
// where. Halves of steps are counted with, as the difference of large numbers may be none.

#ifndef SeismicHorizonsSegmentClip_h
#define SeismicHorizonsSegmentClip_h

#include "FaultPolylines.h"
#include "LinkGrid.h"

#include <algorithm>

namespace SeismicHorizons
{
/// Of a segment, whose places count from the least column of the box.
class SegmentClip
{
public:
  /// Up to two columns outside, so that rounding leaves what is inside as it is.
  SegmentClip(const LinkGrid& box, const MapPlace& from, const MapPlace& to)
    : Start(from)
    , End(to)
  {
    const Axis alongX(from.X, to.X, double(box.Width()));
    const Axis alongY(from.Y, to.Y, double(box.Height()));
    this->FirstPart = std::max({ 0.0, alongX.In, alongY.In });
    this->LastPart = std::min({ 1.0, alongX.Out, alongY.Out });
    if (this->FirstPart > 0.0)
    {
      this->Start = { alongX.First(this->FirstPart), alongY.First(this->FirstPart) };
    }
    if (this->LastPart < 1.0)
    {
      this->End = { alongX.Last(this->LastPart), alongY.Last(this->LastPart) };
    }
  }

  /// Nothing of the segment is near the box.
  bool IsEmpty() const { return this->FirstPart > this->LastPart; }

  /// The ends of the part, and which parts of the segment they are, from 0 to 1.
  const MapPlace& From() const { return this->Start; }
  const MapPlace& To() const { return this->End; }
  double First() const { return this->FirstPart; }
  double Last() const { return this->LastPart; }

private:
  /// The coordinates of a segment along an axis.
  struct Axis
  {
    static constexpr double Margin = 2.0;

    Axis(double from, double to, double end)
      : From(from)
      , Half(0.5 * to - 0.5 * from)
      , Least(-Margin)
      , Greatest(end + Margin)
    {
      if (this->Half != 0.0)
      {
        const double low = 0.5 * ((this->Least - from) / this->Half);
        const double high = 0.5 * ((this->Greatest - from) / this->Half);
        this->In = std::min(low, high);
        this->Out = std::max(low, high);
      }
      else if (from < this->Least || from > this->Greatest)
      {
        this->Out = -1.0;
      }
    }

    /// The coordinates at the parts where the segment is near the box first and last: where it crosses a side of this
    /// axis there, that of the side, as from very far away coordinates are rounded to more than the box.
    double First(double part) const
    {
      return part == this->In ? (this->Half > 0.0 ? this->Least : this->Greatest) : this->At(part);
    }

    double Last(double part) const
    {
      return part == this->Out ? (this->Half > 0.0 ? this->Greatest : this->Least) : this->At(part);
    }

    double At(double part) const
    {
      return std::clamp(this->From + part * this->Half + part * this->Half, this->Least, this->Greatest);
    }

    const double From;
    const double Half;
    const double Least;
    const double Greatest;
    double In = -1.0; // the parts at which it crosses the sides
    double Out = 2.0;
  };

  MapPlace Start;
  MapPlace End;
  double FirstPart = 0.0;
  double LastPart = 1.0;
};
}

#endif
