// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parser reads files, and HorizonDataSet and HorizonImage make datasets of what it gives; here parameters become
// what they are asked for. All horizons are made before the first of them goes into the output, so that an error or a
// stop leaves no part of them there.

#include "vtkVerneySparseMatrixReader.h"

#include "Common/Errors.h"
#include "Common/InputFile.h"
#include "Common/LatticePlacement.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "HorizonDataSet.h"
#include "HorizonImage.h"
#include "SparseMatrixParser.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

/// Whether a name ends in .vsm, in letters of either case.
bool HasOwnExtension(const std::string& name)
{
  constexpr std::string_view extension = ".vsm";
  return name.size() >= extension.size() &&
    std::equal(extension.rbegin(), extension.rend(), name.rbegin(),
      [](char own, char other) { return own == std::tolower(static_cast<unsigned char>(other)); });
}

// vtkDataArraySelection looks for a name among all of them, one after the other, so that asking it for every name would
// take the square of their number.

/// Lists the horizons. Those that were in the list before keep their choice, others are enabled.
void List(const SparseMatrixCounts& horizons, vtkDataArraySelection* selection)
{
  std::vector<std::string> names;
  bool areListed = static_cast<int>(horizons.size()) == selection->GetNumberOfArrays();
  for (const auto& horizon : horizons)
  {
    names.push_back(HorizonName(horizon.first));
    areListed = areListed && names.back() == selection->GetArrayName(static_cast<int>(names.size()) - 1);
  }
  if (!areListed)
  {
    std::vector<const char*> texts(names.size());
    std::transform(names.begin(), names.end(), texts.begin(), [](const std::string& name) { return name.c_str(); });
    selection->SetArraysWithDefault(texts.data(), static_cast<int>(texts.size()), 1);
  }
}

/// The horizons whose names are enabled.
SparseMatrixCounts Select(const SparseMatrixCounts& horizons, vtkDataArraySelection* selection)
{
  std::unordered_set<std::string> enabled;
  for (int index = 0; index < selection->GetNumberOfArrays(); ++index)
  {
    if (selection->GetArraySetting(index))
    {
      enabled.insert(selection->GetArrayName(index));
    }
  }
  SparseMatrixCounts selected;
  for (const auto& horizon : horizons)
  {
    if (enabled.count(HorizonName(horizon.first)))
    {
      selected.insert(horizon);
    }
  }
  return selected;
}

/// The horizons of one of several pieces: the first piece has the first horizon, the second piece the second one, and
/// after the last piece it is the first one's turn again.
SparseMatrixCounts DealOut(const SparseMatrixCounts& horizons, int piece, int numberOfPieces)
{
  SparseMatrixCounts dealt;
  int next = 0;
  for (const auto& horizon : horizons)
  {
    if (next == piece)
    {
      dealt.insert(horizon);
    }
    next = (next + 1) % numberOfPieces;
  }
  return dealt;
}

/// Adds an empty partitioned dataset for each horizon, with its name.
void AddNames(vtkPartitionedDataSetCollection* collection, const SparseMatrixCounts& horizons)
{
  for (const auto& horizon : horizons)
  {
    const unsigned int position = collection->GetNumberOfPartitionedDataSets();
    vtkNew<vtkPartitionedDataSet> partitions;
    collection->SetPartitionedDataSet(position, partitions);
    collection->GetMetaData(position)->Set(vtkCompositeDataSet::NAME(), HorizonName(horizon.first).c_str());
  }
}

vtkSmartPointer<vtkDataObject> MakeHorizon(bool asImage, HorizonVoxels voxels, const HorizonPlacement& placement)
{
  if (asImage)
  {
    return MakeHorizonImage(voxels, placement);
  }
  return MakeHorizonPoints(std::move(voxels), placement);
}

