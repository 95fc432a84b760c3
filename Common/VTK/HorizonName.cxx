// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonName.h"

#include "Common/Horizon/DataModel.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <unordered_map>
#include <unordered_set>

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
  constexpr double Greatest = 1LL << 53; // Larger doubles are not exact integers.
  return std::abs(id) <= Greatest ? HorizonName(static_cast<std::int64_t>(id)) : std::string();
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> MakeDistinct(std::vector<std::string> names)
{
  std::unordered_set<std::string> taken(names.begin(), names.end());
  std::unordered_map<std::string, int> uses;
  for (std::string& name : names)
  {
    const std::string first = name;
    int& number = uses[first];
    ++number;
    while (number > 1 && !taken.insert(name = first + " (" + std::to_string(number) + ')').second)
    {
      ++number;
    }
  }
  return names;
}
}
