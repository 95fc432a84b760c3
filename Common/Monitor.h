// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far long work has come, and whether it has to stop.

#ifndef SeismicHorizonsMonitor_h
#define SeismicHorizonsMonitor_h

#include "Errors.h"

#include <functional>
#include <utility>

namespace SeismicHorizons
{
/// Algorithms take a monitor, and call Progress in their long loops. One without a callback does nothing.
class Monitor
{
public:
  /// Takes the part done, 0 to 1, and returns false to stop the work.
  using Callback = std::function<bool(double)>;

  Monitor() = default;
  /// One that tells `callback`.
  explicit Monitor(Callback callback)
    : Report(std::move(callback))
  {
  }

  /// Passes the part done, 0 to 1, to the callback. Throws Aborted when that returns false.
  void Progress(double part) const
  {
    if (this->Report && !this->Report(this->First + part * (this->Last - this->First)))
    {
      throw Aborted();
    }
  }

  /// A monitor for one step of the work: 0 to 1 of the step is `first` to `last` of the whole.
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
