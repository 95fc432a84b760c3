// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parser reads files, and HorizonDataSet and HorizonImage make datasets of what it gives; here parameters become
// what they are asked for.

#include "vtkVerneySparseMatrixReader.h"

#include "Common/Errors.h"
#include "Common/InputFile.h"
#include "Common/LatticePlacement.h"
#include "Common/Monitor.h"
#include "Common/VTK/HorizonName.h"
#include "HorizonDataSet.h"
#include "HorizonImage.h"
#include "SparseMatrixParser.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string>
#include <string_view>
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

/// The horizons with these numbers, by ascending ID.
SparseMatrixCounts Select(const SparseMatrixCounts& horizons, const std::vector<int>& numbers)
{
  SparseMatrixCounts selected;
  int number = 0;
  for (const auto& horizon : horizons)
  {
    if (selected.size() < numbers.size() && numbers[selected.size()] == number)
    {
      selected.insert(horizon);
    }
    ++number;
  }
  return selected;
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
struct vtkVerneySparseMatrixReader::FileSummary
{
  FileStamp Stamp;
  SparseMatrixSummary Content;
};

vtkStandardNewMacro(vtkVerneySparseMatrixReader);

//----------------------------------------------------------------------------------------------------------------------
vtkVerneySparseMatrixReader::vtkVerneySparseMatrixReader() = default;

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
void vtkVerneySparseMatrixReader::CheckParameters()
{
  this->MakePlacement().Check();
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkVerneySparseMatrixReader::ListHorizons(const Monitor& monitor)
{
  this->UpdateSummary(monitor);
  std::vector<std::string> names;
  for (const auto& horizon : this->Summary->Content.VoxelCounts)
  {
    names.push_back(HorizonName(horizon.first));
  }
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataObject>> vtkVerneySparseMatrixReader::MakeHorizons(
  const std::vector<int>& numbers, const Monitor& monitor)
{
  SparseMatrix matrix = PrefixErrors(this->FileName,
    [&]()
    {
      std::ifstream stream = OpenInputFile(this->FileName);
      return LoadSparseMatrix(stream, Select(this->Summary->Content.VoxelCounts, numbers),
        static_cast<SeismicHorizons::DuplicatePolicy>(this->DuplicatePolicy), monitor.Step(0.0, 0.8));
    });
  const LatticePlacement fitted = this->MakeFittedPlacement();
  const HorizonPlacement placement = { matrix.Size, fitted.ToWorld(), fitted.Direction, this->Elevation == RealZ };
  std::vector<vtkSmartPointer<vtkDataObject>> horizons;
  for (HorizonVoxels& voxels : matrix.Horizons)
  {
    // Moved out of the list, so that the voxels of each horizon are freed once it is made.
    horizons.push_back(MakeHorizon(this->OutputType == Images, std::move(voxels), placement));
    monitor.Progress(0.8 + 0.2 * static_cast<double>(horizons.size()) / static_cast<double>(numbers.size()));
  }
  return horizons;
}

//----------------------------------------------------------------------------------------------------------------------
std::string vtkVerneySparseMatrixReader::ErrorPrefix()
{
  return (this->FileName ? this->FileName : "") + std::string(": ");
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
}
