// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/SideBySide.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#ifdef __unix__
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace SeismicHorizons;

namespace
{
/// Runs a test with each of some numbers of threads.
template <typename Test>
void ForThreads(Test&& test)
{
  int& threads = Detail::NumberOfThreads();
  const int usual = threads;
  for (const int number : { 1, 2, 3, 8 })
  {
    threads = number;
    test(number);
  }
  threads = usual;
}

/// How often each index was in a range.
class Tally
{
public:
  explicit Tally(std::int64_t size)
    : Visits(std::size_t(size))
  {
  }

  void Add(std::int64_t first, std::int64_t last)
  {
    CHECK(first >= 0 && first < last && last <= std::int64_t(this->Visits.size()));
    for (std::int64_t n = first; n < last; ++n)
    {
      ++this->Visits[std::size_t(n)];
    }
  }

  bool AllOnce() const
  {
    return std::all_of(this->Visits.begin(), this->Visits.end(), [](const auto& visits) { return visits == 1; });
  }

private:
  std::vector<std::atomic<int>> Visits;
};

void TestEveryIndexOnce()
{
  ForThreads(
    [](int)
    {
      for (const std::int64_t size : { 0, 1, 9, 10, 11, 1000, 1023, 4097 })
      {
        for (const std::int64_t grain : { 1, 10, 5000 })
        {
          Tally plain(size);
          ParallelFor(size, grain, [&](std::int64_t first, std::int64_t last) { plain.Add(first, last); });
          CHECK(plain.AllOnce());
          Tally batches(size);
          ParallelFor(size, grain, Monitor(), [&](std::int64_t first, std::int64_t last) { batches.Add(first, last); });
          CHECK(batches.AllOnce());
        }
      }
    });
}

/// All chunks have one size, but for the last, whatever ranges they come in.
void TestChunks()
{
  CHECK_EQUAL(CountChunks(0, 7), 0u);
  CHECK_EQUAL(CountChunks(7, 7), 1u);
  CHECK_EQUAL(CountChunks(8, 7), 2u);
  ForThreads(
    [](int)
    {
      Tally tally(1000);
      ForEachChunk(1000, 7, Monitor(),
        [&](std::size_t chunk, std::int64_t first, std::int64_t last)
        {
          CHECK_EQUAL(first, 7 * std::int64_t(chunk));
          CHECK_EQUAL(last, std::min<std::int64_t>(1000, first + 7));
          tally.Add(first, last);
        });
      CHECK(tally.AllOnce());
    });
}

/// At most 16 batches of 64 grains or more; the monitor is called before each of them, where the loop was started.
void TestMonitor()
{
  struct Case
  {
    std::int64_t Size;
    int Batches;
  };
  const auto caller = std::this_thread::get_id();
  const auto loop = [](std::int64_t size, const Monitor& monitor)
  { ParallelFor(size, 10, monitor, [](std::int64_t, std::int64_t) {}); };
  ForThreads(
    [&](int)
    {
      for (const Case& one : { Case{ 0, 0 }, { 640, 1 }, { 641, 2 }, { 100000, 16 }, { 100001, 16 } })
      {
        int calls = 0;
        loop(one.Size,
          Monitor(
            [&](double)
            {
              CHECK(std::this_thread::get_id() == caller);
              ++calls;
              return true;
            }));
        CHECK_EQUAL(calls, one.Batches);
        CHECK_EQUAL(
          MonitorChecker::Check(calls, [&](const Monitor& monitor) { loop(one.Size, monitor); }), std::string());
      }
    });
}

/// A step of a step is a part of that part.
void TestSteps()
{
  double last = -1.0;
  const Monitor whole(
    [&last](double part)
    {
      last = part;
      return true;
    });
  whole.Progress(0.25);
  CHECK_EQUAL(last, 0.25);
  const Monitor step = whole.Step(0.5, 0.75);
  step.Progress(0.0);
  CHECK_EQUAL(last, 0.5);
  step.Progress(1.0);
  CHECK_EQUAL(last, 0.75);
  step.Step(0.5, 1.0).Progress(0.5);
  CHECK_EQUAL(last, 0.6875);
}

/// Loops inside loops, on several threads at once, end and take every index once.
void TestLoopsInLoops()
{
  ForThreads(
    [](int)
    {
      constexpr std::int64_t Size = 50;
      const auto run = []()
      {
        Tally tally(Size * Size);
        const auto inner = [&tally](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t n = first; n < last; ++n)
          {
            ParallelFor(
              Size, 3, [&](std::int64_t begin, std::int64_t end) { tally.Add(Size * n + begin, Size * n + end); });
          }
        };
        ParallelFor(Size, 1, inner);
        CHECK(tally.AllOnce());
      };
      std::thread other(run);
      run();
      other.join();
    });
}

