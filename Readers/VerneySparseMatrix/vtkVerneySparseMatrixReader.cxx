// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Translates parameters for SparseMatrixFile, which reads, and for HorizonDataSet, HorizonMap and HorizonVolume.

#include "vtkVerneySparseMatrixReader.h"

#include "Common/Base/Monitor.h"
#include "Common/Base/Parameters.h"
#include "Common/Survey/HorizonDataSet.h"
#include "Common/Survey/LatticeFrame.h"
#include "Common/Survey/Units.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/ImageConversion.h"
#include "Common/VTK/PipelineRequest.h"
#include "HorizonMap.h"
#include "HorizonVolume.h"
#include "SparseMatrixFile.h"
#include "SparseMatrixParser.h"

#include "vtkDataObjectTypes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

/// A range that begins outside the lattice would silently give nothing.
void CheckBegins(const char* range, int first, const char* lines, int size)
{
  if (first > 0 && first >= size)
  {
    throw InputError(std::string(range) + " from " + std::to_string(first) + ", expected a first number below the " +
      std::to_string(size) + " " + lines + " of the file");
  }
}

VoxelExtent Unite(const VoxelExtent& a, const VoxelExtent& b)
{
  if (a == EmptyExtent || b == EmptyExtent)
  {
    return a == EmptyExtent ? b : a;
  }
  return { std::min(a[0], b[0]), std::max(a[1], b[1]), std::min(a[2], b[2]), std::max(a[3], b[3]), std::min(a[4], b[4]),
    std::max(a[5], b[5]) };
}

VoxelExtent WholeExtent(const SparseMatrixSize& size)
{
  return { 0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1 };
}

const char* GivenText(const char* value)
{
  return value ? value : "";
}

vtkSmartPointer<vtkImageData> MakeImage(const LatticeImage& plain)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  ToVTK(plain, image);
  return image;
}

vtkSmartPointer<vtkDataObject> MakeHorizon(bool asImage, LatticeHorizon voxels, const LatticeFrame& frame)
{
  if (asImage)
  {
    return MakeImage(MakeHorizonMap(voxels, frame));
  }
  return ToVTK(MakeHorizonPoints(std::move(voxels), frame));
}
}

// ---- The class ---------------------------------------------------------------------------------------------------
vtkStandardNewMacro(vtkVerneySparseMatrixReader);

//----------------------------------------------------------------------------------------------------------------------
vtkVerneySparseMatrixReader::vtkVerneySparseMatrixReader()
  : File(MakeSparseMatrixFile(this->FileHasOverview))
{
}

