// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>

#ifdef __unix__
#include <unistd.h>
#endif

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
int MostThreads()
{
  return NumberOfThreads();
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

/// Threads that wait for loops. A loop never waits for a thread that has not begun with it, so loops inside loops and on
/// several threads end.
class Helpers
{
public:
  /// Starts with none again in a process that was forked, which has no threads.
  static Helpers& Get()
  {
    static std::mutex mutex;
    static Helpers* own = nullptr;
    const std::lock_guard<std::mutex> lock(mutex);
    if (!own || own->Process != CurrentProcess())
    {
      own = new Helpers; // never deleted, as its threads wait until the program ends
    }
    return *own;
  }

  void Run(const std::function<void()>& work, int mostHelpers)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    for (; this->Number < mostHelpers; ++this->Number)
    {
      std::thread([this]() { this->Help(); }).detach();
    }
    const auto loop = this->Loops.insert(this->Loops.end(), Loop{ &work, mostHelpers });
    lock.unlock();
    this->Begun.notify_all();
    work();
    lock.lock();
    loop->Wanted = 0;
    this->Ended.wait(lock, [&loop]() { return loop->Helping == 0; });
    this->Loops.erase(loop);
  }

private:
  struct Loop
  {
    const std::function<void()>* Work;
    int Wanted;
    int Helping = 0;
  };

  static long CurrentProcess()
  {
#ifdef __unix__
    return long(getpid());
#else
    return 0;
#endif
  }

  void Help()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    for (;;)
    {
      const auto isOpen = [](const Loop& loop) { return loop.Wanted > 0; };
      auto loop = this->Loops.end();
      this->Begun.wait(lock,
        [&]()
        {
          loop = std::find_if(this->Loops.begin(), this->Loops.end(), isOpen);
          return loop != this->Loops.end();
        });
      --loop->Wanted;
      ++loop->Helping;
      lock.unlock();
      (*loop->Work)();
      lock.lock();
      if (--loop->Helping == 0)
      {
        this->Ended.notify_all();
      }
    }
  }

  const long Process = CurrentProcess();
  std::mutex Mutex;
  std::condition_variable Begun;
  std::condition_variable Ended;
  std::list<Loop> Loops;
  int Number = 0;
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
  const int helpers = int(std::min<std::int64_t>(ranges, NumberOfThreads())) - 1;
  if (helpers > 0)
  {
    Helpers::Get().Run(run, helpers);
  }
  else
  {
    run();
  }
}
}
}
