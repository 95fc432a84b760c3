// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Named arrays out of plain data. `data` is the point, cell or field data they are added to; an array of the same name
// is replaced.

#ifndef SeismicHorizonsDataArrays_h
#define SeismicHorizonsDataArrays_h

#include "Common/HeapArray.h"

#include "vtkFieldData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

class vtkAbstractArray;

namespace SeismicHorizons
{
/// Throws InputError (Common/Errors.h) when an array does not have as many tuples as there are `items` ("points"): VTK
/// does not look at that, and would read behind its end.
void RequireTuples(vtkAbstractArray* array, vtkIdType numberOfItems, const char* items);

/// The same for all arrays of point, cell or row data.
void RequireTuples(vtkFieldData* data, vtkIdType numberOfItems, const char* items);

/// The first value of an array of numbers, or another one where there is none.
double FirstValue(vtkFieldData* data, const char* name, double otherwise = 0.0);

/// Gives an array that size; its values are still to be written.
void SetNumberOfTuples(vtkAbstractArray* array, vtkIdType numberOfTuples);

/// An array of that size, whose values are still to be written.
template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, vtkIdType numberOfTuples, int numberOfComponents = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(numberOfComponents);
  SetNumberOfTuples(array, numberOfTuples);
  return array;
}

/// Adds an array with one value for each item: value(item).
template <typename Array, typename Item, typename Value>
void AddArray(vtkFieldData* data, const char* name, const std::vector<Item>& items, Value&& value)
{
  auto array = NewArray<Array>(name, static_cast<vtkIdType>(items.size()));
  std::transform(items.begin(), items.end(), array->GetPointer(0), value);
  data->AddArray(array);
}

/// Adds an array with these values.
template <typename Array, typename Value>
void AddArray(vtkFieldData* data, const char* name, const std::vector<Value>& values)
{
  auto array = NewArray<Array>(name, static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

/// Adds an array with these values and frees what held them, so that large data are held twice for a short time only.
template <typename Array, typename Value>
void MoveToArray(vtkFieldData* data, const char* name, std::vector<Value>& values)
{
  AddArray<Array>(data, name, values);
  values = std::vector<Value>();
}

/// Adds an array that takes over the memory of these values.
template <typename Array, typename Value>
void MoveToArray(vtkFieldData* data, const char* name, HeapArray<Value>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  const auto size = static_cast<vtkIdType>(values.size());
  array->SetArray(values.Release(), size, 0, Array::VTK_DATA_ARRAY_FREE);
  data->AddArray(array);
}

/// Adds an array that has the same value everywhere.
template <typename Array>
void AddConstant(vtkFieldData* data, const char* name, vtkIdType numberOfValues, typename Array::ValueType value)
{
  auto array = NewArray<Array>(name, numberOfValues);
  array->FillValue(value);
  data->AddArray(array);
}

/// Adds an array of a single value.
template <typename Array>
void AddValue(vtkFieldData* data, const char* name, typename Array::ValueType value)
{
  AddConstant<Array>(data, name, 1, value);
}

/// Adds an array of a single tuple.
template <typename Array, typename Tuple>
void AddTuple(vtkFieldData* data, const char* name, const Tuple& tuple)
{
  auto array = NewArray<Array>(name, 1, static_cast<int>(tuple.size()));
  std::copy(tuple.begin(), tuple.end(), array->GetPointer(0));
  data->AddArray(array);
}
}

#endif
