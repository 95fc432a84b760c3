// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parser knows the format; this file turns parameters into what it is asked for, and its result into datasets.
// Nothing reaches the output before all of it is there, so an error or a stop can not leave a part.

#include "vtkVerneySparseMatrixReader.h"

#include "Common/VTK/ProgressMonitor.h"
#include "HorizonDataSet.h"
#include "HorizonImage.h"
#include "SparseMatrixParser.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

// ---- Files -------------------------------------------------------------------------------------------------------
/// What tells that a file is still the one that was read.
struct FileStamp
{
  std::string Name;
  std::filesystem::file_time_type Time;
  std::uintmax_t Size = 0;

  bool operator==(const FileStamp& other) const
  {
    return this->Name == other.Name && this->Time == other.Time && this->Size == other.Size;
  }
};

FileStamp GetStamp(const std::string& name)
{
  const std::filesystem::path path = std::filesystem::u8path(name);
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status))
  {
    throw InputError("nothing there, expected a file");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw InputError(std::filesystem::is_directory(status) ? "a directory, expected a file"
                                                           : "a special file, expected a regular one");
  }
  return { name, std::filesystem::last_write_time(path, ignored), std::filesystem::file_size(path, ignored) };
}

std::ifstream OpenFile(const std::string& name)
{
  std::ifstream stream(std::filesystem::u8path(name), std::ios::binary);
  if (!stream)
  {
    throw InputError("a file that can not be opened, expected a readable one");
  }
  return stream;
}

/// Runs work on a file so that its errors start with the name of the file.
template <typename Work>
void WorkOnFile(const std::string& name, Work work)
{
  try
  {
    work();
  }
  catch (const InputError& error)
  {
    throw InputError(name + ": " + error.what());
  }
}

// ---- Parameters --------------------------------------------------------------------------------------------------
std::string HorizonName(int surfaceId)
{
  return "Horizon " + std::to_string(surfaceId);
}

std::string ToText(const double* vector, int size)
{
  std::ostringstream text;
  for (int component = 0; component < size; ++component)
  {
    text << (component == 0 ? "(" : ", ") << vector[component];
  }
  text << ')';
  return text.str();
}

bool IsFinite(const double* vector, int size)
{
  return std::all_of(vector, vector + size, [](double component) { return std::isfinite(component); });
}

/// Whether two steps are too close to parallel to span a lattice: a billionth of a right angle, or of no length.
bool AreParallel(const double* a, const double* b)
{
  const double product = std::hypot(a[0], a[1]) * std::hypot(b[0], b[1]);
  return !(std::abs(a[0] * b[1] - a[1] * b[0]) > 1e-9 * product);
}

// ---- Horizons ----------------------------------------------------------------------------------------------------
SparseMatrixCounts Select(const SparseMatrixCounts& horizons, vtkDataArraySelection* selection)
{
  SparseMatrixCounts selected;
  for (const auto& horizon : horizons)
  {
    if (selection->ArrayIsEnabled(HorizonName(horizon.first).c_str()))
    {
      selected.insert(horizon);
    }
  }
  return selected;
}

/// The horizons of one of several pieces, which take them in turn.
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

