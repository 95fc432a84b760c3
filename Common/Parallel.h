// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops over several threads: the one place where the methods meet VTK. In the module they run on vtkSMPTools, so that
// its back-end and number of threads count; elsewhere on threads of their own.
//
// Work on one range must not read what work on another one writes. Then results are the same for any number of threads.

#ifndef SeismicHorizonsParallel_h
#define SeismicHorizonsParallel_h

#include "Monitor.h"

#ifdef SEISMICHORIZONS_USE_VTK_SMP
#include <vtkSMPTools.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace SeismicHorizons
{
namespace Detail
{
/// Keeps the first exception of a loop, in the order of its ranges: none may leave a thread.
class FirstException
{
public:
  template <typename Call>
  void Guard(std::int64_t range, Call&& call) noexcept
  {
    try
    {
      call();
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Pointer || range < this->Range)
      {
        this->Pointer = std::current_exception();
        this->Range = range;
      }
    }
  }

  void Rethrow() const
  {
    if (this->Pointer)
    {
      std::rethrow_exception(this->Pointer);
    }
  }

private:
  std::mutex Mutex;
  std::exception_ptr Pointer;
  std::int64_t Range = 0;
};

#ifndef SEISMICHORIZONS_USE_VTK_SMP
/// How many threads loops use where there is no vtkSMPTools.
inline int& NumberOfThreads()
{
  static int number = std::max(1, int(std::thread::hardware_concurrency()));
  return number;
}

template <typename Range>
void RunOnThreads(std::int64_t size, std::int64_t grain, Range&& range)
{
  std::atomic<std::int64_t> next(0);
  const auto run = [&]()
  {
    for (std::int64_t first = next.fetch_add(grain); first < size; first = next.fetch_add(grain))
    {
      range(first, std::min(size, first + grain));
    }
  };
  const std::int64_t ranges = (size + grain - 1) / grain;
  std::vector<std::thread> helpers;
  for (std::int64_t n = 1; n < std::min<std::int64_t>(ranges, NumberOfThreads()); ++n)
  {
    helpers.emplace_back(run);
  }
  run();
  for (std::thread& helper : helpers)
  {
    helper.join();
  }
}
#endif
}

/// Calls work(first, last) for ranges of at least about `grain` that cover 0 to `size`, in any order and at the same
/// time. Once all ranges are done with, an exception of the first range that threw one comes out of here: when each
/// range throws at its first wrong item, this is the first of all, whatever the ranges.
template <typename Work>
void ParallelFor(std::int64_t size, std::int64_t grain, Work&& work)
{
  Detail::FirstException exception;
  const auto range = [&](std::int64_t first, std::int64_t last) noexcept
  { exception.Guard(first, [&]() { work(first, last); }); };
#ifdef SEISMICHORIZONS_USE_VTK_SMP
  vtkSMPTools::For(0, vtkIdType(size), vtkIdType(grain), range);
#else
  Detail::RunOnThreads(size, grain, range);
#endif
  exception.Rethrow();
}

/// The same in a few batches, with a report to the monitor before each: callbacks run on the calling thread only.
template <typename Work>
void ParallelFor(std::int64_t size, std::int64_t grain, const Monitor& monitor, Work&& work)
{
  const std::int64_t batch = std::max(64 * grain, size / 16 + 1);
  for (std::int64_t done = 0; done < size; done += batch)
  {
    monitor.Progress(double(done) / double(size));
    ParallelFor(std::min(batch, size - done), grain,
      [&](std::int64_t first, std::int64_t last) { work(done + first, done + last); });
  }
}
}

#endif
