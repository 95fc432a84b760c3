// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFromImage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Survey/GridPlacement.h"
#include "Common/VTK/HorizonName.h"
#include "ImageGrid.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

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
