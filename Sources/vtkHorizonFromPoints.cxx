// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFromPoints.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Survey/NullValues.h"
#include "Common/Survey/PickTable.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonName.h"
#include "PickArrays.h"

#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkTable.h"

#include <cassert>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
PickArrays ReadArrays(vtkDataObject* data)
{
  PickArrays picks;
  if (auto* const table = vtkTable::SafeDownCast(data))
  {
    picks.Arrays = FromVTK(table->GetRowData());
    picks.Rows = table->GetNumberOfRows();
    return picks;
  }
  auto* const points = vtkPointSet::SafeDownCast(data);
  if (!points)
  {
    throw InputError("no input, expected a table or points");
  }
  picks.Arrays = FromVTK(points->GetPointData());
  picks.Rows = points->GetNumberOfPoints();
  if (points->GetPoints())
  {
    picks.Points = FromVTK(points->GetPoints()->GetData());
  }
  return picks;
}
}

vtkStandardNewMacro(vtkHorizonFromPoints);

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonFromPoints::vtkHorizonFromPoints()
{
  this->SetNumberOfInputPorts(1);
}

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonFromPoints::~vtkHorizonFromPoints()
{
  this->SetXArray(nullptr);
  this->SetYArray(nullptr);
  this->SetZArray(nullptr);
  this->SetInlineArray(nullptr);
  this->SetCrosslineArray(nullptr);
  this->SetNameArray(nullptr);
  this->SetNullValues(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonFromPoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkHorizonFromPoints::ListNames(const Monitor& monitor)
{
  monitor.Progress(0.0);
  ColumnChoice choice;
  const std::pair<FieldRole, const char*> given[] = { { FieldRole::X, this->XArray }, { FieldRole::Y, this->YArray },
    { FieldRole::Z, this->ZArray }, { FieldRole::Inline, this->InlineArray },
    { FieldRole::Crossline, this->CrosslineArray }, { FieldRole::HorizonName, this->NameArray } };
  for (const auto& [role, name] : given)
  {
    if (name && *name)
    {
      choice[role] = name;
    }
  }
  const SeismicHorizons::NullValues nulls(this->NullValues ? this->NullValues : "");
  this->Picks = std::make_unique<PickTable>(MakePickTable(ReadArrays(this->GetInputDataObject(0, 0)), choice, nulls));
  this->PickTime.Modified();
  std::vector<std::string> names = this->Picks->Names;
  for (std::size_t number = 0; number < names.size(); ++number)
  {
    names[number] = names[number].empty() ? HorizonName(static_cast<std::int64_t>(number) + 1) : names[number];
  }
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int64_t> vtkHorizonFromPoints::CountPicks()
{
  return this->Picks->CountPicks();
}

//----------------------------------------------------------------------------------------------------------------------
vtkMTimeType vtkHorizonFromPoints::GetPickTime()
{
  return this->PickTime.GetMTime();
}

//----------------------------------------------------------------------------------------------------------------------
PickTable vtkHorizonFromPoints::ReadPicks(const Monitor&)
{
  assert(this->Picks);
  return std::move(*std::exchange(this->Picks, nullptr));
}
