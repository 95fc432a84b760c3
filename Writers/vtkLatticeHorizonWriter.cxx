// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLatticeHorizonWriter.h"

#include "Common/Horizon/DataModel.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

//----------------------------------------------------------------------------------------------------------------------
int vtkLatticeHorizonWriter::VerticalSign(vtkPolyData* horizon) const
{
  if (this->VerticalPositive != AsRead)
  {
    return this->VerticalPositive == Depth ? -1 : 1;
  }
  vtkDataArray* const direction = horizon->GetFieldData()->GetArray(SeismicHorizons::FieldArray::VerticalDirection);
  return direction && direction->GetNumberOfValues() == 1 && direction->GetComponent(0, 0) < 0.0 ? -1 : 1;
}
