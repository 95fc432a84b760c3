// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFromImage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Survey/GridPlacement.h"
#include "Common/VTK/HorizonName.h"

#include "Common/Survey/HorizonGrid.h"
#include "Common/Survey/NullValues.h"
#include "Common/VTK/DataArrays.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

using namespace SeismicHorizons;

namespace SeismicHorizons
{
namespace
{
/// True for arrays of one component that are not marks of ghosts.
bool IsScalar(vtkDataArray* array)
{
  return array && array->GetNumberOfComponents() == 1 &&
    !(array->GetName() && array->GetName() == std::string(vtkDataSetAttributes::GhostArrayName()));
}

vtkDataArray* FirstScalars(vtkDataSetAttributes* data)
{
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
  {
    if (IsScalar(data->GetArray(n)))
    {
      return data->GetArray(n);
    }
  }
  return nullptr;
}

std::pair<vtkDataSetAttributes*, vtkDataArray*> FindElevation(vtkImageData* image, const std::string& name)
{
  for (vtkDataSetAttributes* const data : { static_cast<vtkDataSetAttributes*>(image->GetPointData()),
         static_cast<vtkDataSetAttributes*>(image->GetCellData()) })
  {
    vtkDataArray* array = name.empty() ? data->GetScalars() : data->GetArray(name.c_str());
    if (name.empty() && !(array && array->GetNumberOfComponents() == 1))
    {
      array = FirstScalars(data);
    }
    if (array)
    {
      return { data, array };
    }
  }
  throw InputError(name.empty() ? "an image without an array of one component, expected one with z"
                                : "no array " + name + ", expected one with z");
}

/// Columns are points, or centres of cells, half a spacing away.
SurveyLattice MakeLattice(vtkImageData* image, bool areCells)
{
  const int* const extent = image->GetExtent();
  const double* const spacing = image->GetSpacing();
  const double* const origin = image->GetOrigin();
  const vtkMatrix3x3* const direction = image->GetDirectionMatrix();
  if (direction->GetElement(2, 0) != 0.0 || direction->GetElement(2, 1) != 0.0)
  {
    throw InputError("an image that is not level, expected one whose rows and columns are level");
  }
  const int layers = extent[5] - extent[4] + (areCells ? 0 : 1);
  if (layers > 1)
  {
    throw InputError("an image of " + std::to_string(layers) + " layers, expected a map of one layer");
  }
  SurveyLattice lattice;
  const int lessPoints = areCells ? 0 : 1;
  lattice.Columns = { extent[1] - extent[0] + lessPoints, extent[3] - extent[2] + lessPoints };
  if (lattice.Columns[0] < 1 || lattice.Columns[1] < 1)
  {
    throw InputError("an image of " + std::to_string(lattice.Columns[0]) + " x " + std::to_string(lattice.Columns[1]) +
      (areCells ? " cells" : " points") + ", expected at least one each way");
  }
  lattice.ColumnStep = spacing[0] * Eigen::Vector2d(direction->GetElement(0, 0), direction->GetElement(1, 0));
  lattice.RowStep = spacing[1] * Eigen::Vector2d(direction->GetElement(0, 1), direction->GetElement(1, 1));
  const double half = areCells ? 0.5 : 0.0;
  lattice.Origin = Eigen::Vector2d(origin[0], origin[1]) + (extent[0] + half) * lattice.ColumnStep +
    (extent[2] + half) * lattice.RowStep;
  return lattice;
}

/// ParaView names heights so: in GDAL rasters and DEM files, and values of TIFF files.
bool AreElevations(vtkDataArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return name == "Elevation" || name == "Tiff Scalars";
}

std::vector<double> Values(vtkDataArray* array, int component, const NullValues& nulls)
{
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t node = 0; node < values.size(); ++node)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(node), component);
    values[node] = std::isfinite(value) && !nulls.IsNullNumber(value) ? value : NoValue;
  }
  return values;
}

void Blank(std::vector<double>& values, vtkUnsignedCharArray* ghosts, int mask)
{
  for (std::size_t node = 0; ghosts && node < values.size(); ++node)
  {
    values[node] = ghosts->GetValue(static_cast<vtkIdType>(node)) & mask ? NoValue : values[node];
  }
}

/// An empty `zArray` means the active scalars, or else the first array of one component, points before cells. Throws
/// InputError without an array, or unless the image is one level layer.
HorizonGrid MakeHorizonGrid(vtkImageData* image, const std::string& zArray, const NullValues& nulls)
{
  const auto [data, elevation] = FindElevation(image, zArray);
  const bool areCells = data == image->GetCellData();
  HorizonGrid grid;
  grid.Lattice = MakeLattice(image, areCells);
  const vtkIdType nodes = vtkIdType(grid.Lattice.Columns[0]) * grid.Lattice.Columns[1];
  RequireTuples(data, nodes, areCells ? "cells" : "points");
  grid.Survey.IsUpright = AreElevations(elevation);
  grid.Z = Values(elevation, 0, nulls);
  Blank(grid.Z, areCells ? image->GetCellGhostArray() : image->GetPointGhostArray(),
    areCells ? static_cast<int>(vtkDataSetAttributes::HIDDENCELL)
             : static_cast<int>(vtkDataSetAttributes::HIDDENPOINT));
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* const array = data->GetArray(n);
    if (IsScalar(array) && array != elevation && array->GetName())
    {
      grid.Attributes.push_back({ array->GetName(), Values(array, 0, nulls) });
    }
  }
  return grid;
}
}
}

vtkStandardNewMacro(vtkHorizonFromImage);

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonFromImage::vtkHorizonFromImage()
{
  this->SetNumberOfInputPorts(1);
}

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonFromImage::~vtkHorizonFromImage()
{
  this->SetZArray(nullptr);
  this->SetNullValues(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonFromImage::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkHorizonFromImage::ListHorizons(const Monitor&)
{
  return { HorizonName(1) };
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons vtkHorizonFromImage::ReadSurvey(const Monitor& monitor)
{
  monitor.Progress(0.0);
  auto* const image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  if (!image)
  {
    throw InputError("no input, expected an image");
  }
  const SeismicHorizons::NullValues nulls(this->NullValues ? this->NullValues : "");
  return PlaceGrid(MakeHorizonGrid(image, this->ZArray ? this->ZArray : "", nulls));
}
