// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops over several threads. In the module they run on vtkSMPTools, whose back-end and number of threads users choose;
// in programs without VTK on std::thread. No other file of the algorithms includes VTK.
//
// Work on one range must neither read nor write what work on another range writes. Then results are the same for any
// number of threads.

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
/// Catches the exceptions of a loop, as one that leaves a thread ends the program, and keeps that of the range with the
/// least first index.
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

/// Calls work(first, last) for ranges of indices, `last` not included, that together are 0 to `size`: in any order, and
/// several at a time. A range has about `grain` indices or more, so that starting it takes little of the time.
///
/// An exception of the work does not stop the other ranges. After the last of them the one of the lowest range is
/// thrown again. So work that throws at the first wrong item of its range gives the error of the first wrong item of
/// all, for any number of threads.
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

/// The same in at most 16 batches, one after the other. Before each of them the monitor is called, on the calling
/// thread: callbacks need not be safe to call from several threads.
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
