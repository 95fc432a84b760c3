// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataArrays.h"

#include "Common/Base/Errors.h"
#include "Common/Base/LargePages.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"

#include <cstddef>
#include <string>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void RequireTuples(vtkAbstractArray* array, vtkIdType numberOfItems, const char* items)
{
  if (array->GetNumberOfTuples() != numberOfItems)
  {
    throw InputError(std::string("array ") + (array->GetName() ? array->GetName() : "(no name)") + " of " +
      std::to_string(array->GetNumberOfTuples()) + " tuples, expected one for each of the " +
      std::to_string(numberOfItems) + ' ' + items);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void RequireTuples(vtkFieldData* data, vtkIdType numberOfItems, const char* items)
{
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
  {
    RequireTuples(data->GetAbstractArray(n), numberOfItems, items);
  }
}

//----------------------------------------------------------------------------------------------------------------------
double FirstValue(vtkFieldData* data, const char* name, double otherwise)
{
  vtkDataArray* const array = data->GetArray(name);
  return array && array->GetNumberOfValues() > 0 ? array->GetComponent(0, 0) : otherwise;
}

//----------------------------------------------------------------------------------------------------------------------
void SetNumberOfTuples(vtkAbstractArray* array, vtkIdType numberOfTuples)
{
  array->SetNumberOfTuples(numberOfTuples);
  if (array->IsNumeric() && array->HasStandardMemoryLayout() && array->GetNumberOfValues() > 0)
  {
    const std::size_t bytes = std::size_t(array->GetNumberOfValues()) * std::size_t(array->GetDataTypeSize());
    PreferLargePages(array->GetVoidPointer(0), bytes);
  }
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> NewArrayLike(vtkAbstractArray* array, vtkIdType numberOfTuples)
{
  const auto made = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  made->SetName(array->GetName());
  made->SetNumberOfComponents(array->GetNumberOfComponents());
  made->CopyComponentNames(array);
  SetNumberOfTuples(made, numberOfTuples);
  return made;
}
}
