// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs long work on several threads at once, each of which may run loops (Parallel.h), so that what loops cannot share
// overlaps with other work.

#ifndef SeismicHorizonsSideBySide_h
#define SeismicHorizonsSideBySide_h

#include "Monitor.h"

#include <cstdint>
#include <functional>

namespace SeismicHorizons
{
/// Calls work(n, monitor) for all numbers below `size`, `most` of them at once. Rethrows the exception of the lowest
/// number after all work. The callback of the monitor is called on the calling thread.
void RunSideBySide(std::int64_t size, std::int64_t most, const Monitor& monitor,
  const std::function<void(std::int64_t, const Monitor&)>& work);
}

#endif