/// Gives the collection a named place for each horizon.
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
  try
  {
    GetStamp(fileName ? fileName : "");
    std::ifstream stream = OpenFile(fileName);
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
/// Runs work so that an exception becomes an error, or a quiet end when the user wants it, and an empty output.
template <typename Work>
int vtkVerneySparseMatrixReader::Guard(vtkInformationVector* outputVector, Work work)
{
  std::string problem;
  try
  {
    work();
    return 1;
  }
  catch (const Aborted&)
  {
  }
  catch (const std::bad_alloc&)
  {
    problem = std::string(this->FileName) + ": more data than memory, expected fewer or smaller horizons";
  }
  catch (const InputError& error)
  {
    problem = error.what();
  }
  if (auto output = vtkPartitionedDataSetCollection::GetData(outputVector))
  {
    output->Initialize();
  }
  if (problem.empty())
  {
    return 1;
  }
  vtkErrorMacro(<< problem);
  return 0;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::CheckParameters() const
{
  if (!IsFinite(this->Origin, 3))
  {
    throw InputError("Origin " + ToText(this->Origin, 3) + ", expected finite numbers");
  }
  if (!IsFinite(this->ColumnStep, 2) || !IsFinite(this->RowStep, 2) || AreParallel(this->ColumnStep, this->RowStep))
  {
    throw InputError("ColumnStep " + ToText(this->ColumnStep, 2) + " and RowStep " + ToText(this->RowStep, 2) +
      ", expected finite vectors that are not parallel");
  }
  if (!std::isfinite(this->VerticalStep) || this->VerticalStep == 0.0)
  {
    throw InputError("VerticalStep " + ToText(&this->VerticalStep, 1) + ", expected a finite number other than 0");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::UpdateSummary(const Monitor& monitor)
{
  if (!this->FileName)
  {
    throw InputError("no FileName, expected the path of a file");
  }
  WorkOnFile(this->FileName,
    [&]()
    {
      const FileStamp stamp = GetStamp(this->FileName);
      if (this->Summary && this->Summary->Stamp == stamp)
      {
        return;
      }
      this->Summary.reset();
      std::ifstream stream = OpenFile(this->FileName);
      this->Summary = std::make_unique<FileSummary>(FileSummary{ stamp, ScanSparseMatrix(stream, monitor) });
    });

  std::vector<std::string> names;
  for (const auto& horizon : this->Summary->Content.VoxelCounts)
  {
    names.push_back(HorizonName(horizon.first));
  }
  std::vector<const char*> texts(names.size());
  std::transform(names.begin(), names.end(), texts.begin(), [](const std::string& name) { return name.c_str(); });
  this->HorizonSelection->SetArraysWithDefault(texts.data(), static_cast<int>(texts.size()), 1);
}

//----------------------------------------------------------------------------------------------------------------------
SeismicHorizons::LatticeMatrix vtkVerneySparseMatrixReader::MakeLatticeToWorld() const
{
  SparseMatrixVerticalFit vertical{ this->Origin[2], this->VerticalStep };
  if (this->Elevation == RealZ && this->Summary->Content.VerticalFit.Step != 0.0)
  {
    vertical = this->Summary->Content.VerticalFit;
  }
  return { this->ColumnStep[0], this->RowStep[0], 0.0, this->Origin[0], //
    this->ColumnStep[1], this->RowStep[1], 0.0, this->Origin[1], //
    0.0, 0.0, vertical.Step, vertical.Offset, //
    0.0, 0.0, 0.0, 1.0 };
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return this->Guard(outputVector, [this]() { this->UpdateSummary(MakeMonitor(this)); });
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::Load(int piece, int numberOfPieces, vtkPartitionedDataSetCollection* output)
{
  const Monitor monitor = MakeMonitor(this);
  this->CheckParameters();
  this->UpdateSummary(monitor.Step(0.0, 0.5)); // in case the file has changed since the information was asked for

  const SparseMatrixCounts selected = Select(this->Summary->Content.VoxelCounts, this->HorizonSelection);
  SparseMatrix matrix;
  WorkOnFile(this->FileName,
    [&]()
    {
      std::ifstream stream = OpenFile(this->FileName);
      matrix = LoadSparseMatrix(stream, DealOut(selected, piece, numberOfPieces),
        static_cast<SeismicHorizons::DuplicatePolicy>(this->DuplicatePolicy), monitor.Step(0.5, 0.9));
    });

  const LatticeMatrix toWorld = this->MakeLatticeToWorld();
  const bool useRealZ = this->Elevation == RealZ;
  vtkNew<vtkPartitionedDataSetCollection> horizons;
  AddNames(horizons, selected);
  for (HorizonVoxels& voxels : matrix.Horizons)
  {
    const auto position = static_cast<unsigned int>(std::distance(selected.begin(), selected.find(voxels.SurfaceId)));
    HorizonVoxels taken = std::move(voxels); // so that memory is freed horizon by horizon
    vtkSmartPointer<vtkDataObject> horizon;
    if (this->OutputType == Images)
    {
      horizon = MakeHorizonImage(taken, matrix.Size, toWorld, useRealZ);
    }
    else
    {
      horizon = MakeHorizonPoints(std::move(taken), matrix.Size, toWorld, useRealZ);
    }
    horizons->SetPartition(position, 0, horizon);
    monitor.Progress(0.9 + 0.1 * (position + 1) / static_cast<double>(selected.size()));
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
  return this->Guard(outputVector,
    [&]() { this->Load(piece, std::max(1, numberOfPieces), vtkPartitionedDataSetCollection::GetData(outputVector)); });
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::PrintSelf(ostream& os, vtkIndent indent)
{
  constexpr std::array<const char*, 2> types = { "Points", "Images" };
  constexpr std::array<const char*, 2> elevations = { "VerticalIndex", "RealZ" };
  constexpr std::array<const char*, 3> policies = { "StrongestAmplitude", "Topmost", "Lowest" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "OutputType: " << types[static_cast<std::size_t>(this->OutputType)] << '\n';
  os << indent << "Elevation: " << elevations[static_cast<std::size_t>(this->Elevation)] << '\n';
  os << indent << "Origin: " << ToText(this->Origin, 3) << '\n';
  os << indent << "ColumnStep: " << ToText(this->ColumnStep, 2) << '\n';
  os << indent << "RowStep: " << ToText(this->RowStep, 2) << '\n';
  os << indent << "VerticalStep: " << this->VerticalStep << '\n';
  os << indent << "DuplicatePolicy: " << policies[static_cast<std::size_t>(this->DuplicatePolicy)] << '\n';
  os << indent << "HorizonSelection:\n";
  this->HorizonSelection->PrintSelf(os, indent.GetNextIndent());
}