//----------------------------------------------------------------------------------------------------------------------
vtkVerneySparseMatrixReader::~vtkVerneySparseMatrixReader()
{
  this->SetVerticalUnit(nullptr);
  this->SetVerticalDomain(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::CanReadFile(const char* fileName)
{
  return ExtensionOf(fileName ? fileName : "") == "vsm" || IsRecognised(fileName, BeginsAsSparseMatrix);
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixOptions vtkVerneySparseMatrixReader::MakeOptions() const
{
  CheckAtLeast<vtkIdType>("SmallestHorizonSize", this->SmallestHorizonSize, 1, " point");
  SparseMatrixOptions options;
  options.Policy = static_cast<SeismicHorizons::DuplicatePolicy>(this->DuplicatePolicy);
  options.ColumnRange = MakeRange("ColumnRange", this->ColumnRange);
  options.RowRange = MakeRange("RowRange", this->RowRange);
  options.SmallestSize = this->SmallestHorizonSize;
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
vtkIdType vtkVerneySparseMatrixReader::GetNumberOfPointsInRows(const char* name, int firstRow, int lastRow)
{
  const auto& horizons = this->File->Horizons();
  const auto place = std::find_if(horizons.begin(), horizons.end(),
    [name](const ListedHorizon& horizon) { return name && HorizonName(horizon.SurfaceId) == name; });
  return place == horizons.end()
    ? 0
    : static_cast<vtkIdType>(this->File->CountVoxels(place - horizons.begin(), firstRow, lastRow));
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::GetNumberOfRows()
{
  return this->File->CountRows();
}

//----------------------------------------------------------------------------------------------------------------------
LatticeFrame vtkVerneySparseMatrixReader::MakeGivenFrame() const
{
  LatticeFrame frame;
  frame.Lattice.Origin = Eigen::Vector2d(this->Origin);
  frame.Lattice.ColumnStep = Eigen::Vector2d(this->ColumnStep);
  frame.Lattice.RowStep = Eigen::Vector2d(this->RowStep);
  using Direction = SeismicHorizons::VerticalDirection;
  frame.Direction = this->VerticalDirection == Up ? Direction::Up : Direction::Down;
  frame.Sampling.First = static_cast<int>(frame.Direction) * this->Origin[2];
  frame.Sampling.Step = this->VerticalStep;
  frame.UseRealZ = this->ZFrom == RealZ;
  SeismicHorizons::SetVerticalUnit(frame.Survey, GivenText(this->VerticalUnit));
  frame.Survey.VerticalDomain = *GivenText(this->VerticalDomain) ? this->VerticalDomain : frame.Survey.VerticalDomain;
  return frame;
}

//----------------------------------------------------------------------------------------------------------------------
/// Heights follow the line fitted to real z, or else the parameters.
LatticeFrame vtkVerneySparseMatrixReader::MakeFrame() const
{
  LatticeFrame frame = this->MakeGivenFrame();
  const SparseMatrixVerticalFit& fit = this->File->VerticalFit();
  if (frame.UseRealZ && fit.Step != 0.0)
  {
    frame.Sampling.First = fit.Offset;
    frame.Sampling.Step = fit.Step;
  }
  const auto [columns, rows, indices] = this->File->Size();
  frame.Lattice.Columns = { columns, rows };
  frame.Sampling.Indices = indices;
  return frame;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::CheckParameters()
{
  this->MakeGivenFrame().Check();
  this->MakeOptions();
  CheckAtLeast<int>("VolumeMemoryLimit", this->VolumeMemoryLimit, 1, " MB");
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkVerneySparseMatrixReader::ListHorizons(const Monitor& monitor)
{
  // A volume takes far more memory than its source.
  const bool withOverview = this->LeastMemory && this->OutputType != Volume;
  if (withOverview && this->DuplicatePolicy == Sheets)
  {
    throw InputError("DuplicatePolicy Sheets with LeastMemory, expected another policy: sheets take the whole horizon");
  }
  if (withOverview != this->FileHasOverview)
  {
    this->File = MakeSparseMatrixFile(withOverview);
    this->FileHasOverview = withOverview;
  }
  const char* const name = this->Files.GetCurrent();
  RequireFileName(name);
  const SparseMatrixOptions options = this->MakeOptions();
  PrefixFileErrors(name, [&]() { this->File->List(name, options, monitor); });
  const auto [columns, rows, indices] = this->File->Size();
  CheckBegins("ColumnRange", this->ColumnRange[0], "columns", columns);
  CheckBegins("RowRange", this->RowRange[0], "rows", rows);
  std::vector<std::string> names;
  for (const ListedHorizon& horizon : this->File->Horizons())
  {
    names.push_back(HorizonName(horizon.SurfaceId));
  }
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int64_t> vtkVerneySparseMatrixReader::CountHorizonPoints()
{
  std::vector<std::int64_t> sizes;
  for (const ListedHorizon& horizon : this->File->Horizons())
  {
    sizes.push_back(horizon.Size);
  }
  return sizes;
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrix vtkVerneySparseMatrixReader::TakeMatrix(const std::vector<int>& numbers, const Monitor& monitor)
{
  return PrefixFileErrors(this->Files.GetCurrent(), [&]() { return this->File->Take(numbers, monitor); });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataObject>> vtkVerneySparseMatrixReader::MakeHorizons(
  const std::vector<int>& numbers, const Monitor& monitor)
{
  SparseMatrix matrix = this->TakeMatrix(numbers, monitor.Step(0.0, 0.8));
  const LatticeFrame frame = this->MakeFrame();
  std::vector<vtkSmartPointer<vtkDataObject>> horizons;
  for (const int number : numbers)
  {
    // Moving frees the voxels of a horizon once it is converted.
    LatticeHorizon& voxels = matrix.Horizons[number];
    horizons.push_back(MakeHorizon(this->OutputType == Images, std::move(voxels), frame));
    monitor.Progress(0.8 + 0.2 * static_cast<double>(horizons.size()) / static_cast<double>(numbers.size()));
  }
  return horizons;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // The type depends on OutputType.
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  const char* const type = this->OutputType == Volume ? "vtkImageData" : "vtkPartitionedDataSetCollection";
  vtkDataObject* const output = vtkDataObject::GetData(info);
  if (!output || !output->IsA(type))
  {
    const auto fresh = vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
    info->Set(vtkDataObject::DATA_OBJECT(), fresh);
  }
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
/// The pipeline splits a volume by its extent; a collection has none.
void vtkVerneySparseMatrixReader::DescribeOutput(const std::vector<int>& numbers, vtkInformation* outputInformation)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (this->OutputType != Volume)
  {
    outputInformation->Remove(Pipeline::WHOLE_EXTENT());
    outputInformation->Remove(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT());
    return;
  }
  this->CheckParameters();
  VoxelExtent extent = this->VolumeExtent == Whole ? WholeExtent(this->File->Size()) : EmptyExtent;
  for (const int number : numbers)
  {
    extent = Unite(extent, this->File->Horizons()[number].Extent);
  }
  const ImageFrame frame = MakeVolumeFrame(this->MakeFrame().ToWorld());
  AnnounceImage(ToImageExtent(extent, frame), frame, outputInformation);
  // After an error the pipeline would otherwise request an output that cannot be made.
  outputInformation->Remove(Pipeline::COMBINED_UPDATE_EXTENT());
  outputInformation->Remove(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST());
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::MakeOutput(const std::vector<std::string>& names, const std::vector<int>& numbers,
  vtkInformation* outputInformation, const Monitor& monitor)
{
  if (this->OutputType != Volume)
  {
    this->Superclass::MakeOutput(names, numbers, outputInformation, monitor);
    return;
  }
  VoxelExtent extent = EmptyExtent;
  outputInformation->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
  const VolumeOptions options = { static_cast<VolumeAttribute>(this->VolumeArray), this->BackgroundValue,
    this->VolumeMemoryLimit };
  CheckVolumeMemory(extent, options);
  const SparseMatrix matrix = this->TakeMatrix(numbers, monitor.Step(0.0, 0.6));
  std::vector<const LatticeHorizon*> horizons;
  for (const int number : numbers)
  {
    horizons.push_back(&matrix.Horizons[number]);
  }
  const LatticeImage volume = MakeHorizonVolume(horizons, this->MakeFrame(), extent, options, monitor.Step(0.6, 1.0));
  vtkDataObject::GetData(outputInformation)->ShallowCopy(MakeImage(volume));
}
