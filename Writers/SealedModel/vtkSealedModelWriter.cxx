// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSealedModelWriter.h"

#include "Common/Text/FileErrors.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/PipelineRequest.h"
#include "SealedModelFile.h"

#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkSealedModelWriter);

//----------------------------------------------------------------------------------------------------------------------
vtkSealedModelWriter::~vtkSealedModelWriter()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkSealedModelWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkSealedModelWriter::WriteData()
{
  const std::string file = this->FileName ? this->FileName : "";
  const auto write = [&](std::string& subject, const Monitor& monitor)
  {
    if (file.empty())
    {
      throw FileError(FileProblem::NoName, "no FileName, expected the path of a file");
    }
    subject = file;
    auto* const surfaces = vtkPolyData::SafeDownCast(this->GetInput());
    vtkMultiProcessController* const processes = vtkMultiProcessController::GetGlobalController();
    if (processes && processes->GetLocalProcessId() > 0 && surfaces->GetNumberOfCells() == 0)
    {
      return; // The first process has all data.
    }
    WriteSealedModel(file, FromVTK(surfaces), monitor);
  };
  RunRequest(this, {}, file + ": more data than memory, expected fewer triangles", write, Ranks(), &this->ErrorCode);
}
