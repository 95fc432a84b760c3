// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Named arrays, as attributes of points and figures of stages, and tables of them.

#ifndef SeismicHorizonsDataArray_h
#define SeismicHorizonsDataArray_h

#include "Common/Base/HeapArray.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
class KeptPoints;

/// Id is the type of counts and numbers of points, of 64 bits.
enum class ValueType
{
  Char,
  SignedChar,
  UnsignedChar,
  Short,
  UnsignedShort,
  Int,
  UnsignedInt,
  Long,
  UnsignedLong,
  LongLong,
  UnsignedLongLong,
  Id,
  Float,
  Double,
  Text
};

/// The types of arrays that stages make.
template <typename T>
constexpr ValueType TypeOf()
{
  static_assert(std::is_same_v<T, unsigned char> || std::is_same_v<T, int> || std::is_same_v<T, std::int64_t> ||
      std::is_same_v<T, float> || std::is_same_v<T, double>,
    "a type that stages write");
  return std::is_same_v<T, unsigned char> ? ValueType::UnsignedChar
    : std::is_same_v<T, int>              ? ValueType::Int
    : std::is_same_v<T, std::int64_t>     ? ValueType::Id
    : std::is_same_v<T, float>            ? ValueType::Float
                                          : ValueType::Double;
}

/// Numbers or texts in tuples of some components. Copies share the memory, so that only an array that was just made is
/// written.
class DataArray
{
public:
  std::string Name;
  std::vector<std::string> ComponentNames; // empty, or one each
  std::string Unit; // of files that say it
  int Role = -1; // The use in a view, such as colouring points, is one of vtkDataSetAttributes; -1 without one.

  DataArray() = default;

  /// Refers to memory that `owner` keeps.
  DataArray(ValueType type, std::int64_t tuples, int components, void* values, std::shared_ptr<void> owner)
    : Kind(type)
    , Count(tuples)
    , Width(components)
    , Values(values)
    , Keeper(std::move(owner))
  {
  }

  DataArray(std::string name, std::vector<std::string> texts);

  /// The values are not initialised.
  static DataArray Make(ValueType type, std::int64_t tuples, int components);

  /// Takes over the memory.
  template <typename T>
  static DataArray Take(HeapArray<T>& values, int components = 1)
  {
    const auto size = std::int64_t(values.size());
    void* const memory = values.Release();
    return { TypeOf<T>(), size / components, components, memory, std::shared_ptr<void>(memory, std::free) };
  }

  ValueType Type() const { return this->Kind; }
  bool IsText() const { return this->Kind == ValueType::Text; }
  bool IsFloating() const { return this->Kind == ValueType::Float || this->Kind == ValueType::Double; }
  const char* TypeName() const;
  std::int64_t Tuples() const { return this->Count; }
  int Components() const { return this->Width; }
  /// of all tuples
  std::int64_t Size() const { return this->Count * this->Width; }
  std::size_t BytesOfTuple() const;
  void* Data() const { return this->Values; }
  const std::shared_ptr<void>& Owner() const { return this->Keeper; }
  bool IsCopyOf(const DataArray& other) const
  {
    return !this->Keeper.owner_before(other.Keeper) && !other.Keeper.owner_before(this->Keeper);
  }

  /// Null for values of another type.
  template <typename T>
  T* As() const
  {
    return this->Kind == TypeOf<T>() ? static_cast<T*>(this->Values) : nullptr;
  }

  const std::vector<std::string>& Texts() const
  {
    assert(this->IsText());
    return *static_cast<const std::vector<std::string>*>(this->Values);
  }

  /// Calls work(values) with a pointer to the numbers.
  template <typename Work>
  void WithNumbers(Work&& work) const
  {
    switch (this->Kind)
    {
      case ValueType::Char:
        return work(static_cast<char*>(this->Values));
      case ValueType::SignedChar:
        return work(static_cast<signed char*>(this->Values));
      case ValueType::UnsignedChar:
        return work(static_cast<unsigned char*>(this->Values));
      case ValueType::Short:
        return work(static_cast<short*>(this->Values));
      case ValueType::UnsignedShort:
        return work(static_cast<unsigned short*>(this->Values));
      case ValueType::Int:
        return work(static_cast<int*>(this->Values));
      case ValueType::UnsignedInt:
        return work(static_cast<unsigned int*>(this->Values));
      case ValueType::Long:
        return work(static_cast<long*>(this->Values));
      case ValueType::UnsignedLong:
        return work(static_cast<unsigned long*>(this->Values));
      case ValueType::LongLong:
      case ValueType::Id:
        return work(static_cast<long long*>(this->Values));
      case ValueType::UnsignedLongLong:
        return work(static_cast<unsigned long long*>(this->Values));
      case ValueType::Float:
        return work(static_cast<float*>(this->Values));
      case ValueType::Double:
        return work(static_cast<double*>(this->Values));
      case ValueType::Text:
        assert(false);
    }
  }

