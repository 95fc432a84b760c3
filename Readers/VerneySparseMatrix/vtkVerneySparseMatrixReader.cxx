// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parser reads files, and HorizonDataSet, HorizonImage and HorizonVolume make datasets of what it gives; here
// parameters become what they are asked for.

#include "vtkVerneySparseMatrixReader.h"

#include "Common/Errors.h"
#include "Common/InputFile.h"
#include "Common/LatticePlacement.h"
#include "Common/Monitor.h"
#include "Common/Parameters.h"
#include "Common/TextWords.h"
#include "Common/VTK/HorizonDataSet.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "HorizonImage.h"
#include "HorizonVolume.h"
#include "ImageFrame.h"
#include "SparseMatrixOverview.h"
#include "SparseMatrixParser.h"
#include "VoxelExtent.h"

#include "vtkDataObjectTypes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

/// Whether a name ends in .vsm or .vsm.gz, in letters of either case.
bool HasOwnExtension(const std::string& name)
{
  const auto endsIn = [&name](const std::string& extension)
  { return name.size() >= extension.size() && ToLower(name.substr(name.size() - extension.size())) == extension; };
  return endsIn(".vsm") || endsIn(".vsm.gz");
}

vtkSmartPointer<vtkDataObject> MakeHorizon(bool asImage, HorizonVoxels voxels, const HorizonPlacement& placement)
{
  if (asImage)
  {
    return MakeHorizonImage(voxels, placement);
  }
  return MakeHorizonPoints(std::move(voxels), placement);
}
}

// ---- The class ---------------------------------------------------------------------------------------------------
struct vtkVerneySparseMatrixReader::FileContent
{
  FileStamp Stamp;
  SparseMatrixOptions Options; // with which it was read
  std::vector<std::string> Names; // of the horizons
  std::vector<VoxelExtent> Extents; // theirs
  std::vector<std::int64_t> Sizes; // theirs: points in the ranges
  SparseMatrixSize Size = {};
  std::vector<int> SurfaceIds; // of the same, with the least memory
  SparseMatrixVerticalFit VerticalFit;
  std::optional<SparseMatrix> Matrix; // until it is used
  std::optional<SparseMatrixOverview> Overview; // in its place, with the least memory

  void Add(int surfaceId, std::int64_t size)
  {
    this->Names.push_back(HorizonName(surfaceId));
    this->Sizes.push_back(size);
  }
};

vtkStandardNewMacro(vtkVerneySparseMatrixReader);

//----------------------------------------------------------------------------------------------------------------------
vtkVerneySparseMatrixReader::vtkVerneySparseMatrixReader() = default;

