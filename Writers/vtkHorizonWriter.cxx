// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonWriter.h"

#include "Common/Horizon/NamedHorizon.h"
#include "Common/Text/FileErrors.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/RankedHorizons.h"
#include "Common/VTK/Ranks.h"
#include "HorizonFiles.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <filesystem>

using namespace SeismicHorizons;

namespace
{
/// All processes, if they write together, or this one alone.
Ranks RanksOf(bool areTogether)
{
  return areTogether ? Ranks(vtkMultiProcessController::GetGlobalController()) : Ranks();
}
}

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
/// By default each process of a writer would request all data.
vtkTypeBool vtkHorizonWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const input = inputVector[0]->GetInformationObject(0);
  if (request->Has(Pipeline::REQUEST_UPDATE_EXTENT()) && input)
  {
    const Ranks ranks = RanksOf(this->Gathered);
    input->Set(Pipeline::UPDATE_PIECE_NUMBER(), ranks.Own());
    input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), ranks.Size());
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<NamedHorizon> vtkHorizonWriter::ToPlain(const std::vector<WrittenHorizon>& horizons)
{
  std::vector<NamedHorizon> plain;
  for (const WrittenHorizon& horizon : horizons)
  {
    plain.push_back({ horizon.Name, FromVTK(horizon.Data) });
  }
  return plain;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonWriter::WriteFiles(
  const std::string& path, const std::vector<WrittenHorizon>& horizons, const Monitor& monitor, std::string& subject)
{
  const auto print = [this](const std::vector<WrittenHorizon>& some, std::ostream& stream, const Monitor& step)
  { this->PrintHorizons(some, stream, step); };
  WriteHorizonFiles(path, horizons, this->WritesFileForEach(), print, monitor, subject);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonWriter::WriteData()
{
  const std::string file = this->FileName ? this->FileName : "";
  const Ranks ranks = RanksOf(this->Gathered);
  const auto write = [&](std::string& subject, const Monitor& monitor)
  {
    if (file.empty())
    {
      throw FileError(FileProblem::NoName, "no FileName, expected the path of a file");
    }
    subject = file;
    std::vector<HorizonLeaf> leaves;
    ranks.Together([&]() { leaves = ListHorizons(this->GetInput(), {}); });
    std::vector<WrittenHorizon> horizons;
    std::vector<vtkSmartPointer<vtkPolyData>> received;
    for (const RankedHorizon& horizon : ListOnRanks(leaves, ranks))
    {
      if (horizon.Points == 0)
      {
        continue;
      }
      if (ranks.Own() > 0)
      {
        if (horizon.Rank == ranks.Own())
        {
          ranks.Send(leaves[horizon.Leaf].Input, 0);
        }
        continue;
      }
      received.push_back(horizon.Rank == 0 ? leaves[horizon.Leaf].Input : vtkSmartPointer<vtkPolyData>::New());
      if (horizon.Rank > 0)
      {
        ranks.Receive(received.back(), horizon.Rank);
      }
      const std::string name = horizon.Name.empty() ? std::filesystem::u8path(file).stem().u8string() : horizon.Name;
      horizons.push_back({ name, received.back() });
    }
    if (ranks.Own() == 0)
    {
      for (const WrittenHorizon& horizon : horizons)
      {
        PrefixErrors(horizon.Name, [&]() { CheckArraySizes(horizon.Data); });
      }
      this->WriteFiles(file, horizons, monitor, subject);
    }
  };
  RunRequest(
    this, {}, file + ": more data than memory, expected fewer or smaller horizons", write, ranks, &this->ErrorCode);
}
