// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonName.h"

#include "Common/DataModel.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::string HorizonName(std::int64_t surfaceId)
{
  return "Horizon " + std::to_string(surfaceId);
}

//----------------------------------------------------------------------------------------------------------------------
std::string NameBySurfaceId(vtkPolyData* horizon)
{
  vtkDataArray* const ids = horizon->GetPointData()->GetArray(PointArray::SurfaceId);
  return ids && ids->GetNumberOfTuples() > 0 ? HorizonName(static_cast<std::int64_t>(ids->GetComponent(0, 0)))
                                             : std::string();
}
}
