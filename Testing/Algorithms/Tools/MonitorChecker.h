// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of all long work: it says how far it has come, and stops whenever it is asked to.

#ifndef SeismicHorizonsMonitorChecker_h
#define SeismicHorizonsMonitorChecker_h

#include "Common/Base/Monitor.h"

#include <algorithm>
#include <string>

namespace MonitorChecker
{
using SeismicHorizons::Monitor;

/// Whether the work stops when its monitor says so at a call, counted from 0.
template <typename Work>
bool StopsAt(int call, Work&& work)
{
  int calls = 0;
  try
  {
    work(Monitor([&calls, call](double) { return calls++ < call; }));
  }
  catch (const SeismicHorizons::Aborted&)
  {
    return calls == call + 1;
  }
  return false;
}

/// Runs work(monitor) to its end, and then once for each of about 30 of its calls of the monitor, the first and the
/// last among them. Gives an empty text when the part done rises from 0 to 1 in at least `leastCalls` calls, and each
/// call can stop the work at once.
template <typename Work>
std::string Check(int leastCalls, Work&& work)
{
  int calls = 0;
  double last = 0.0;
  bool rises = true;
  work(Monitor(
    [&](double part)
    {
      ++calls;
      rises = rises && part >= last && part <= 1.0;
      last = part;
      return true;
    }));
  if (!rises || calls < leastCalls)
  {
    return std::to_string(calls) + " calls of the monitor" + (rises ? "" : ", not of a part that rises from 0 to 1");
  }
  const int step = std::max(1, calls / 30);
  for (int call = calls - 1; call >= 0; call = call == 0 ? -1 : std::max(0, call - step))
  {
    if (!StopsAt(call, work))
    {
      return "does not stop at call " + std::to_string(call) + " of the monitor";
    }
  }
  return {};
}
}

#endif
