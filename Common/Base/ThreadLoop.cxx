// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parallel.h"

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace SeismicHorizons
{
namespace Detail
{
//----------------------------------------------------------------------------------------------------------------------
int& NumberOfThreads()
{
  static int number = std::max(1, int(std::thread::hardware_concurrency()));
  return number;
}

//----------------------------------------------------------------------------------------------------------------------
double& SecondsInLoops()
{
  thread_local double seconds = 0.0;
  return seconds;
}

namespace
{
/// Loops inside loops do not count again.
class LoopClock
{
public:
  LoopClock() { ++Depth; }
  LoopClock(const LoopClock&) = delete;
  LoopClock& operator=(const LoopClock&) = delete;
  ~LoopClock()
  {
    if (--Depth == 0)
    {
      SecondsInLoops() += std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
    }
  }

private:
  inline static thread_local int Depth = 0;
  const std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
}

//----------------------------------------------------------------------------------------------------------------------
void RunOnThreads(std::int64_t size, std::int64_t grain, const std::function<void(std::int64_t, std::int64_t)>& range)
{
  const LoopClock clock;
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
}
}
