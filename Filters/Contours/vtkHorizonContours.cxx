// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonContours.h"

#include "ContoursStage.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonContours);

//------------------------------------------------------------------------------
void vtkHorizonContours::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  RunContours(horizon, this->Interval, outputs, monitor);
}
