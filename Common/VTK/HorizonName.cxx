// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonName.h"

#include "Common/DataModel.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

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
  const double id = ids && ids->GetNumberOfTuples() > 0 ? ids->GetComponent(0, 0) : std::nan("");
  constexpr double Greatest = 1LL << 53; // beyond, doubles are no longer exact
  return std::abs(id) <= Greatest ? HorizonName(static_cast<std::int64_t>(id)) : std::string();
}
}
