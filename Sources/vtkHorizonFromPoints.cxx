// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFromPoints.h"

#include "Common/Base/Monitor.h"
#include "Common/VTK/HorizonName.h"
#include "PickColumns.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <utility>

using namespace SeismicHorizons;

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
  const std::pair<ColumnRole, const char*> given[] = { { ColumnRole::X, this->XArray }, { ColumnRole::Y, this->YArray },
    { ColumnRole::Z, this->ZArray }, { ColumnRole::Inline, this->InlineArray },
    { ColumnRole::Crossline, this->CrosslineArray }, { ColumnRole::HorizonName, this->NameArray } };
  for (const auto& [role, name] : given)
  {
    if (name && *name)
    {
      choice[role] = name;
    }
  }
  const SeismicHorizons::NullValues nulls(this->NullValues ? this->NullValues : "");
  this->Picks = std::make_unique<PickTable>(MakePickTable(this->GetInputDataObject(0, 0), choice, nulls));
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
  return std::move(*std::exchange(this->Picks, nullptr));
}
