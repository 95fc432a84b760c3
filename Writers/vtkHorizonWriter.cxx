// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonWriter.h"

#include "Common/Errors.h"
#include "Common/OutputFile.h"
#include "Common/VTK/PipelineRequest.h"
#include "Marshalling/HorizonTree.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <filesystem>

using namespace SeismicHorizons;

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonWriter::~vtkHorizonWriter()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonWriter::FillInputPortInformation(int, vtkInformation* info)
{
  AcceptHorizons(info);
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonWriter::WriteData()
{
  const std::string file = this->FileName ? this->FileName : "";
  const auto write = [&](std::string& subject, const Monitor& monitor)
  {
    if (file.empty())
    {
      throw InputError("no FileName, expected the path of a file");
    }
    subject = file;
    const std::vector<HorizonLeaf> leaves = ListHorizons(this->GetInput(), {});
    std::vector<NamedHorizon> horizons;
    for (const HorizonLeaf& leaf : leaves)
    {
      if (leaf.Input->GetNumberOfPoints() > 0)
      {
        const std::string name = leaf.Name.empty() ? std::filesystem::u8path(file).stem().u8string() : leaf.Name;
        horizons.push_back({ name, leaf.Input });
      }
    }
    if (horizons.empty())
    {
      throw InputError("no horizon with points, expected something to write");
    }
    WriteOutputFile(file, [&](std::ostream& stream) { this->PrintHorizons(horizons, stream, monitor); });
    this->SetErrorCode(vtkErrorCode::NoError);
  };
  this->SetErrorCode(vtkErrorCode::UnknownError); // unless the work comes to its end
  RunRequest(this, {}, file + ": more data than memory, expected fewer or smaller horizons", write);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
}
