// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonWriter.h"

#include "Common/Text/FileErrors.h"
#include "Common/Text/OutputFile.h"
#include "Common/Text/TextWords.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Filters/Marshalling/RankedHorizons.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <list>
#include <unordered_set>

using namespace SeismicHorizons;

namespace
{
/// All processes, if they write together, or this one alone.
Ranks RanksOf(bool areTogether)
{
  return areTogether ? Ranks(vtkMultiProcessController::GetGlobalController()) : Ranks();
}

/// Underscores replace characters that some file systems forbid; other alphabets remain.
std::string MakeFileName(std::string text)
{
  const auto isKept = [](char c)
  {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::isalnum(byte) || c == '.' || c == '+' || c == '-';
  };
  std::replace_if(
    text.begin(), text.end(), [&](char c) { return !isKept(c); }, '_');
  return text;
}

std::string Shorten(const std::string& text, std::size_t most)
{
  std::size_t size = std::min(text.size(), most);
  while (size > 0 && size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U)
  {
    --size;
  }
  return text.substr(0, size);
}

/// Names that differ in case alone are equal on some systems, and get a number, as equal names do.
template <typename Horizons>
std::vector<std::string> NameFiles(const std::string& file, const Horizons& horizons)
{
  const std::filesystem::path path = std::filesystem::u8path(file);
  constexpr std::size_t longest = 255; // Bytes of a name that all usual systems allow.
  constexpr std::size_t numberSize = 12;
  const std::string stem = path.stem().u8string() + '_';
  const std::string extension = path.extension().u8string();
  const std::size_t taken = std::min(longest - 1, stem.size() + extension.size() + numberSize);
  std::vector<std::string> names;
  std::unordered_set<std::string> small;
  for (const auto& horizon : horizons)
  {
    const std::string first = Shorten(MakeFileName(horizon.Name), longest - taken);
    std::string name = first;
    for (int number = 2; !small.insert(ToLower(name)).second; ++number)
    {
      name = first + " (" + std::to_string(number) + ')';
    }
    names.push_back((path.parent_path() / std::filesystem::u8path(stem + name + extension)).u8string());
  }
  return names;
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
void vtkHorizonWriter::WriteFiles(const std::vector<std::string>& names, const std::vector<NamedHorizon>& horizons,
  const Monitor& monitor, std::string& subject)
{
  std::list<OutputFile> files;
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    const auto part = [&](std::size_t number) { return double(number) / double(names.size()); };
    subject = names[n];
    files.emplace_back(names[n],
      [&](std::ostream& stream) { this->PrintHorizons({ horizons[n] }, stream, monitor.Step(part(n), part(n + 1))); });
  }
  auto name = names.begin();
  for (OutputFile& file : files)
  {
    subject = *name++;
    file.Keep();
  }
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
void vtkHorizonWriter::WriteHorizons(
  const std::vector<NamedHorizon>& horizons, const Monitor& monitor, std::string& subject)
{
  for (const auto& [name, data] : horizons)
  {
    PrefixErrors(name, [&horizon = data]() { CheckArraySizes(horizon); });
  }
  if (horizons.empty())
  {
    throw InputError("no horizon with points, expected something to write");
  }
  if (!this->WritesFileForEach() || horizons.size() == 1)
  {
    WriteOutputFile(this->FileName, [&](std::ostream& stream) { this->PrintHorizons(horizons, stream, monitor); });
  }
  else
  {
    this->WriteFiles(NameFiles(this->FileName, horizons), horizons, monitor, subject);
  }
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
    std::vector<NamedHorizon> horizons;
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
      this->WriteHorizons(horizons, monitor, subject);
    }
  };
  RunRequest(
    this, {}, file + ": more data than memory, expected fewer or smaller horizons", write, ranks, &this->ErrorCode);
}
