// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Systems provide memory page by page, at the first write, and clear each page before. With pages of the usual 4 KB
// that takes half of the time of reading, or of simplifying, ten million points.

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
/// Asks for large pages for memory that is still to be written, if there is so much that it matters. Does nothing where
/// the system has none.
inline void PreferLargePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t Fewest = std::size_t(1) << 22; // bytes, of two large pages
  if (memory && bytes >= Fewest)
  {
    // All of the mapping that std::malloc has made for it: std::realloc could not move one that is in two parts.
    constexpr std::uintptr_t Page = 4096;
    const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(memory) / Page * Page;
    const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(memory) + bytes + Page - 1) / Page * Page;
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE); // a wish, which may be refused
  }
#endif
}

/// A vector in such memory.
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
