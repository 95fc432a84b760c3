// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A horizon that several processes mesh together, here threads: the same surface as of one process.

#include "Filters/Algorithms/Surface/RankedParts.h"
#include "PartInputs.h"
#include "Tools/Check.h"
#include "Tools/CrackedPatches.h"
#include "Tools/Patches.h"
#include "Tools/TestHorizons.h"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <future>
#include <list>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

using namespace SeismicHorizons;
using namespace SurfaceInputs;
using namespace PartInputs;

namespace
{
/// Threads in place of processes.
class ThreadRanks
{
public:
  explicit ThreadRanks(int size)
    : Count(size)
    , Messages(std::size_t(size * size))
  {
  }

  int Size() const { return this->Count; }

  void Send(const ByteBuffer& bytes, int from, int to)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Messages[std::size_t(from * this->Count + to)].push_back(bytes);
    this->Changed.notify_all();
  }

  ByteBuffer Receive(int from, int to)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    std::list<ByteBuffer>& messages = this->Messages[std::size_t(from * this->Count + to)];
    this->Changed.wait(lock, [&messages]() { return !messages.empty(); });
    const ByteBuffer bytes(messages.front().Bytes());
    messages.pop_front();
    return bytes;
  }

  void Together(const std::function<void()>& work)
  {
    std::exception_ptr problem;
    try
    {
      work();
    }
    catch (...)
    {
      problem = std::current_exception();
    }
    std::unique_lock<std::mutex> lock(this->Mutex);
    const int end = this->Called / this->Count * this->Count + this->Count;
    this->Failed = problem ? end : this->Failed;
    ++this->Called;
    this->Changed.notify_all();
    this->Changed.wait(lock, [this, end]() { return this->Called >= end; });
    if (problem)
    {
      std::rethrow_exception(problem);
    }
    if (this->Failed == end)
    {
      throw Aborted();
    }
  }

private:
  const int Count;
  std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<std::list<ByteBuffer>> Messages;
  int Called = 0;
  int Failed = 0; // the last calls that did
};

class ThreadRank : public PartRanks
{
public:
  ThreadRank(ThreadRanks& all, int own)
    : All(all)
    , Number(own)
  {
  }

  int Size() const override { return this->All.Size(); }
  int Own() const override { return this->Number; }
  ByteBuffer Receive(int rank) const override { return this->All.Receive(rank, this->Number); }
  void Together(const std::function<void()>& work) const override { this->All.Together(work); }

protected:
  void SendTo(int rank, const ByteBuffer& bytes) const override { this->All.Send(bytes, this->Number, rank); }

private:
  ThreadRanks& All;
  const int Number;
};

/// Makes a surface on several processes. Their monitors stop them if `isStopped` is true for their number.
Surface MakeOnRanks(
  const Points& points, SurfaceOptions options, int size, const std::function<bool(int)>& isStopped = {})
{
  ThreadRanks all(size);
  const auto monitorOf = [&](int rank)
  { return Monitor([&, rank](double) { return !isStopped || !isStopped(rank); }); };
  std::vector<std::future<void>> helpers;
  std::list<ThreadRank> ranks;
  for (int rank = 0; rank < size; ++rank)
  {
    const ThreadRank& own = ranks.emplace_back(all, rank);
    if (rank > 0)
    {
      helpers.push_back(std::async(std::launch::async, [&, rank]() { HelpToMesh(own, monitorOf(rank)); }));
    }
  }
  options.Ranks = &ranks.front();
  std::optional<Surface> surface;
  try
  {
    surface = MakeSurface(points, options, monitorOf(0));
  }
  catch (const std::exception&)
  {
  }
  ReleaseHelpers(ranks.front());
  int stopped = surface ? 0 : 1;
  for (std::future<void>& helper : helpers)
  {
    try
    {
      helper.get();
    }
    catch (const Aborted&)
    {
      ++stopped;
    }
  }
  CHECK(stopped == 0 || stopped == size || (stopped == 1 && !surface)); // all, or process 0 before or after the others
  return surface ? std::move(*surface) : Surface();
}

/// Any number of processes makes the same surface, to the last digit.
void CheckRanks(const Points& points, const SurfaceOptions& options, const Surface& surface)
{
  const auto tell = [](const Surface& one) {
    return Tell(one, { one.Mesh.Points.Target.begin(), one.Mesh.Points.Target.end() }, std::int64_t(one.Kept.size()));
  };
  for (const int size : { 2, 3, 7 })
  {
    CHECK(tell(MakeOnRanks(points, options, size)) == tell(surface));
  }
}

/// All processes end when one of them is stopped, or refuses the horizon.
void TestStoppedRanks()
{
  const Points points = MakeGenerated(1, 0.0);
  SurfaceOptions options = Within(0.75);
  options.Radius = 1;
  options.RowsOfPart = 40;
  for (int stopped = 0; stopped < 3; ++stopped)
  {
    CHECK(MakeOnRanks(points, options, 3, [stopped](int rank) { return rank == stopped; }).Mesh.Triangles.empty());
  }
  options.SmallestAngle = -1.0;
  CHECK(MakeOnRanks(points, options, 3).Mesh.Triangles.empty());
}

void TestRandomPatches()
{
  for (int seed = 1; seed <= 120; ++seed)
  {
    Patches::Random random(std::uint64_t(seed) * 6271u);
    const Patches::Columns columns = Patches::Make(Patches::Shape(seed % int(Patches::Shape::Count)), random);
    const Points points = SortedByRow(columns, TestHorizons::MakeHeights(columns, random));
    const SurfaceOptions options = RandomOptions(random);
    CheckRanks(points, options, MakeSurface(points, options));
  }
}

/// Cut links are sent, too.
void TestCracks()
{
  for (int seed = 1; seed <= 60; ++seed)
  {
    Patches::Random random(std::uint64_t(seed) * 104723u);
    const CrackedPatches::CrackedPatch patch = CrackedPatches::Make(random);
    const Points points = SortedByRow(patch.Columns, TestHorizons::MakeHeights(patch.Columns, random));
    SurfaceOptions options = RandomOptions(random);
    options.Cuts = &patch.Cuts;
    CheckRanks(points, options, MakeSurface(points, options));
  }
}
}

int TestRankedParts(int, char**)
{
  TestRandomPatches();
  TestCracks();
  TestStoppedRanks();
  return Check::Result();
}