//----------------------------------------------------------------------------------------------------------------------
vtkVerneySparseMatrixReader::~vtkVerneySparseMatrixReader() = default;

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::CanReadFile(const char* fileName)
{
  return HasOwnExtension(fileName ? fileName : "") ||
    IsRecognised(fileName,
      [](std::istream& stream)
      {
        ReadSparseMatrixHeader(stream);
        return true;
      });
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
void vtkVerneySparseMatrixReader::UpdateContent(const Monitor& monitor)
{
  RequireFileName(this->Files.GetCurrent());
  const SparseMatrixOptions options = this->MakeOptions();
  PrefixErrors(this->Files.GetCurrent(),
    [&]()
    {
      const FileStamp stamp = MakeFileStamp(this->Files.GetCurrent());
      if (this->Content && !this->Content->Overview && this->Content->Stamp == stamp &&
        this->Content->Options == options)
      {
        return;
      }
      this->Content.reset();
      auto content = std::make_unique<FileContent>();
      content->Stamp = stamp;
      content->Options = options;
      content->Matrix = ReadSparseMatrix(*OpenInputFile(this->Files.GetCurrent()), options, monitor);
      content->Size = content->Matrix->Size;
      content->VerticalFit = content->Matrix->VerticalFit;
      for (const HorizonVoxels& horizon : content->Matrix->Horizons)
      {
        content->Add(horizon.SurfaceId, static_cast<std::int64_t>(horizon.I.size()));
        content->Extents.push_back(FindExtent(horizon));
      }
      this->Content = std::move(content);
    });
}

//----------------------------------------------------------------------------------------------------------------------
/// Reads the file when the overview is not that of the file and the options.
void vtkVerneySparseMatrixReader::UpdateOverview(const Monitor& monitor)
{
  RequireFileName(this->Files.GetCurrent());
  const SparseMatrixOptions options = this->MakeOptions();
  const SparseMatrixOptions ofOverview = ForAllRows(options);
  PrefixErrors(this->Files.GetCurrent(),
    [&]()
    {
      const FileStamp stamp = MakeFileStamp(this->Files.GetCurrent());
      if (!this->FindOverview() || !(this->Content->Stamp == stamp) || !(this->Content->Options == ofOverview))
      {
        this->Content = std::make_unique<FileContent>();
        const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
        SparseMatrixOverview overview = ReadSparseMatrixOverview(*stream, ofOverview, monitor);
        this->Content->Stamp = stamp;
        this->Content->Options = ofOverview;
        this->Content->Size = overview.Size;
        this->Content->VerticalFit = overview.VerticalFit;
        this->Content->Overview = std::move(overview);
      }
    });
  this->Content->SurfaceIds = ListSurfaces(*this->Content->Overview, options);
  this->Content->Names.clear();
  this->Content->Sizes.clear();
  for (const int surfaceId : this->Content->SurfaceIds)
  {
    const HorizonOverview& horizon = this->FindOverview()->Horizons.at(surfaceId);
    this->Content->Add(surfaceId, horizon.CountVoxels(options.RowRange[0], options.RowRange[1]));
  }
}

//----------------------------------------------------------------------------------------------------------------------
const SparseMatrixOverview* vtkVerneySparseMatrixReader::FindOverview() const
{
  return this->Content && this->Content->Overview ? &*this->Content->Overview : nullptr;
}

//----------------------------------------------------------------------------------------------------------------------
vtkIdType vtkVerneySparseMatrixReader::GetNumberOfPointsInRows(const char* name, int firstRow, int lastRow)
{
  const auto& names = this->Content ? this->Content->Names : std::vector<std::string>();
  const std::size_t number = std::size_t(std::find(names.begin(), names.end(), name ? name : "") - names.begin());
  return !this->FindOverview() || number == names.size()
    ? 0
    : this->FindOverview()->Horizons.at(this->Content->SurfaceIds[number]).CountVoxels(firstRow, lastRow);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::GetNumberOfRows()
{
  return this->FindOverview() ? this->FindOverview()->Size[1] : 0;
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
HorizonPlacement vtkVerneySparseMatrixReader::MakeHorizonPlacement() const
{
  LatticePlacement placement = this->MakePlacement();
  const SparseMatrixVerticalFit& fit = this->Content->VerticalFit;
  if (this->Elevation == RealZ && fit.Step != 0.0)
  {
    placement.Origin.z() = static_cast<int>(placement.Direction) * fit.Offset;
    placement.VerticalStep = fit.Step;
  }
  return { this->Content->Size, placement.ToWorld(), placement.Direction, this->Elevation == RealZ };
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::CheckParameters()
{
  this->MakePlacement().Check();
  this->MakeOptions();
  CheckAtLeast<int>("VolumeMemoryLimit", this->VolumeMemoryLimit, 1, " MB");
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkVerneySparseMatrixReader::ListHorizons(const Monitor& monitor)
{
  // A volume takes far more memory than what it is made from.
  this->LeastMemory&& this->OutputType != Volume ? this->UpdateOverview(monitor) : this->UpdateContent(monitor);
  return this->Content->Names;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int64_t> vtkVerneySparseMatrixReader::CountHorizonPoints()
{
  return this->Content->Sizes;
}

//----------------------------------------------------------------------------------------------------------------------
/// Voxels of at least the horizons of some numbers in the list, in its order. What the list was made from is used once:
/// kept, it would take as much memory as the output.
SparseMatrix vtkVerneySparseMatrixReader::TakeMatrix(const std::vector<int>& numbers, const Monitor& monitor)
{
  std::optional<SparseMatrix> kept = std::exchange(this->Content->Matrix, std::nullopt);
  if (kept)
  {
    return std::move(*kept);
  }
  return PrefixErrors(this->Files.GetCurrent(),
    [&]()
    {
      const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
      return this->FindOverview() ? ReadSparseMatrixRows(*stream, *this->FindOverview(), this->MakeOptions(),
                                      this->Content->SurfaceIds, numbers, monitor)
                                  : ReadSparseMatrix(*stream, this->MakeOptions(), monitor);
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataObject>> vtkVerneySparseMatrixReader::MakeHorizons(
  const std::vector<int>& numbers, const Monitor& monitor)
{
  SparseMatrix matrix = this->TakeMatrix(numbers, monitor.Step(0.0, 0.8));
  const HorizonPlacement placement = this->MakeHorizonPlacement();
  std::vector<vtkSmartPointer<vtkDataObject>> horizons;
  for (const int number : numbers)
  {
    // Moved out of the list, so that the voxels of each horizon are freed once it is made.
    HorizonVoxels& voxels = matrix.Horizons[static_cast<std::size_t>(number)];
    horizons.push_back(MakeHorizon(this->OutputType == Images, std::move(voxels), placement));
    monitor.Progress(0.8 + 0.2 * static_cast<double>(horizons.size()) / static_cast<double>(numbers.size()));
  }
  return horizons;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkVerneySparseMatrixReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // which one depends on OutputType
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
/// The extent of a volume, which the pipeline cuts into pieces. A collection has none.
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
  VoxelExtent extent = this->VolumeExtent == Whole ? WholeExtent(this->Content->Size) : EmptyExtent;
  for (const int number : numbers)
  {
    extent = Unite(extent, this->Content->Extents[static_cast<std::size_t>(number)]);
  }
  const ImageFrame frame = MakeVolumeFrame(this->MakeHorizonPlacement().ToWorld);
  AnnounceExtent(ToImageExtent(extent, frame), outputInformation);
  // After an error the pipeline would still ask for what could not be made then.
  outputInformation->Remove(Pipeline::COMBINED_UPDATE_EXTENT());
  outputInformation->Set(vtkDataObject::ORIGIN(), frame.Origin.data(), 3);
  outputInformation->Set(vtkDataObject::SPACING(), frame.Spacing.data(), 3);
  outputInformation->Set(vtkDataObject::DIRECTION(), frame.Direction.data(), 9);
  outputInformation->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
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
  std::vector<const HorizonVoxels*> horizons;
  for (const int number : numbers)
  {
    horizons.push_back(&matrix.Horizons[static_cast<std::size_t>(number)]);
  }
  vtkDataObject::GetData(outputInformation)
    ->ShallowCopy(MakeHorizonVolume(horizons, this->MakeHorizonPlacement(), extent, options, monitor.Step(0.6, 1.0)));
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::PrintSelf(ostream& os, vtkIndent indent)
{
  constexpr std::array<const char*, 3> types = { "Points", "Images", "Volume" };
  constexpr std::array<const char*, 2> extents = { "Whole", "BoundingBox" };
  constexpr std::array<const char*, 3> volumeArrays = { "SurfaceId", "Amplitude", "Thickness" };
  constexpr std::array<const char*, 2> elevations = { "VerticalIndex", "RealZ" };
  constexpr std::array<const char*, 2> directions = { "Down", "Up" };
  constexpr std::array<const char*, 4> policies = { "StrongestAmplitude", "Topmost", "Lowest", "Sheets" };
  this->Superclass::PrintSelf(os, indent);
  this->Files.Print(os, indent);
  os << indent << "OutputType: " << types[static_cast<std::size_t>(this->OutputType)] << '\n';
  os << indent << "VolumeExtent: " << extents[static_cast<std::size_t>(this->VolumeExtent)] << '\n';
  os << indent << "VolumeArray: " << volumeArrays[static_cast<std::size_t>(this->VolumeArray)] << '\n';
  os << indent << "BackgroundValue: " << this->BackgroundValue << '\n';
  os << indent << "VolumeMemoryLimit: " << this->VolumeMemoryLimit << '\n';
  os << indent << "SmallestHorizonSize: " << this->SmallestHorizonSize << '\n';
  os << indent << "ColumnRange: " << this->ColumnRange[0] << " to " << this->ColumnRange[1] << '\n';
  os << indent << "LeastMemory: " << (this->LeastMemory ? "on" : "off") << '\n';
  os << indent << "RowRange: " << this->RowRange[0] << " to " << this->RowRange[1] << '\n';
  os << indent << "Elevation: " << elevations[static_cast<std::size_t>(this->Elevation)] << '\n';
  const LatticePlacement placement = this->MakePlacement();
  os << indent << "Origin: " << ToText(placement.Origin) << '\n';
  os << indent << "ColumnStep: " << ToText(placement.ColumnStep) << '\n';
  os << indent << "RowStep: " << ToText(placement.RowStep) << '\n';
  os << indent << "VerticalStep: " << this->VerticalStep << '\n';
  os << indent << "VerticalDirection: " << directions[static_cast<std::size_t>(this->VerticalDirection)] << '\n';
  os << indent << "DuplicatePolicy: " << policies[static_cast<std::size_t>(this->DuplicatePolicy)] << '\n';
}
