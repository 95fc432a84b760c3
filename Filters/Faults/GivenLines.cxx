// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GivenLines.h"

#include "Common/Base/Errors.h"
#include "Common/VTK/HorizonConversion.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace SeismicHorizons
{
namespace
{
Horizon LinesOf(vtkDataObject* object)
{
  auto* const data = vtkPolyData::SafeDownCast(object);
  if (!data)
  {
    throw InputError(
      "fault polylines in a " + std::string(object->GetClassName()) + ", expected lines or polygons of a vtkPolyData");
  }
  return FromVTK(data);
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<NamedHorizon> ListGivenLines(vtkDataObject* lines)
{
  auto* const composite = vtkCompositeDataSet::SafeDownCast(lines);
  if (!composite)
  {
    return lines ? std::vector<NamedHorizon>{ { "", LinesOf(lines) } } : std::vector<NamedHorizon>();
  }
  std::vector<NamedHorizon> blocks;
  const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    blocks.push_back(
      { "fault " + std::to_string(leaves->GetCurrentFlatIndex()), LinesOf(leaves->GetCurrentDataObject()) });
  }
  return blocks;
}
}
