// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In the module loops run on vtkSMPTools, whose back-end and threads users choose (VTK/SMPToolsLoop.cxx); in programs
// without VTK on std::thread (ThreadLoop.cxx). A program links one of the two. Work on one range must not access data
// that another range writes, so that results do not depend on threads.
//
// Exceptions do not stop other ranges. So work that throws at the first wrong item of its range reports the first wrong
// item of all.

#ifndef SeismicHorizonsParallel_h
#define SeismicHorizonsParallel_h

#include "Monitor.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>

namespace SeismicHorizons
{
/// Items per task in loops with little work per item.
constexpr std::int64_t Grain = 16384;

namespace Detail
{
/// Keeps the exception of the lowest range, since one that leaves a thread ends the program.
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

void RunOnThreads(std::int64_t size, std::int64_t grain, const std::function<void(std::int64_t, std::int64_t)>& range);

/// Applies to programs without VTK.
int& NumberOfThreads();

/// The number of threads on which loops run.
int MostThreads();

/// Counts for the calling thread, in programs without VTK, for benchmarks: what more threads cannot share is the rest.
inline double& SecondsInLoops()
{
  thread_local double seconds = 0.0;
  return seconds;
}
}

/// Calls work(first, last) for ranges of about `grain` or more indices, which cover 0 to `size`, `last` excluded, in
/// any order and in parallel. Rethrows the exception of the lowest range after all ranges.
template <typename Work>
void ParallelFor(std::int64_t size, std::int64_t grain, Work&& work)
{
  Detail::FirstException exception;
  Detail::RunOnThreads(
    size, grain, [&](std::int64_t first, std::int64_t last) { exception.Guard(first, [&]() { work(first, last); }); });
  exception.Rethrow();
}

/// Runs at most 16 batches in sequence. The monitor is called on the calling thread, so that callbacks need not be
/// thread-safe.
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
