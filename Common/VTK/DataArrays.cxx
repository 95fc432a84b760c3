// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataArrays.h"

#include "Common/Errors.h"

#include "vtkAbstractArray.h"

#include <string>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void RequireTuples(vtkAbstractArray* array, vtkIdType numberOfItems, const char* items)
{
  if (array->GetNumberOfTuples() != numberOfItems)
  {
    throw InputError(std::string("array ") + (array->GetName() ? array->GetName() : "(no name)") + " of " +
      std::to_string(array->GetNumberOfTuples()) + " values, expected one for each of the " +
      std::to_string(numberOfItems) + ' ' + items);
  }
}
}
