// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vector that does not initialise new elements, so that an array is written once, and threads that fill it share the
// cost of first-touching its pages.

#ifndef SeismicHorizonsRawVector_h
#define SeismicHorizonsRawVector_h

#include "LargePages.h"

#include <cstddef>
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

  T* allocate(std::size_t count)
  {
    T* const memory = std::allocator<T>::allocate(count);
    PreferLargePages(memory, count * sizeof(T));
    return memory;
  }

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

template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;
}

#endif
