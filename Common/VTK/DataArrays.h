// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Arrays of the same name are replaced.

#ifndef SeismicHorizonsDataArrays_h
#define SeismicHorizonsDataArrays_h

#include "Common/Base/HeapArray.h"

#include "vtkFieldData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

class vtkAbstractArray;

namespace SeismicHorizons
{
/// Throws InputError unless the array has a tuple per item ("points"), which VTK does not check before it reads.
void RequireTuples(vtkAbstractArray* array, vtkIdType numberOfItems, const char* items);

void RequireTuples(vtkFieldData* data, vtkIdType numberOfItems, const char* items);

double FirstValue(vtkFieldData* data, const char* name, double otherwise = 0.0);

void SetNumberOfTuples(vtkAbstractArray* array, vtkIdType numberOfTuples);

/// The name and components of another array; the values are not initialised.
vtkSmartPointer<vtkAbstractArray> NewArrayLike(vtkAbstractArray* array, vtkIdType numberOfTuples);

/// The values are not initialised.
template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, vtkIdType numberOfTuples, int numberOfComponents = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(numberOfComponents);
  SetNumberOfTuples(array, numberOfTuples);
  return array;
}

template <typename Array, typename Item, typename Value>
void AddArray(vtkFieldData* data, const char* name, const std::vector<Item>& items, Value&& value)
{
  auto array = NewArray<Array>(name, static_cast<vtkIdType>(items.size()));
  std::transform(items.begin(), items.end(), array->GetPointer(0), value);
  data->AddArray(array);
}

template <typename Array, typename Value>
void AddArray(vtkFieldData* data, const char* name, const std::vector<Value>& values)
{
  auto array = NewArray<Array>(name, static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

/// Frees `values`, so that large data exist twice only briefly.
template <typename Array, typename Value>
void MoveToArray(vtkFieldData* data, const char* name, std::vector<Value>& values)
{
  AddArray<Array>(data, name, values);
  values = std::vector<Value>();
}

/// Takes over the memory of `values`.
template <typename Array, typename Value>
void MoveToArray(vtkFieldData* data, const char* name, HeapArray<Value>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  const auto size = static_cast<vtkIdType>(values.size());
  array->SetArray(values.Release(), size, 0, Array::VTK_DATA_ARRAY_FREE);
  data->AddArray(array);
}

template <typename Array>
void AddConstant(vtkFieldData* data, const char* name, vtkIdType numberOfValues, typename Array::ValueType value)
{
  auto array = NewArray<Array>(name, numberOfValues);
  array->FillValue(value);
  data->AddArray(array);
}

template <typename Array>
void AddValue(vtkFieldData* data, const char* name, typename Array::ValueType value)
{
  AddConstant<Array>(data, name, 1, value);
}

template <typename Array, typename Tuple>
void AddTuple(vtkFieldData* data, const char* name, const Tuple& tuple)
{
  auto array = NewArray<Array>(name, 1, static_cast<int>(tuple.size()));
  std::copy(tuple.begin(), tuple.end(), array->GetPointer(0));
  data->AddArray(array);
}
}

#endif
