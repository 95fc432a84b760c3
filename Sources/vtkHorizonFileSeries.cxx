// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFileSeries.h"

#include "vtkDataObject.h"
#include "vtkIndent.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
bool FileSeries::SetName(const char* name)
{
  std::vector<std::string> names;
  if (name)
  {
    names.emplace_back(name);
  }
  const bool isChange = names != this->Names;
  this->Names = std::move(names);
  this->Current = 0;
  return isChange;
}

//----------------------------------------------------------------------------------------------------------------------
void FileSeries::AddName(const char* name)
{
  if (name)
  {
    this->Names.emplace_back(name);
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool FileSeries::Clear()
{
  return this->SetName(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
const char* FileSeries::GetName(int index) const
{
  return index >= 0 && index < this->GetSize() ? this->Names[index].c_str() : nullptr;
}

//----------------------------------------------------------------------------------------------------------------------
void FileSeries::ChooseByTime(vtkInformation* outputInformation)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const double time =
    outputInformation->Has(Pipeline::UPDATE_TIME_STEP()) ? outputInformation->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
  const int last = std::max(0, this->GetSize() - 1);
  // nan fails both comparisons.
  this->Current = time >= last ? last : time > 0.0 ? static_cast<int>(time) : 0;
}

//----------------------------------------------------------------------------------------------------------------------
void FileSeries::Choose(vtkInformation* outputInformation)
{
  this->ChooseByTime(outputInformation);
  vtkDataObject::GetData(outputInformation)->GetInformation()->Remove(vtkDataObject::DATA_TIME_STEP());
}

//----------------------------------------------------------------------------------------------------------------------
void FileSeries::Announce(vtkInformation* outputInformation)
{
  this->ChooseByTime(outputInformation);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (this->GetSize() < 2)
  {
    outputInformation->Remove(Pipeline::TIME_STEPS());
    outputInformation->Remove(Pipeline::TIME_RANGE());
    outputInformation->Remove(Pipeline::TIME_DEPENDENT_INFORMATION());
    return;
  }
  std::vector<double> times(this->Names.size());
  std::iota(times.begin(), times.end(), 0.0);
  const std::array<double, 2> range = { times.front(), times.back() };
  outputInformation->Set(Pipeline::TIME_STEPS(), times.data(), this->GetSize());
  outputInformation->Set(Pipeline::TIME_RANGE(), range.data(), 2);
  // Files differ in horizons and extents.
  outputInformation->Set(Pipeline::TIME_DEPENDENT_INFORMATION(), 1);
}

//----------------------------------------------------------------------------------------------------------------------
void FileSeries::Mark(vtkInformation* outputInformation) const
{
  if (this->GetSize() > 1)
  {
    vtkDataObject::GetData(outputInformation)->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), this->Current);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void FileSeries::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "FileName: " << (this->Names.empty() ? "(none)" : "");
  for (std::size_t n = 0; n < this->Names.size(); ++n)
  {
    os << (n > 0 ? ", " : "") << this->Names[n];
  }
  os << '\n';
}
}
