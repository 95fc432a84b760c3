// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vector that leaves new elements as they are. Large arrays that are written in full right away are not written
// twice then, and threads that fill a part each get its memory each, which a system hands out at the first write.

#ifndef SeismicHorizonsRawVector_h
#define SeismicHorizonsRawVector_h

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
template <typename T>
struct RawAllocator : std::allocator<T>
{
  template <typename U>
  struct rebind
  {
    using other = RawAllocator<U>;
  };

  template <typename U>
  void construct(U* place) noexcept
  {
    ::new (static_cast<void*>(place)) U;
  }

  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// For numbers only: elements that `resize` adds have any value.
template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;
}

#endif
