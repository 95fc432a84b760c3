// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkVerneySparseMatrixWriter.h"

#include "Common/Base/Monitor.h"
#include "HorizonMatrix.h"
#include "SparseMatrixPrinter.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkVerneySparseMatrixWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixWriter::PrintHorizons(
  const std::vector<WrittenHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  const WrittenMatrix written = MakeSparseMatrix(ToPlain(horizons), monitor.Step(0.0, 0.5));
  for (const std::string& warning : written.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  PrintSparseMatrix(written.Matrix, stream, monitor.Step(0.5, 1.0));
}
