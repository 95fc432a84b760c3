// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexCells.h"

#include "Common/Base/Parallel.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <list>
#include <memory>
#include <mutex>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
namespace
{
template <typename Number>
bool Counts(const Number* numbers, vtkIdType size)
{
  std::atomic<bool> isSame(true);
  ParallelFor(size, Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      bool isSameHere = true;
      for (std::int64_t n = first; n < last; ++n)
      {
        isSameHere &= numbers[n] == Number(n);
      }
      isSame = isSame && isSameHere;
    });
  return isSame;
}

bool Counts(vtkDataArray* array)
{
  const vtkIdType size = array->GetNumberOfTuples();
  if (auto* const narrow = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(array))
  {
    return Counts(narrow->GetPointer(0), size);
  }
  if (auto* const wide = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(array))
  {
    return Counts(wide->GetPointer(0), size);
  }
  // From VTK 9.6 on offsets may be implicit.
  vtkIdType same = 0;
  while (same < size && array->GetComponent(same, 0) == double(same))
  {
    ++same;
  }
  return same == size;
}

/// Offsets and points of all vertex cells are 0, 1, 2 and so on. Arrays share one block, so that stages that drop few
/// points write no cells.
template <typename Number>
class SharedNumbers
{
public:
  /// Returns at least `size` numbers. Much larger blocks are not used, since small arrays would keep them.
  static Number* Take(vtkIdType size)
  {
    if (Number* const found = Find(size))
    {
      return found;
    }
    std::unique_ptr<Number[]> made(new Number[std::size_t(size)]);
    Number* const numbers = made.get();
    ParallelFor(size, Grain, // The lock is released, because threads may wait for each other in loops.
      [&](std::int64_t first, std::int64_t last) { std::iota(numbers + first, numbers + last, Number(first)); });
    const std::lock_guard<std::mutex> lock(Mutex());
    Blocks().push_back({ std::move(made), size, 1 });
    return numbers;
  }

  static void Return(void* numbers)
  {
    const std::lock_guard<std::mutex> lock(Mutex());
    const auto block = std::find_if(
      Blocks().begin(), Blocks().end(), [numbers](const Block& one) { return one.Numbers.get() == numbers; });
    if (--block->Users == 0)
    {
      Blocks().erase(block);
    }
  }

private:
  struct Block
  {
    std::unique_ptr<Number[]> Numbers;
    vtkIdType Size;
    std::int64_t Users;
  };

  static Number* Find(vtkIdType size)
  {
    const std::lock_guard<std::mutex> lock(Mutex());
    const auto block = std::find_if(
      Blocks().begin(), Blocks().end(), [size](const Block& one) { return size <= one.Size && one.Size / 2 <= size; });
    if (block == Blocks().end())
    {
      return nullptr;
    }
    ++block->Users;
    return block->Numbers.get();
  }

  // The mutex is never destroyed, since arrays may outlive statics.
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

/// An array that grows moves to its own memory.
template <typename Array>
void Count(vtkIdType size, Array* array)
{
  using Numbers = SharedNumbers<typename Array::ValueType>;
  array->SetArray(Numbers::Take(size), size, 0, Array::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction(Numbers::Return);
}

template <typename Array>
void SetVertices(vtkIdType numberOfPoints, vtkCellArray* vertices)
{
  vtkNew<Array> offsets;
  vtkNew<Array> points;
  Count(numberOfPoints + 1, offsets.Get());
  Count(numberOfPoints, points.Get());
  vertices->SetData(offsets, points);
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakeVertices(vtkIdType numberOfPoints)
{
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  // The last offset is the number of points.
  if (numberOfPoints <= std::numeric_limits<vtkTypeInt32>::max())
  {
    SetVertices<vtkTypeInt32Array>(numberOfPoints, vertices);
  }
  else
  {
    SetVertices<vtkTypeInt64Array>(numberOfPoints, vertices);
  }
  return vertices;
}

//----------------------------------------------------------------------------------------------------------------------
bool HasAllVertices(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  if (!cells || cells->GetNumberOfCells() != numberOfPoints || cells->GetNumberOfConnectivityIds() != numberOfPoints)
  {
    return false;
  }
  return Counts(cells->GetOffsetsArray()) && Counts(cells->GetConnectivityArray());
}
}