/// Runs the work of a request; an error or a stop leaves the output empty.
int Run(vtkVerneySparseMatrixReader* reader, vtkInformationVector* outputVector, const RequestWork& work)
{
  const std::string file = reader->GetFileName() ? reader->GetFileName() : "";
  return RunRequest(reader, { vtkDataObject::GetData(outputVector) },
    file + ": more data than memory, expected fewer or smaller horizons", work);
}
}

// ---- The class ---------------------------------------------------------------------------------------------------
struct vtkVerneySparseMatrixReader::FileSummary
{
  FileStamp Stamp;
  SparseMatrixSummary Content;
};

vtkStandardNewMacro(vtkVerneySparseMatrixReader);

//----------------------------------------------------------------------------------------------------------------------
vtkVerneySparseMatrixReader::vtkVerneySparseMatrixReader()
{
  this->SetNumberOfInputPorts(0);
}

//----------------------------------------------------------------------------------------------------------------------
vtkVerneySparseMatrixReader::~vtkVerneySparseMatrixReader()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::CanReadFile(const char* fileName)
{
  const std::string name = fileName ? fileName : "";
  if (HasOwnExtension(name))
  {
    return 1;
  }
  try
  {
    MakeFileStamp(name); // refuses what is no regular file
    std::ifstream stream = OpenInputFile(name);
    ReadSparseMatrixHeader(stream);
    return 1;
  }
  catch (const InputError&)
  {
    return 0;
  }
}

