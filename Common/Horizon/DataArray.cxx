// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataArray.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "KeptPoints.h"

#include <array>
#include <cstring>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
struct TypeDescription
{
  const char* Name; // as VTK says it in messages
  std::size_t Bytes;
};

constexpr std::array<TypeDescription, 15> KnownTypes = { { { "char", sizeof(char) }, { "signed char", sizeof(char) },
  { "unsigned char", sizeof(char) }, { "short", sizeof(short) }, { "unsigned short", sizeof(short) },
  { "int", sizeof(int) }, { "unsigned int", sizeof(int) }, { "long", sizeof(long) }, { "unsigned long", sizeof(long) },
  { "long long", sizeof(long long) }, { "unsigned long long", sizeof(long long) }, { "idtype", sizeof(std::int64_t) },
  { "float", sizeof(float) }, { "double", sizeof(double) }, { "string", 0 } } };

std::shared_ptr<void> MakeMemory(std::size_t bytes)
{
  HeapArray<char> memory(bytes);
  return { memory.Release(), std::free };
}
}

// ---- DataArray ------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
DataArray::DataArray(std::string name, std::vector<std::string> texts)
  : Name(std::move(name))
  , Kind(ValueType::Text)
  , Count(std::int64_t(texts.size()))
{
  const auto kept = std::make_shared<std::vector<std::string>>(std::move(texts));
  this->Values = kept.get();
  this->Keeper = kept;
}

//----------------------------------------------------------------------------------------------------------------------
DataArray DataArray::Make(ValueType type, std::int64_t tuples, int components)
{
  const std::shared_ptr<void> memory =
    MakeMemory(std::size_t(tuples) * std::size_t(components) * KnownTypes[std::size_t(type)].Bytes);
  return { type, tuples, components, memory.get(), memory };
}

//----------------------------------------------------------------------------------------------------------------------
const char* DataArray::TypeName() const
{
  return KnownTypes[std::size_t(this->Kind)].Name;
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t DataArray::BytesOfTuple() const
{
  return std::size_t(this->Width) * KnownTypes[std::size_t(this->Kind)].Bytes;
}

//----------------------------------------------------------------------------------------------------------------------
DataArray DataArray::NewLike(std::int64_t tuples) const
{
  DataArray made = this->IsText() ? DataArray(this->Name, std::vector<std::string>(std::size_t(tuples * this->Width)))
                                  : DataArray::Make(this->Kind, tuples, this->Width);
  made.Name = this->Name;
  made.ComponentNames = this->ComponentNames;
  made.Role = this->Role;
  made.Count = tuples;
  made.Width = this->Width;
  return made;
}

//----------------------------------------------------------------------------------------------------------------------
// Runs of consecutive points are copied at once.
DataArray DataArray::Select(const KeptPoints& kept) const
{
  DataArray selected = this->NewLike(std::int64_t(kept.size()));
  if (this->IsText())
  {
    auto& texts = *static_cast<std::vector<std::string>*>(selected.Values);
    const auto width = std::size_t(this->Width);
    for (std::size_t n = 0; n < texts.size(); ++n)
    {
      texts[n] = this->Texts()[std::size_t(kept[n / width]) * width + n % width];
    }
    return selected;
  }
  const std::size_t bytes = this->BytesOfTuple();
  const auto* const from = static_cast<const char*>(this->Values);
  auto* const to = static_cast<char*>(selected.Values);
  ParallelFor(std::int64_t(kept.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      kept.ForEachRun(std::size_t(first), std::size_t(last),
        [&](std::size_t n, PointId point, std::size_t length)
        { std::memcpy(to + n * bytes, from + std::size_t(point) * bytes, length * bytes); });
    });
  return selected;
}

// ---- ArrayTable -----------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
const DataArray* ArrayTable::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Arrays.begin(), this->Arrays.end(),
    [&name](const DataArray& array) { return !name.empty() && array.Name == name; });
  return found == this->Arrays.end() ? nullptr : &*found;
}

//----------------------------------------------------------------------------------------------------------------------
DataArray* ArrayTable::Find(const std::string& name)
{
  return const_cast<DataArray*>(std::as_const(*this).Find(name));
}

//----------------------------------------------------------------------------------------------------------------------
DataArray& ArrayTable::Add(DataArray array)
{
  if (array.Role >= 0)
  {
    for (DataArray& other : this->Arrays)
    {
      other.Role = other.Role == array.Role ? -1 : other.Role;
    }
  }
  DataArray* const before = this->Find(array.Name);
  if (!before)
  {
    return this->Arrays.emplace_back(std::move(array));
  }
  array.Role = array.Role < 0 ? before->Role : array.Role;
  return *before = std::move(array);
}

//----------------------------------------------------------------------------------------------------------------------
void ArrayTable::Remove(const std::string& name)
{
  this->Arrays.erase(std::remove_if(this->Arrays.begin(), this->Arrays.end(),
                       [&name](const DataArray& array) { return array.Name == name; }),
    this->Arrays.end());
}

//----------------------------------------------------------------------------------------------------------------------
void ArrayTable::AddAll(const ArrayTable& other)
{
  for (const DataArray& array : other)
  {
    this->Add(array);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ArrayTable::SetActiveScalars(const std::string& name)
{
  constexpr int scalars = 0;
  if (DataArray* const array = this->Find(name))
  {
    DataArray active = *array;
    active.Role = scalars;
    this->Add(std::move(active));
  }
}

// ---- Reading --------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
const DataArray* FindNumbers(const ArrayTable& data, const char* name)
{
  const DataArray* const array = data.Find(name);
  if (array && array->IsText())
  {
    throw InputError(std::string("an array ") + name + " of type " + array->TypeName() + ", expected numbers");
  }
  return array;
}

//----------------------------------------------------------------------------------------------------------------------
double FirstValue(const ArrayTable& data, const char* name, double otherwise)
{
  const DataArray* const array = data.Find(name);
  return array && !array->IsText() && array->Size() > 0 ? array->Value(0) : otherwise;
}

//----------------------------------------------------------------------------------------------------------------------
std::string TextOf(const DataArray& array, std::int64_t n)
{
  if (array.IsText())
  {
    return array.Texts()[std::size_t(n)];
  }
  std::ostringstream text;
  array.WithNumbers(
    [&](const auto* numbers)
    {
      if constexpr (std::is_same_v<decltype(numbers), const unsigned char*>)
      {
        text << int(numbers[n]); // The other types of one byte are characters, as in VTK.
      }
      else
      {
        text << numbers[n];
      }
    });
  return text.str();
}

//----------------------------------------------------------------------------------------------------------------------
void RequireTuples(const DataArray& array, std::int64_t numberOfItems, const char* items)
{
  if (array.Tuples() != numberOfItems)
  {
    throw InputError("array " + (array.Name.empty() ? "(no name)" : array.Name) + " of " +
      std::to_string(array.Tuples()) + " tuples, expected one for each of the " + std::to_string(numberOfItems) + ' ' +
      items);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void RequireTuples(const ArrayTable& data, std::int64_t numberOfItems, const char* items)
{
  for (const DataArray& array : data)
  {
    RequireTuples(array, numberOfItems, items);
  }
}
}
