// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFaultLinesWriter.h"

#include "FaultLinesFile.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkFaultLinesWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkFaultLinesWriter::WriteFiles(
  const std::string& path, const std::vector<WrittenHorizon>& lines, const Monitor& monitor, std::string& subject)
{
  WriteFaultLines(path, ToPlain(lines), static_cast<WrittenSense>(this->VerticalPositive), monitor, subject);
}
