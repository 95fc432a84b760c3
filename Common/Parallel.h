// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops over several threads. In the module they run on vtkSMPTools, whose back-end and number of threads users choose
// (VTK/SMPToolsLoop.cxx); in programs without VTK on std::thread (ThreadLoop.cxx). A program links one of the two.
//
// Work on one range must neither read nor write what work on another range writes. Then results are the same for any
// number of threads.

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

/// Calls range(first, last) for ranges that together are 0 to `size`.
void RunOnThreads(std::int64_t size, std::int64_t grain, const std::function<void(std::int64_t, std::int64_t)>& range);

/// How many threads loops of programs without VTK use.
int& NumberOfThreads();
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
  Detail::RunOnThreads(
    size, grain, [&](std::int64_t first, std::int64_t last) { exception.Guard(first, [&]() { work(first, last); }); });
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