/// Work side by side takes every number once, at most so many at once, is stopped by the monitor, which is called where it
/// was started, and throws the exception of the lowest number.
void TestSideBySide()
{
  const auto caller = std::this_thread::get_id();
  ForThreads(
    [&](int threads)
    {
      for (const int most : { 1, 3 })
      {
        Tally tally(20);
        std::atomic<int> running(0);
        std::atomic<int> mostRunning(0);
        const Monitor monitor(
          [&](double part)
          {
            CHECK(std::this_thread::get_id() == caller && part >= 0.0 && part <= 1.0);
            return true;
          });
        RunSideBySide(20, most, monitor,
          [&](std::int64_t n, const Monitor& own)
          {
            const int now = ++running;
            for (int known = mostRunning; now > known && !mostRunning.compare_exchange_weak(known, now);)
            {
            }
            own.Progress(0.5);
            ParallelFor(10, 1, [](std::int64_t, std::int64_t) {});
            tally.Add(n, n + 1);
            --running;
          });
        CHECK(tally.AllOnce());
        CHECK(mostRunning <= std::min(most, threads));
      }
      const auto refuse = [](std::int64_t n, const Monitor&)
      {
        if (n % 3 == 2)
        {
          throw InputError(std::to_string(n));
        }
      };
      CHECK_THROWS_WITH(RunSideBySide(9, 9, Monitor(), refuse), "2");
      const auto wait = [](std::int64_t, const Monitor& own)
      {
        for (;;)
        {
          own.Progress(0.0);
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      };
      bool isStopped = false;
      try
      {
        RunSideBySide(9, 9, Monitor([](double) { return false; }), wait);
      }
      catch (const Aborted&)
      {
        isStopped = true;
      }
      CHECK(isStopped);
    });
}

#ifdef __unix__
/// A forked process has none of the threads of its parent.
void TestForkedProcess()
{
  ForThreads(
    [](int)
    {
      std::atomic<int> items(0);
      ParallelFor(100, 1, [&](std::int64_t, std::int64_t) { ++items; });
      const pid_t child = fork();
      if (child == 0)
      {
        items = 0;
        ParallelFor(100, 1, [&](std::int64_t, std::int64_t) { ++items; });
        _exit(items == 100 ? 0 : 1);
      }
      int status = 1;
      CHECK(waitpid(child, &status, 0) == child && status == 0);
      CHECK_EQUAL(items.load(), 100);
    });
}
#endif

/// Of the errors of several ranges that of the lowest range comes out, whichever was first in time.
void TestLowestErrorWins()
{
  ForThreads(
    [](int threads)
    {
      std::atomic<int> others(0);
      const auto work = [&](std::int64_t first, std::int64_t)
      {
        // Once one of the other threads has begun its second range, the error of its first has been taken in.
        while (first == 0 && threads > 1 && others < threads)
        {
          std::this_thread::yield();
        }
        others += first == 0 ? 0 : 1;
        throw InputError("in range " + std::to_string(first) + '.');
      };
      CHECK_THROWS_WITH(ParallelFor(1000, 10, work), "in range 0.");
    });
}

/// An error does not keep the other ranges from being worked on.
void TestErrorStopsNoOther()
{
  ForThreads(
    [](int)
    {
      Tally tally(1000);
      const auto work = [&](std::int64_t first, std::int64_t last)
      {
        tally.Add(first, last);
        if (first == 500)
        {
          throw InputError("in range 500.");
        }
      };
      CHECK_THROWS_WITH(ParallelFor(1000, 10, work), "in range 500.");
      CHECK(tally.AllOnce());
    });
}
}

int TestParallel(int, char*[])
{
  TestEveryIndexOnce();
  TestChunks();
  TestMonitor();
  TestSteps();
  TestLoopsInLoops();
  TestSideBySide();
#ifdef __unix__
  TestForkedProcess();
#endif
  TestLowestErrorWins();
  TestErrorStopsNoOther();
  return Check::Result();
}
