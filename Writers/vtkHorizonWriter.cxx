// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonWriter.h"

#include "Common/FileErrors.h"
#include "Common/OutputFile.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "Marshalling/HorizonTree.h"

#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <list>

using namespace SeismicHorizons;

namespace
{
/// The same text with underscores for what names of files can not have on some system; bytes of other alphabets stay.
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

/// A file for each horizon beside the given one. Names that are the same get a number.
template <typename Horizons>
std::vector<std::string> NameFiles(const std::string& file, const Horizons& horizons)
{
  const std::filesystem::path path = std::filesystem::u8path(file);
  std::vector<std::string> names;
  for (const auto& horizon : horizons)
  {
    names.push_back(MakeFileName(horizon.Name));
  }
  names = MakeDistinct(names);
  for (std::string& name : names)
  {
    const std::string stem = path.stem().u8string() + '_' + name + path.extension().u8string();
    name = (path.parent_path() / std::filesystem::u8path(stem)).u8string();
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
void vtkHorizonWriter::WriteData()
{
  const std::string file = this->FileName ? this->FileName : "";
  const auto write = [&](std::string& subject, const Monitor& monitor)
  {
    if (file.empty())
    {
      throw FileError(FileProblem::NoName, "no FileName, expected the path of a file");
    }
    subject = file;
    const std::vector<HorizonLeaf> leaves = ListHorizons(this->GetInput(), {});
    std::vector<NamedHorizon> horizons;
    for (const HorizonLeaf& leaf : leaves)
    {
      if (leaf.Input->GetNumberOfPoints() > 0)
      {
        const std::string name = leaf.Name.empty() ? std::filesystem::u8path(file).stem().u8string() : leaf.Name;
        PrefixErrors(name, [&]() { CheckArraySizes(leaf.Input); });
        horizons.push_back({ name, leaf.Input });
      }
    }
    if (horizons.empty())
    {
      throw InputError("no horizon with points, expected something to write");
    }
    if (!this->WritesFileForEach() || horizons.size() == 1)
    {
      WriteOutputFile(file, [&](std::ostream& stream) { this->PrintHorizons(horizons, stream, monitor); });
    }
    else
    {
      this->WriteFiles(NameFiles(file, horizons), horizons, monitor, subject);
    }
  };
  RunRequest(
    this, {}, file + ": more data than memory, expected fewer or smaller horizons", write, Ranks(), &this->ErrorCode);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
}
