// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonGridWriter.h"

#include "Common/Monitor.h"
#include "GridWriters.h"
#include "HorizonSampling.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonGridWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonGridWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  const NamedHorizon& horizon = horizons.front();
  HorizonGrid grid = SampleHorizon(horizon.Data, this->VerticalSign(horizon.Data), monitor.Step(0.0, 0.5));
  grid.Name = horizon.Name;
  (this->Format == Zmap ? WriteZmap : WriteIrapText)(stream, grid, monitor.Step(0.5, 1.0));
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonGridWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Format: " << (this->Format == Zmap ? "Zmap" : "IrapText") << '\n';
}
