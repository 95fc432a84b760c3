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
#include "Common/Parameters.h"
#include "Common/TextWords.h"
#include "Common/VTK/HorizonDataSet.h"
#include "Common/VTK/HorizonName.h"
#include "HorizonImage.h"
#include "SparseMatrixParser.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

/// Whether a name ends in .vsm, in letters of either case.
bool HasOwnExtension(const std::string& name)
{
  const std::string extension = ".vsm";
  return name.size() >= extension.size() && ToLower(name.substr(name.size() - extension.size())) == extension;
}

/// The first and last column or row; -1 stands for the last there is.
std::array<int, 2> MakeRange(const char* name, const int (&range)[2])
{
  if (range[0] < 0 || range[1] < -1 || (range[1] >= 0 && range[1] < range[0]))
  {
    throw InputError(name + std::string(" ") + std::to_string(range[0]) + " to " + std::to_string(range[1]) +
      ", expected a first number of at least 0, and a last one that is not less, or -1 for the end");
  }
  return { range[0], range[1] < 0 ? std::numeric_limits<int>::max() : range[1] };
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
  SparseMatrixVerticalFit VerticalFit;
  std::optional<SparseMatrix> Matrix; // until it is used
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
SparseMatrix vtkVerneySparseMatrixReader::Read(const Monitor& monitor) const
{
  std::ifstream stream = OpenInputFile(this->FileName);
  return ReadSparseMatrix(stream, this->MakeOptions(), monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixReader::UpdateContent(const Monitor& monitor)
{
  RequireFileName(this->FileName);
  const SparseMatrixOptions options = this->MakeOptions();
  PrefixErrors(this->FileName,
    [&]()
    {
      const FileStamp stamp = MakeFileStamp(this->FileName);
      if (this->Content && this->Content->Stamp == stamp && this->Content->Options == options)
      {
        return;
      }
      this->Content.reset();
      auto content = std::make_unique<FileContent>();
      content->Stamp = stamp;
      content->Options = options;
      content->Matrix = this->Read(monitor);
      content->VerticalFit = content->Matrix->VerticalFit;
      for (const HorizonVoxels& horizon : content->Matrix->Horizons)
      {
        content->Names.push_back(HorizonName(horizon.SurfaceId));
      }
      this->Content = std::move(content);
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
  const SparseMatrixVerticalFit& fit = this->Content->VerticalFit;
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
  this->MakeOptions();
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkVerneySparseMatrixReader::ListHorizons(const Monitor& monitor)
{
  this->UpdateContent(monitor);
  return this->Content->Names;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataObject>> vtkVerneySparseMatrixReader::MakeHorizons(
  const std::vector<int>& numbers, const Monitor& monitor)
{
  // What the list was made from is used once: kept, it would take as much memory as the output.
  std::optional<SparseMatrix> kept = std::exchange(this->Content->Matrix, std::nullopt);
  SparseMatrix matrix =
    kept ? std::move(*kept) : PrefixErrors(this->FileName, [&]() { return this->Read(monitor.Step(0.0, 0.8)); });
  const LatticePlacement fitted = this->MakeFittedPlacement();
  const HorizonPlacement placement = { matrix.Size, fitted.ToWorld(), fitted.Direction, this->Elevation == RealZ };
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
std::string vtkVerneySparseMatrixReader::ErrorPrefix()
{
  return FilePrefix(this->FileName);
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
  os << indent << "SmallestHorizonSize: " << this->SmallestHorizonSize << '\n';
  os << indent << "ColumnRange: " << this->ColumnRange[0] << " to " << this->ColumnRange[1] << '\n';
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
