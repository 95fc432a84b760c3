// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonLayersWriter.h"

#include "Common/Base/Monitor.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "Common/Text/OutputFile.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/VolumeConversion.h"
#include "LayersFile.h"
#include "Writers/XMLPrinter.h"

#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <string>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonLayersWriter);

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonLayersWriter::~vtkHorizonLayersWriter()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonLayersWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonLayersWriter::WriteData()
{
  const std::string file = this->FileName ? this->FileName : "";
  const auto write = [&](std::string& subject, const Monitor& monitor)
  {
    if (file.empty())
    {
      throw FileError(FileProblem::NoName, "no FileName, expected the path of a file");
    }
    subject = file;
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
    vtkMultiProcessController* const processes = vtkMultiProcessController::GetGlobalController();
    if (processes && processes->GetLocalProcessId() > 0 && grid->GetNumberOfCells() == 0)
    {
      return; // The first process has all data.
    }
    if (ExtensionOf(file) == "vtu") // This format holds any cells.
    {
      WriteOutputFile(file, [&](std::ostream& stream) { PrintXML<vtkXMLUnstructuredGridWriter>(grid, stream); });
      return;
    }
    WriteLayersFile(file, FromVTK(grid), monitor);
  };
  RunRequest(this, {}, file + ": more data than memory, expected fewer layers", write, Ranks(), &this->ErrorCode);
}
