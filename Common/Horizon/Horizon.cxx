// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Horizon.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "DataModel.h"

#include <limits>
#include <list>
#include <mutex>
#include <numeric>
#include <string>

namespace SeismicHorizons
{
namespace
{
/// Numbers from 0 on. Offsets and points of vertices are the same ones, of any horizon.
template <typename Number>
class SharedNumbers
{
public:
  /// Returns at least `size` numbers. Much larger blocks are not used, since small arrays would keep them.
  static std::shared_ptr<void> Take(std::int64_t size)
  {
    if (std::shared_ptr<void> found = Find(size))
    {
      return found;
    }
    auto made = HeapArray<Number>(std::size_t(size));
    Number* const numbers = made.data();
    ParallelFor(size, Grain, // The lock is released, because threads may wait for each other in loops.
      [&](std::int64_t first, std::int64_t last) { std::iota(numbers + first, numbers + last, Number(first)); });
    const std::shared_ptr<void> block(made.Release(), std::free);
    const std::lock_guard<std::mutex> lock(Mutex());
    Blocks().push_back({ block, size });
    return block;
  }

private:
  struct Block
  {
    std::weak_ptr<void> Numbers;
    std::int64_t Size;
  };

  static std::shared_ptr<void> Find(std::int64_t size)
  {
    const std::lock_guard<std::mutex> lock(Mutex());
    Blocks().remove_if([](const Block& block) { return block.Numbers.expired(); });
    for (const Block& block : Blocks())
    {
      if (size <= block.Size && block.Size / 2 <= size)
      {
        return block.Numbers.lock();
      }
    }
    return nullptr;
  }

  // These are never destroyed, since arrays may outlive statics.
  static std::mutex& Mutex()
  {
    static auto* const mutex = new std::mutex;
    return *mutex;
  }
  static std::list<Block>& Blocks()
  {
    static auto* const blocks = new std::list<Block>;
    return *blocks;
  }
};

template <typename Number>
Cells MakeVerticesOf(std::int64_t size)
{
  const auto take = [](std::int64_t count)
  {
    std::shared_ptr<void> numbers = SharedNumbers<Number>::Take(count);
    return DataArray(TypeOf<Number>(), count, 1, numbers.get(), numbers);
  };
  return { take(size + 1), take(size) };
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckArraySizes(const Horizon& horizon)
{
  RequireTuples(horizon.PointData, horizon.NumberOfPoints(), "points");
  RequireTuples(horizon.CellData, horizon.NumberOfCells(), "cells");
  const DataArray* const ghosts = horizon.PointData.Find(PointArray::Ghosts);
  if (ghosts && ghosts->As<unsigned char>() && ghosts->Components() != 1)
  {
    throw InputError(
      "point array " + ghosts->Name + " with " + std::to_string(ghosts->Components()) + " components, expected 1");
  }
}

//----------------------------------------------------------------------------------------------------------------------
Cells MakeVertices(std::int64_t numberOfPoints)
{
  // The last offset is the number of points.
  return numberOfPoints <= std::numeric_limits<int>::max() ? MakeVerticesOf<int>(numberOfPoints)
                                                           : MakeVerticesOf<std::int64_t>(numberOfPoints);
}
}
