// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vector that does not set new elements to 0. An array that is filled right after it was made is then written once
// instead of twice. And as systems provide memory page by page at the first write, which takes time, threads that fill
// a part each share that time too.

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
/// An allocator that constructs elements without a value as C++ does for local variables: numbers stay uninitialised.
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

/// For numbers only. Elements that `resize` adds have no value before one is assigned.
template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;
}

#endif
