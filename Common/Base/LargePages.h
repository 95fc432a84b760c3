// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Systems clear memory page by page at the first write. With 4 KB pages this takes half of the time of reading or
// simplifying ten million points.

#ifndef SeismicHorizonsLargePages_h
#define SeismicHorizonsLargePages_h

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// The memory must not have been written. Small blocks keep small pages.
inline void PreferLargePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t Fewest = std::size_t(1) << 22; // Bytes of two large pages.
  if (memory && bytes >= Fewest)
  {
    // The whole mapping of std::malloc is advised, since std::realloc cannot move a split mapping.
    constexpr std::uintptr_t Page = 4096;
    const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(memory) / Page * Page;
    const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(memory) + bytes + Page - 1) / Page * Page;
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
  }
#endif
}

template <typename T>
std::vector<T> LargeVector(std::size_t count, const T& value = T())
{
  std::vector<T> values;
  values.reserve(count);
  PreferLargePages(values.data(), count * sizeof(T));
  values.resize(count, value);
  return values;
}
}

#endif
