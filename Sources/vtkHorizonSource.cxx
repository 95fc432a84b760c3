// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// All horizons are made before the output is filled, so that errors and stops leave it empty.

#include "vtkHorizonSource.h"

#include "Common/Base/DealOut.h"
#include "Common/Base/Monitor.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "vtkHorizonFileSeries.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace
{
using namespace SeismicHorizons;

// vtkDataArraySelection searches names linearly, so that asking for every name would be quadratic.

bool IsListed(const std::vector<std::string>& names, vtkDataArraySelection* selection)
{
  bool isListed = static_cast<int>(names.size()) == selection->GetNumberOfArrays();
  for (std::size_t index = 0; isListed && index < names.size(); ++index)
  {
    isListed = names[index] == selection->GetArrayName(static_cast<int>(index));
  }
  return isListed;
}

/// Known names keep their setting; the selection is not marked as modified.
void SetNames(const std::vector<std::string>& names, int settingOfOthers, vtkDataArraySelection* selection)
{
  std::vector<const char*> texts(names.size());
  std::transform(names.begin(), names.end(), texts.begin(), [](const std::string& name) { return name.c_str(); });
  selection->SetArraysWithDefault(texts.data(), static_cast<int>(texts.size()), settingOfOthers);
}

/// Names keep their choice; new names are enabled. `disabled` keeps the choice for names that reappear.
void JoinNames(
  const std::vector<std::string>& names, vtkDataArraySelection* selection, std::unordered_set<std::string>& disabled)
{
  if (IsListed(names, selection))
  {
    return;
  }
  std::vector<std::string> known;
  for (int index = 0; index < selection->GetNumberOfArrays(); ++index)
  {
    const std::string name = selection->GetArrayName(index);
    if (selection->GetArraySetting(index))
    {
      disabled.erase(name);
      known.push_back(name);
    }
    else
    {
      disabled.insert(name);
    }
  }
  std::copy_if(names.begin(), names.end(), std::back_inserter(known),
    [&disabled](const std::string& name) { return disabled.count(name) > 0; });
  SetNames(known, 0, selection);
  SetNames(names, 1, selection);
}

std::vector<int> SelectHorizons(const std::vector<std::string>& names, vtkDataArraySelection* selection)
{
  std::unordered_set<std::string> enabled;
  for (int index = 0; index < selection->GetNumberOfArrays(); ++index)
  {
    if (selection->GetArraySetting(index))
    {
      enabled.insert(selection->GetArrayName(index));
    }
  }
  std::vector<int> selected;
  for (std::size_t number = 0; number < names.size(); ++number)
  {
    if (enabled.count(names[number]))
    {
      selected.push_back(static_cast<int>(number));
    }
  }
  return selected;
}

std::vector<std::int64_t> Choose(const std::vector<std::int64_t>& sizes, const std::vector<int>& numbers)
{
  std::vector<std::int64_t> chosen;
  for (const int number : numbers)
  {
    chosen.push_back(sizes.empty() ? 1 : sizes[number]);
  }
  return chosen;
}

/// Returns null for outputs other than collections, which VTK splits itself.
vtkMultiProcessController* FindController(vtkDataObject* output)
{
  vtkMultiProcessController* const all = vtkMultiProcessController::GetGlobalController();
  return all && all->GetNumberOfProcesses() > 1 && output->IsA("vtkPartitionedDataSetCollection") ? all : nullptr;
}

/// Horizons would be lost if processes had different lists. Collective.
void RequireSameList(const std::string& prefix, const std::vector<std::string>& names,
  const std::vector<std::int64_t>& sizes, const Ranks& ranks)
{
  if (ranks.Size() > 1)
  {
    std::string list;
    for (std::size_t n = 0; n < names.size(); ++n)
    {
      list += names[n] + '\0' + (sizes.empty() ? "" : std::to_string(sizes[n])) + '\0';
    }
    const std::vector<std::string> lists = ranks.Gather(list);
    const auto others = std::count_if(lists.begin(), lists.end(), [&](const auto& other) { return other != lists[0]; });
    if (others > 0)
    {
      ranks.Refuse(prefix + std::to_string(others) + " of " + std::to_string(lists.size()) +
        " processes have other horizons than the first, expected the same data on all");
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonSource::vtkHorizonSource()
{
  this->SetNumberOfInputPorts(0);
}

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonSource::~vtkHorizonSource() = default;

//----------------------------------------------------------------------------------------------------------------------
vtkDataArraySelection* vtkHorizonSource::GetHorizonSelection()
{
  return this->HorizonSelection;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonSource::GetNumberOfHorizons()
{
  return this->HorizonSelection->GetNumberOfArrays();
}

//----------------------------------------------------------------------------------------------------------------------
const char* vtkHorizonSource::GetHorizonName(int index)
{
  return this->HorizonSelection->GetArrayName(index);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonSource::GetHorizonStatus(const char* name)
{
  return this->HorizonSelection->ArrayIsEnabled(name);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonSource::SetHorizonStatus(const char* name, int status)
{
  this->HorizonSelection->SetArraySetting(name, status);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonSource::EnableAllHorizons()
{
  this->HorizonSelection->EnableAllArrays();
  this->Disabled.clear();
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonSource::DisableAllHorizons()
{
  this->HorizonSelection->DisableAllArrays();
}

//----------------------------------------------------------------------------------------------------------------------
vtkIdTypeArray* vtkHorizonSource::GetHorizonSizes()
{
  return this->HorizonSizes;
}

//----------------------------------------------------------------------------------------------------------------------
vtkMTimeType vtkHorizonSource::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->HorizonSelection->GetMTime());
}

//----------------------------------------------------------------------------------------------------------------------
std::string vtkHorizonSource::ErrorPrefix()
{
  const FileSeries* const files = this->GetFiles();
  return files ? FilePrefix(files->GetCurrent()) : std::string();
}

//----------------------------------------------------------------------------------------------------------------------
vtkTypeBool vtkHorizonSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // In a file series the request may be for another file.
  return IsForTime(request) ? this->RequestInformation(request, inputVector, outputVector)
                            : this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonSource::AnnouncePieces(vtkInformationVector* outputs)
{
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonSource::AskForWholeInput(vtkInformationVector** inputs)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    AskForWhole(inputs[port]);
  }
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonSource::RequestInformation(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  AnnouncePieces(outputVector);
  if (FileSeries* const files = this->GetFiles())
  {
    files->Announce(info);
  }
  const int done = RunRequest(this, { vtkDataObject::GetData(outputVector) },
    this->ErrorPrefix() + "more data than memory, expected fewer or smaller horizons",
    AnnounceLater(request,
      WatchInformation(this, this->IsInformationStopped,
        [this, info](std::string&, const Monitor& monitor)
        {
          const std::vector<std::string> names = this->NameHorizons(monitor);
          this->List(names);
          this->DescribeOutput(SelectHorizons(names, this->HorizonSelection), info);
        })),
    Ranks(), &this->ErrorCode);
  // A process that returned 0 would miss collective calls; RequestData() reports the failure.
  return done || FindController(vtkDataObject::GetData(info)) ? 1 : 0;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonSource::DescribeOutput(const std::vector<int>&, vtkInformation*) {}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkHorizonSource::NameHorizons(const Monitor& monitor)
{
  std::vector<std::string> names = this->ListHorizons(monitor);
  for (std::size_t number = 0; number < names.size(); ++number)
  {
    // Selections and metadata would truncate the name.
    if (names[number].find('\0') != std::string::npos)
    {
      throw FileError(FileProblem::WrongContent,
        this->ErrorPrefix() + "zero byte in the name of horizon " + std::to_string(number + 1) + ", expected text");
    }
  }
  return MakeDistinct(std::move(names));
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonSource::List(const std::vector<std::string>& names)
{
  JoinNames(names, this->HorizonSelection, this->Disabled);
  const std::vector<std::int64_t> sizes = this->CountHorizonPoints();
  this->HorizonSizes->SetNumberOfValues(static_cast<vtkIdType>(sizes.size()));
  std::copy(sizes.begin(), sizes.end(), this->HorizonSizes->GetPointer(0));
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonSource::MakeOutput(const std::vector<std::string>& names, const std::vector<int>& numbers,
  vtkInformation* outputInformation, const Monitor& monitor)
{
  const int piece = outputInformation->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const int numberOfPieces =
    std::max(1, outputInformation->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
  const std::vector<int> pieceOf = DealOut(Choose(this->CountHorizonPoints(), numbers), numberOfPieces);
  const vtkSmartPointer<vtkPartitionedDataSetCollection> horizons = MakeCollection("Horizons");
  std::vector<int> own;
  std::vector<unsigned int> positions; // in the collection
  for (std::size_t n = 0; n < numbers.size(); ++n)
  {
    AddName(horizons, names[numbers[n]]);
    if (pieceOf[n] == piece)
    {
      own.push_back(numbers[n]);
      positions.push_back(static_cast<unsigned int>(n));
    }
  }
  const std::vector<vtkSmartPointer<vtkDataObject>> made = this->MakeHorizons(own, monitor);
  assert(made.size() <= positions.size());
  for (std::size_t n = 0; n < made.size(); ++n)
  {
    horizons->SetPartition(positions[n], 0, made[n]);
  }
  vtkDataObject::GetData(outputInformation)->ShallowCopy(horizons);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonSource::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  FileSeries* const files = this->GetFiles();
  if (files)
  {
    files->Choose(info);
  }
  const Ranks ranks(FindController(vtkDataObject::GetData(info)), request, outputVector);
  const auto work = [&](std::string&, const Monitor& monitor)
  {
    std::vector<std::string> names;
    ranks.Together(
      [&]()
      {
        StopLikeInformation(this, this->IsInformationStopped);
        this->CheckParameters();
        // The data may have changed since RequestInformation.
        names = this->NameHorizons(monitor.Step(0.0, 0.5));
        this->List(names);
        if (names.empty())
        {
          throw InputError(this->ErrorPrefix() + "no points, expected those of a horizon");
        }
      });
    RequireSameList(this->ErrorPrefix(), names, this->CountHorizonPoints(), ranks);
    this->MakeOutput(names, SelectHorizons(names, this->HorizonSelection), info, monitor.Step(0.5, 1.0));
    if (files)
    {
      files->Mark(info);
    }
  };
  return RunRequest(this, { vtkDataObject::GetData(info) },
    this->ErrorPrefix() + "more data than memory, expected fewer or smaller horizons", work, ranks, &this->ErrorCode);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HorizonSelection:\n";
  this->HorizonSelection->PrintSelf(os, indent.GetNextIndent());
}
