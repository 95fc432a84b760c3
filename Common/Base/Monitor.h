// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsMonitor_h
#define SeismicHorizonsMonitor_h

#include "Errors.h"

#include <functional>
#include <utility>

namespace SeismicHorizons
{
/// Algorithms call Progress in long loops.
class Monitor
{
public:
  /// Takes the progress, from 0 to 1; returns false to stop the work.
  using Callback = std::function<bool(double)>;

  /// Ignores progress.
  Monitor() = default;
  /// Reports to a callback.
  explicit Monitor(Callback callback)
    : Report(std::move(callback))
  {
  }

  /// `part` is from 0 to 1. Throws Aborted if the callback returns false.
  void Progress(double part) const
  {
    if (this->Report && !this->Report(this->First + part * (this->Last - this->First)))
    {
      throw Aborted();
    }
  }

  /// Maps the progress of a step to `first` to `last` of the whole.
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
