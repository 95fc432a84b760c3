// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SideBySide.h"

#include "Parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <future>
#include <numeric>
#include <vector>

namespace SeismicHorizons
{
namespace
{
using Work = std::function<void(std::int64_t, const Monitor&)>;

void RunInTurn(std::int64_t size, const Monitor& monitor, const Work& work)
{
  double& inLoops = Detail::SecondsInLoops();
  double outside = 0.0;
  double mostOutside = 0.0;
  for (std::int64_t n = 0; n < size; ++n)
  {
    const auto start = std::chrono::steady_clock::now();
    const double own = inLoops;
    work(n, monitor.Step(double(n) / double(size), double(n + 1) / double(size)));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const double left = std::max(0.0, seconds.count() - (inLoops - own));
    outside += left;
    mostOutside = std::max(mostOutside, left);
  }
  inLoops += outside - mostOutside; // More threads share all but the longest.
}
}

//----------------------------------------------------------------------------------------------------------------------
void RunSideBySide(std::int64_t size, std::int64_t most, const Monitor& monitor, const Work& work)
{
  const std::int64_t threads = std::min({ size, most, std::int64_t(Detail::MostThreads()) });
  if (threads <= 1)
  {
    RunInTurn(size, monitor, work);
    return;
  }
  std::vector<std::atomic<double>> done(static_cast<std::size_t>(size));
  std::atomic<std::int64_t> next(0);
  std::atomic<bool> isStopped(false);
  Detail::FirstException exception;
  const auto run = [&]()
  {
    for (std::int64_t n = next++; n < size && !isStopped; n = next++)
    {
      std::atomic<double>& own = done[std::size_t(n)];
      const auto report = [&](double part)
      {
        own = part;
        return !isStopped;
      };
      exception.Guard(n, [&]() { work(n, Monitor(report)); });
      own = 1.0;
    }
  };
  std::vector<std::future<void>> running; // They end before the rest goes, even after an exception.
  for (std::int64_t thread = 0; thread < threads; ++thread)
  {
    running.push_back(std::async(std::launch::async, run));
  }
  try
  {
    for (const std::future<void>& one : running)
    {
      while (one.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready)
      {
        monitor.Progress(std::accumulate(done.begin(), done.end(), 0.0) / double(size));
      }
    }
  }
  catch (...)
  {
    isStopped = true;
    throw;
  }
  exception.Rethrow();
}
}
