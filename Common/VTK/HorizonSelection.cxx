// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkDataArraySelection looks for a name among all of them, one after the other, so that asking it for every name would
// take the square of their number.

#include "HorizonSelection.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace SeismicHorizons
{
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

//----------------------------------------------------------------------------------------------------------------------
void ListHorizons(const std::vector<std::string>& names, vtkDataArraySelection* selection)
{
  bool areListed = static_cast<int>(names.size()) == selection->GetNumberOfArrays();
  for (std::size_t n = 0; areListed && n < names.size(); ++n)
  {
    areListed = names[n] == selection->GetArrayName(static_cast<int>(n));
  }
  if (!areListed)
  {
    std::vector<const char*> texts(names.size());
    std::transform(names.begin(), names.end(), texts.begin(), [](const std::string& name) { return name.c_str(); });
    selection->SetArraysWithDefault(texts.data(), static_cast<int>(texts.size()), 1);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<bool> FindEnabled(const std::vector<std::string>& names, vtkDataArraySelection* selection)
{
  std::unordered_set<std::string> enabled;
  for (int index = 0; index < selection->GetNumberOfArrays(); ++index)
  {
    if (selection->GetArraySetting(index))
    {
      enabled.insert(selection->GetArrayName(index));
    }
  }
  std::vector<bool> found(names.size());
  std::transform(
    names.begin(), names.end(), found.begin(), [&enabled](const std::string& name) { return enabled.count(name) > 0; });
  return found;
}

//----------------------------------------------------------------------------------------------------------------------
void AddHorizonNames(const std::vector<std::string>& names, vtkPartitionedDataSetCollection* collection)
{
  for (const std::string& name : names)
  {
    const unsigned int position = collection->GetNumberOfPartitionedDataSets();
    vtkNew<vtkPartitionedDataSet> partitions;
    collection->SetPartitionedDataSet(position, partitions);
    collection->GetMetaData(position)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
}
}