  double At(std::int64_t tuple, int component = 0) const
  {
    double value = 0.0;
    const std::int64_t place = tuple * this->Width + component;
    this->WithNumbers([&](const auto* numbers) { value = double(numbers[place]); });
    return value;
  }

  void Set(std::int64_t tuple, int component, double value)
  {
    const std::int64_t place = tuple * this->Width + component;
    this->WithNumbers([&](auto* numbers) { numbers[place] = static_cast<std::decay_t<decltype(*numbers)>>(value); });
  }

  /// The n-th through all tuples.
  double Value(std::int64_t n) const { return this->At(0, int(n)); }

  /// The same names, role and type for other values, which are not initialised.
  DataArray NewLike(std::int64_t tuples) const;

  DataArray Select(const KeptPoints& kept) const;

private:
  ValueType Kind = ValueType::Double;
  std::int64_t Count = 0;
  int Width = 1;
  void* Values = nullptr; // For texts, a vector of them.
  std::shared_ptr<void> Keeper;
};

/// Arrays of different names, apart from those without one.
class ArrayTable
{
public:
  std::size_t Size() const { return this->Arrays.size(); }
  const DataArray& operator[](std::size_t n) const { return this->Arrays[n]; }
  auto begin() const { return this->Arrays.begin(); }
  auto end() const { return this->Arrays.end(); }

  /// Null without the array.
  const DataArray* Find(const std::string& name) const;
  DataArray* Find(const std::string& name);
  bool Has(const std::string& name) const { return this->Find(name) != nullptr; }

  /// Replaces the array of that name, whose role it takes unless it has its own.
  DataArray& Add(DataArray array);
  void Remove(const std::string& name);
  void AddAll(const ArrayTable& other);
  /// ParaView colours by this array.
  void SetActiveScalars(const std::string& name);

private:
  std::vector<DataArray> Arrays;
};

// ---- Reading --------------------------------------------------------------------------------------------------------

/// Null without the array; throws InputError on texts.
const DataArray* FindNumbers(const ArrayTable& data, const char* name);

double FirstValue(const ArrayTable& data, const char* name, double otherwise = 0.0);

/// The n-th value through all tuples; numbers have up to six digits.
std::string TextOf(const DataArray& array, std::int64_t n);

/// Throws InputError unless the array has a tuple per item ("points").
void RequireTuples(const DataArray& array, std::int64_t numberOfItems, const char* items);

void RequireTuples(const ArrayTable& data, std::int64_t numberOfItems, const char* items);

// ---- Writing --------------------------------------------------------------------------------------------------------

/// The values are not initialised.
template <typename T>
DataArray NewArray(const char* name, std::int64_t tuples, int components = 1)
{
  DataArray array = DataArray::Make(TypeOf<T>(), tuples, components);
  array.Name = name;
  return array;
}

template <typename T, typename Items, typename Value>
void AddArray(ArrayTable& data, const char* name, const Items& items, Value&& value)
{
  DataArray array = NewArray<T>(name, std::int64_t(items.size()));
  std::transform(items.begin(), items.end(), array.As<T>(), value);
  data.Add(std::move(array));
}

template <typename T, typename Values>
void AddArray(ArrayTable& data, const char* name, const Values& values)
{
  DataArray array = NewArray<T>(name, std::int64_t(values.size()));
  std::copy(values.begin(), values.end(), array.As<T>());
  data.Add(std::move(array));
}

/// Frees `values`, so that large data exist twice only briefly.
template <typename T, typename Value>
void MoveToArray(ArrayTable& data, const char* name, std::vector<Value>& values)
{
  AddArray<T>(data, name, values);
  values = std::vector<Value>();
}

/// Takes over the memory of `values`.
template <typename T>
void MoveToArray(ArrayTable& data, const char* name, HeapArray<T>& values)
{
  DataArray array = DataArray::Take(values);
  array.Name = name;
  data.Add(std::move(array));
}

template <typename T>
void AddConstant(ArrayTable& data, const char* name, std::int64_t tuples, T value)
{
  DataArray array = NewArray<T>(name, tuples);
  std::fill_n(array.As<T>(), tuples, value);
  data.Add(std::move(array));
}

template <typename T>
void AddValue(ArrayTable& data, const char* name, T value)
{
  AddConstant<T>(data, name, 1, value);
}

template <typename T, typename Tuple>
DataArray& AddTuple(ArrayTable& data, const char* name, const Tuple& tuple)
{
  DataArray array = NewArray<T>(name, 1, int(tuple.size()));
  std::copy(tuple.begin(), tuple.end(), array.As<T>());
  return data.Add(std::move(array));
}
}

#endif
