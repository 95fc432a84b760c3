// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFromImage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Survey/GridPlacement.h"
#include "Common/Survey/NullValues.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonName.h"
#include "MapImage.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <string>

using namespace SeismicHorizons;

namespace
{
MapImage ReadMap(vtkImageData* given)
{
  MapImage map;
  std::copy_n(given->GetExtent(), map.Extent.size(), map.Extent.begin());
  map.Place.Origin = Eigen::Vector3d(given->GetOrigin());
  map.Place.Spacing = Eigen::Vector3d(given->GetSpacing());
  std::copy_n(given->GetDirectionMatrix()->GetData(), map.Place.Direction.size(), map.Place.Direction.data());
  map.PointData = FromVTK(given->GetPointData());
  map.CellData = FromVTK(given->GetCellData());
  return map;
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
  return PlaceGrid(MakeHorizonGrid(ReadMap(image), this->ZArray ? this->ZArray : "", nulls));
}
