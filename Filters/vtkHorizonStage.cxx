// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonStage.h"

#include "Common/VTK/HorizonTree.h"

#include "vtkMultiProcessController.h"

//------------------------------------------------------------------------------
vtkHorizonStage::vtkHorizonStage()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
vtkHorizonStage::~vtkHorizonStage() = default;

//------------------------------------------------------------------------------
void vtkHorizonStage::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkHorizonStage::GetController()
{
  return this->Controller;
}

//------------------------------------------------------------------------------
int vtkHorizonStage::FillInputPortInformation(int, vtkInformation* info)
{
  SeismicHorizons::AcceptHorizons(info);
  return 1;
}
