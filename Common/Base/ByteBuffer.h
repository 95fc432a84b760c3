// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Values one after the other as bytes of this machine, for processes that run the same program.

#ifndef SeismicHorizonsByteBuffer_h
#define SeismicHorizonsByteBuffer_h

#include <cassert>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
class ByteBuffer
{
public:
  ByteBuffer() = default;
  explicit ByteBuffer(std::vector<char> bytes)
    : All(std::move(bytes))
  {
  }

  const std::vector<char>& Bytes() const { return this->All; }

  template <typename Value>
  void Write(const Value& value)
  {
    this->WriteItems(&value, 1);
  }

  template <typename Value>
  void WriteItems(const Value* items, std::size_t size)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* const bytes = reinterpret_cast<const char*>(items);
    this->All.insert(this->All.end(), bytes, bytes + size * sizeof(Value));
  }

  /// The number of items and the items.
  template <typename Value>
  void WriteArray(const Value* items, std::size_t size)
  {
    this->Write(size);
    this->WriteItems(items, size);
  }

  /// The same of any container.
  template <typename Items>
  void WriteAll(const Items& items)
  {
    this->Write(items.size());
    for (const auto& item : items)
    {
      this->Write(item);
    }
  }

  template <typename Value>
  Value Read()
  {
    Value value{};
    this->ReadItems(&value, 1);
    return value;
  }

  template <typename Value>
  void ReadItems(Value* items, std::size_t size)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    assert(size * sizeof(Value) <= this->All.size() - this->Next);
    std::memcpy(static_cast<void*>(items), this->All.data() + this->Next, size * sizeof(Value));
    this->Next += size * sizeof(Value);
  }

  template <typename Value>
  std::vector<Value> ReadAll()
  {
    std::vector<Value> items(this->Read<std::size_t>());
    this->ReadItems(items.data(), items.size());
    return items;
  }

private:
  std::vector<char> All;
  std::size_t Next = 0;
};
}

#endif
