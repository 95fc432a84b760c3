// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vector of numbers on std::malloc. std::realloc remaps large arrays without copying, and the memory can be released
// to an owner that calls std::free, as VTK arrays do. With std::vector reading ten million points takes 1.4 times as
// long.

#ifndef SeismicHorizonsHeapArray_h
#define SeismicHorizonsHeapArray_h

#include "LargePages.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
template <typename T>
class HeapArray
{
  static_assert(std::is_trivially_copyable_v<T>, "numbers, and columns");

public:
  using value_type = T;

  HeapArray() = default;
  explicit HeapArray(std::size_t count) { this->Extend(count); }
  HeapArray(std::initializer_list<T> values) { this->append(values.begin(), values.end()); }
  HeapArray(const HeapArray& other) { this->append(other.begin(), other.end()); }
  HeapArray(HeapArray&& other) noexcept { this->Swap(other); }
  HeapArray& operator=(HeapArray other) noexcept
  {
    this->Swap(other);
    return *this;
  }
  ~HeapArray() { std::free(this->First); }

  std::size_t size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }
  T* data() { return this->First; }
  const T* data() const { return this->First; }
  T* begin() { return this->First; }
  T* end() { return this->First + this->Count; }
  const T* begin() const { return this->First; }
  const T* end() const { return this->First + this->Count; }
  T& operator[](std::size_t n) { return this->First[n]; }
  const T& operator[](std::size_t n) const { return this->First[n]; }
  const T& front() const { return this->First[0]; }
  T& back() { return this->First[this->Count - 1]; }
  const T& back() const { return this->First[this->Count - 1]; }

  void push_back(T value)
  {
    if (this->Count == this->Capacity)
    {
      this->MakeRoom(this->Count + 1, this->Capacity);
    }
    this->First[this->Count++] = value;
  }
  void pop_back() { --this->Count; }
  void clear() { this->Count = 0; }

  void append(const T* first, const T* last) { std::copy(first, last, this->Extend(std::size_t(last - first))); }

  void Reserve(std::size_t count)
  {
    if (this->Capacity < count)
    {
      this->Resize(count);
    }
  }

  /// The added numbers are not initialised. Where there is no room, it is made for the number that is expected in the
  /// end; 0 if that is unknown.
  T* Extend(std::size_t count, std::size_t expected = 0)
  {
    if (this->Capacity - this->Count < count)
    {
      this->MakeRoom(std::max(this->Count + count, expected), expected > 0 ? this->Capacity / 8 : this->Capacity);
    }
    this->Count += count;
    return this->First + this->Count - count;
  }

  T* Release()
  {
    if (this->Count > 0)
    {
      this->Resize(this->Count); // Shrinking cannot fail.
    }
    this->Count = 0;
    this->Capacity = 0;
    return std::exchange(this->First, nullptr);
  }

private:
  void Swap(HeapArray& other) noexcept
  {
    std::swap(this->First, other.First);
    std::swap(this->Count, other.Count);
    std::swap(this->Capacity, other.Capacity);
  }

  void MakeRoom(std::size_t least, std::size_t more)
  {
    constexpr std::size_t fewest = 16;
    this->Resize(std::max({ least, this->Capacity + more, fewest }));
  }

  void Resize(std::size_t capacity)
  {
    void* const memory = std::realloc(this->First, capacity * sizeof(T));
    if (!memory)
    {
      throw std::bad_alloc();
    }
    PreferLargePages(memory, capacity * sizeof(T));
    this->First = static_cast<T*>(memory);
    this->Capacity = capacity;
  }

  T* First = nullptr;
  std::size_t Count = 0;
  std::size_t Capacity = 0;
};

template <typename Result, typename Values, typename Place>
Result Gather(const Values& values, const std::vector<Place>& places)
{
  Result gathered(places.size());
  std::transform(
    places.begin(), places.end(), gathered.begin(), [&values](Place place) { return values[std::size_t(place)]; });
  return gathered;
}

template <typename T>
bool operator==(const HeapArray<T>& a, const HeapArray<T>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

template <typename T>
bool operator!=(const HeapArray<T>& a, const HeapArray<T>& b)
{
  return !(a == b);
}

template <typename T>
bool operator==(const HeapArray<T>& a, const std::vector<T>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}
}

#endif
