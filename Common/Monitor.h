// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The one way in which long loops report progress and learn that they should stop.

#ifndef SeismicHorizonsMonitor_h
#define SeismicHorizonsMonitor_h

#include "Errors.h"

#include <functional>
#include <utility>

namespace SeismicHorizons
{
class Monitor
{
public:
  /// Takes the part done, 0 to 1, and returns false to stop the work.
  using Callback = std::function<bool(double)>;

  Monitor() = default;
  explicit Monitor(Callback callback)
    : Report(std::move(callback))
  {
  }

  /// Reports the part done, 0 to 1. Throws Aborted when the callback asks to stop.
  void Progress(double part) const
  {
    if (this->Report && !this->Report(this->First + part * (this->Last - this->First)))
    {
      throw Aborted();
    }
  }

  /// A monitor for a step that takes the work from `first` to `last`, both 0 to 1.
  Monitor Step(double first, double last) const
  {
    Monitor step(*this);
    step.First = this->First + first * (this->Last - this->First);
    step.Last = this->First + last * (this->Last - this->First);
    return step;
  }

private:
  Callback Report;
  double First = 0.0;
  double Last = 1.0;
};
}

#endif
