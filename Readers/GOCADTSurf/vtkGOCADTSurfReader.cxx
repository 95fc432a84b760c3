// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parser reads files, and TSurfDataSet makes datasets of what it gives. All surfaces are made before the first of
// them goes into the output, so that an error or a stop leaves no part of them there.

#include "vtkGOCADTSurfReader.h"

#include "Common/Errors.h"
#include "Common/InputFile.h"
#include "Common/VTK/HorizonSelection.h"
#include "Common/VTK/PipelineRequest.h"
#include "TSurfDataSet.h"
#include "TSurfParser.h"

#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

/// A name for each surface of a file.
std::vector<std::string> NamesOf(const TSurfList& list)
{
  std::vector<std::string> names = list.Names;
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    if (names[n].empty())
    {
      names[n] = "TSurf " + std::to_string(n + 1);
    }
  }
  return MakeDistinct(std::move(names));
}

/// Runs the work of a request; an error or a stop leaves the output empty.
int Run(vtkGOCADTSurfReader* reader, vtkInformationVector* outputVector, const RequestWork& work)
{
  const std::string file = reader->GetFileName() ? reader->GetFileName() : "";
  return RunRequest(reader, { vtkDataObject::GetData(outputVector) },
    file + ": more data than memory, expected fewer or smaller surfaces", work);
}
}

// ---- The class ---------------------------------------------------------------------------------------------------
struct vtkGOCADTSurfReader::FileList
{
  FileStamp Stamp;
  std::vector<std::string> Names;
};

vtkStandardNewMacro(vtkGOCADTSurfReader);

//----------------------------------------------------------------------------------------------------------------------
vtkGOCADTSurfReader::vtkGOCADTSurfReader()
{
  this->SetNumberOfInputPorts(0);
}

//----------------------------------------------------------------------------------------------------------------------
vtkGOCADTSurfReader::~vtkGOCADTSurfReader()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkGOCADTSurfReader::CanReadFile(const char* fileName)
{
  try
  {
    const std::string name = fileName ? fileName : "";
    MakeFileStamp(name); // refuses what is no regular file
    std::ifstream stream = OpenInputFile(name);
    return BeginsAsGOCAD(stream) ? 1 : 0;
  }
  catch (const InputError&)
  {
    return 0;
  }
}

//----------------------------------------------------------------------------------------------------------------------
vtkDataArraySelection* vtkGOCADTSurfReader::GetHorizonSelection()
{
  return this->HorizonSelection;
}

//----------------------------------------------------------------------------------------------------------------------
int vtkGOCADTSurfReader::GetNumberOfHorizons()
{
  return this->HorizonSelection->GetNumberOfArrays();
}

//----------------------------------------------------------------------------------------------------------------------
const char* vtkGOCADTSurfReader::GetHorizonName(int index)
{
  return this->HorizonSelection->GetArrayName(index);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkGOCADTSurfReader::GetHorizonStatus(const char* name)
{
  return this->HorizonSelection->ArrayIsEnabled(name);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkGOCADTSurfReader::SetHorizonStatus(const char* name, int status)
{
  this->HorizonSelection->SetArraySetting(name, status);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkGOCADTSurfReader::EnableAllHorizons()
{
  this->HorizonSelection->EnableAllArrays();
}

//----------------------------------------------------------------------------------------------------------------------
void vtkGOCADTSurfReader::DisableAllHorizons()
{
  this->HorizonSelection->DisableAllArrays();
}

//----------------------------------------------------------------------------------------------------------------------
vtkMTimeType vtkGOCADTSurfReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->HorizonSelection->GetMTime());
}

//----------------------------------------------------------------------------------------------------------------------
void vtkGOCADTSurfReader::UpdateList(const Monitor& monitor)
{
  if (!this->FileName)
  {
    throw InputError("no FileName, expected the path of a file");
  }
  PrefixErrors(this->FileName,
    [&]()
    {
      const FileStamp stamp = MakeFileStamp(this->FileName);
      if (!this->List || !(this->List->Stamp == stamp))
      {
        this->List.reset();
        std::ifstream stream = OpenInputFile(this->FileName);
        this->List = std::make_unique<FileList>(FileList{ stamp, NamesOf(ListTSurfs(stream, monitor)) });
      }
    });
  ListHorizons(this->List->Names, this->HorizonSelection);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkGOCADTSurfReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return Run(this, outputVector, [this](std::string&, const Monitor& monitor) { this->UpdateList(monitor); });
}

//----------------------------------------------------------------------------------------------------------------------
void vtkGOCADTSurfReader::Load(
  int piece, int numberOfPieces, vtkPartitionedDataSetCollection* output, const Monitor& monitor)
{
  this->UpdateList(monitor.Step(0.0, 0.1)); // in case the file has changed since the information was asked for
  const std::vector<bool> isEnabled = FindEnabled(this->List->Names, this->HorizonSelection);
  std::vector<std::string> selected;
  std::vector<bool> isLoaded(isEnabled.size());
  for (std::size_t n = 0; n < isEnabled.size(); ++n)
  {
    if (isEnabled[n])
    {
      isLoaded[n] = static_cast<int>(selected.size()) % numberOfPieces == piece;
      selected.push_back(this->List->Names[n]);
    }
  }
  std::vector<TSurf> surfaces = PrefixErrors(this->FileName,
    [&]()
    {
      std::ifstream stream = OpenInputFile(this->FileName);
      return LoadTSurfs(
        stream, [&](std::size_t n) { return n < isLoaded.size() && isLoaded[n]; }, monitor.Step(0.1, 0.9));
    });

  vtkNew<vtkPartitionedDataSetCollection> collection;
  AddHorizonNames(selected, collection);
  auto position = static_cast<unsigned int>(piece); // as the surfaces were dealt out
  for (TSurf& surface : surfaces)
  {
    // Moved out of the list, so that each surface is freed once its dataset is made.
    collection->SetPartition(position, 0, MakeTSurfDataSet(std::move(surface)));
    monitor.Progress(0.9 + 0.1 * (position + 1) / static_cast<double>(selected.size()));
    position += static_cast<unsigned int>(numberOfPieces);
  }
  output->ShallowCopy(collection);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkGOCADTSurfReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  const int piece = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const int numberOfPieces = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
  auto* const output = vtkPartitionedDataSetCollection::GetData(outputVector);
  return Run(this, outputVector,
    [&](std::string&, const Monitor& monitor) { this->Load(piece, std::max(1, numberOfPieces), output, monitor); });
}

//----------------------------------------------------------------------------------------------------------------------
void vtkGOCADTSurfReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "HorizonSelection:\n";
  this->HorizonSelection->PrintSelf(os, indent.GetNextIndent());
}