//----------------------------------------------------------------------------------------------------------------------
vtkDataArraySelection* vtkVerneySparseMatrixReader::GetHorizonSelection()
{
  return this->HorizonSelection;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::GetNumberOfHorizons()
{
  return this->HorizonSelection->GetNumberOfArrays();
}

//----------------------------------------------------------------------------------------------------------------------
const char* vtkVerneySparseMatrixReader::GetHorizonName(int index)
{
  return this->HorizonSelection->GetArrayName(index);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::GetHorizonStatus(const char* name)
{
  return this->HorizonSelection->ArrayIsEnabled(name);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::SetHorizonStatus(const char* name, int status)
{
  this->HorizonSelection->SetArraySetting(name, status);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::EnableAllHorizons()
{
  this->HorizonSelection->EnableAllArrays();
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::DisableAllHorizons()
{
  this->HorizonSelection->DisableAllArrays();
}

//----------------------------------------------------------------------------------------------------------------------
vtkMTimeType vtkVerneySparseMatrixReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->HorizonSelection->GetMTime());
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::UpdateSummary(const Monitor& monitor)
{
  if (!this->FileName)
  {
    throw InputError("no FileName, expected the path of a file");
  }
  PrefixErrors(this->FileName,
    [&]()
    {
      const FileStamp stamp = MakeFileStamp(this->FileName);
      if (this->Summary && this->Summary->Stamp == stamp)
      {
        return;
      }
      this->Summary.reset();
      std::ifstream stream = OpenInputFile(this->FileName);
      this->Summary = std::make_unique<FileSummary>(FileSummary{ stamp, ScanSparseMatrix(stream, monitor) });
    });
  List(this->Summary->Content.VoxelCounts, this->HorizonSelection);
}

//----------------------------------------------------------------------------------------------------------------------
LatticePlacement vtkVerneySparseMatrixReader::MakePlacement() const
{
  LatticePlacement placement;
  placement.Origin = Eigen::Vector3d(this->Origin);
  placement.ColumnStep = Eigen::Vector2d(this->ColumnStep);
  placement.RowStep = Eigen::Vector2d(this->RowStep);
  placement.VerticalStep = this->VerticalStep;
  using Direction = SeismicHorizons::VerticalDirection;
  placement.Direction = this->VerticalDirection == Up ? Direction::Up : Direction::Down;
  return placement;
}

//----------------------------------------------------------------------------------------------------------------------
/// With real z, heights are those of the line that fits it; where there is none, those of the parameters.
LatticePlacement vtkVerneySparseMatrixReader::MakeFittedPlacement() const
{
  LatticePlacement placement = this->MakePlacement();
  const SparseMatrixVerticalFit& fit = this->Summary->Content.VerticalFit;
  if (this->Elevation == RealZ && fit.Step != 0.0)
  {
    placement.Origin.z() = static_cast<int>(placement.Direction) * fit.Offset;
    placement.VerticalStep = fit.Step;
  }
  return placement;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return Run(this, outputVector, [this](std::string&, const Monitor& monitor) { this->UpdateSummary(monitor); });
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::Load(
  int piece, int numberOfPieces, vtkPartitionedDataSetCollection* output, const Monitor& monitor)
{
  this->MakePlacement().Check();
  this->UpdateSummary(monitor.Step(0.0, 0.5)); // in case the file has changed since the information was asked for
  const SparseMatrixCounts selected = Select(this->Summary->Content.VoxelCounts, this->HorizonSelection);
  SparseMatrix matrix = PrefixErrors(this->FileName,
    [&]()
    {
      std::ifstream stream = OpenInputFile(this->FileName);
      return LoadSparseMatrix(stream, DealOut(selected, piece, numberOfPieces),
        static_cast<SeismicHorizons::DuplicatePolicy>(this->DuplicatePolicy), monitor.Step(0.5, 0.9));
    });

  const LatticePlacement fitted = this->MakeFittedPlacement();
  const HorizonPlacement placement = { matrix.Size, fitted.ToWorld(), fitted.Direction, this->Elevation == RealZ };
  vtkNew<vtkPartitionedDataSetCollection> horizons;
  AddNames(horizons, selected);
  auto position = static_cast<unsigned int>(piece); // as the horizons were dealt out
  for (HorizonVoxels& voxels : matrix.Horizons)
  {
    // Moved out of the list, so that the voxels of each horizon are freed once it is made.
    horizons->SetPartition(position, 0, MakeHorizon(this->OutputType == Images, std::move(voxels), placement));
    monitor.Progress(0.9 + 0.1 * (position + 1) / static_cast<double>(selected.size()));
    position += static_cast<unsigned int>(numberOfPieces);
  }
  output->ShallowCopy(horizons);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  const int piece = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const int numberOfPieces = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
  auto* const output = vtkPartitionedDataSetCollection::GetData(outputVector);
  return Run(this, outputVector,
    [&](std::string&, const Monitor& monitor) { this->Load(piece, std::max(1, numberOfPieces), output, monitor); });
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::PrintSelf(ostream& os, vtkIndent indent)
{
  constexpr std::array<const char*, 2> types = { "Points", "Images" };
  constexpr std::array<const char*, 2> elevations = { "VerticalIndex", "RealZ" };
  constexpr std::array<const char*, 2> directions = { "Down", "Up" };
  constexpr std::array<const char*, 3> policies = { "StrongestAmplitude", "Topmost", "Lowest" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "OutputType: " << types[static_cast<std::size_t>(this->OutputType)] << '\n';
  os << indent << "Elevation: " << elevations[static_cast<std::size_t>(this->Elevation)] << '\n';
  const LatticePlacement placement = this->MakePlacement();
  os << indent << "Origin: " << ToText(placement.Origin) << '\n';
  os << indent << "ColumnStep: " << ToText(placement.ColumnStep) << '\n';
  os << indent << "RowStep: " << ToText(placement.RowStep) << '\n';
  os << indent << "VerticalStep: " << this->VerticalStep << '\n';
  os << indent << "VerticalDirection: " << directions[static_cast<std::size_t>(this->VerticalDirection)] << '\n';
  os << indent << "DuplicatePolicy: " << policies[static_cast<std::size_t>(this->DuplicatePolicy)] << '\n';
  os << indent << "HorizonSelection:\n";
  this->HorizonSelection->PrintSelf(os, indent.GetNextIndent());
}
