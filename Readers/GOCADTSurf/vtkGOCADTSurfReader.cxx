// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGOCADTSurfReader.h"

#include "Common/Base/Monitor.h"
#include "Common/Survey/TSurf.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "Common/VTK/HorizonConversion.h"
#include "TSurfHorizon.h"
#include "TSurfParser.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

// ---- The class ---------------------------------------------------------------------------------------------------
struct vtkGOCADTSurfReader::FileList
{
  FileStamp Stamp;
  std::vector<std::string> Names;
  std::vector<std::int64_t> Lines;
};

vtkStandardNewMacro(vtkGOCADTSurfReader);

//----------------------------------------------------------------------------------------------------------------------
vtkGOCADTSurfReader::vtkGOCADTSurfReader() = default;

//----------------------------------------------------------------------------------------------------------------------
vtkGOCADTSurfReader::~vtkGOCADTSurfReader() = default;

//----------------------------------------------------------------------------------------------------------------------
int vtkGOCADTSurfReader::CanReadFile(const char* fileName)
{
  const bool isOwn = ExtensionOf(fileName ? fileName : "") == "ts";
  return IsRecognised(fileName,
    [isOwn](std::istream& stream)
    {
      const std::optional<std::string> type = FirstTypeOfGOCAD(stream);
      return type && (isOwn || (*type != "pline" && *type != "vset"));
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkGOCADTSurfReader::ListHorizons(const Monitor& monitor)
{
  RequireFileName(this->Files.GetCurrent());
  PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      const FileStamp stamp = MakeFileStamp(this->Files.GetCurrent());
      if (!this->List || !(this->List->Stamp == stamp))
      {
        this->List.reset();
        const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
        TSurfList found = ListTSurfs(*stream, monitor);
        this->List = std::make_unique<FileList>(FileList{ stamp, NamesOf(found), std::move(found.Lines) });
      }
    });
  return this->List->Names;
}

//----------------------------------------------------------------------------------------------------------------------
/// Lines estimate sizes, since vertices are known only after reading.
std::vector<std::int64_t> vtkGOCADTSurfReader::CountHorizonPoints()
{
  return this->List->Lines;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataObject>> vtkGOCADTSurfReader::MakeHorizons(
  const std::vector<int>& numbers, const Monitor& monitor)
{
  const auto isChosen = [&numbers](std::size_t number)
  { return std::binary_search(numbers.begin(), numbers.end(), static_cast<int>(number)); };
  std::vector<TSurf> surfaces = PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
      return LoadTSurfs(*stream, isChosen, monitor.Step(0.0, 0.9));
    });
  this->Description = DescribeSense(surfaces);
  std::vector<vtkSmartPointer<vtkDataObject>> datasets;
  for (TSurf& surface : surfaces)
  {
    // Moving frees each surface after its conversion.
    datasets.push_back(ToVTK(MakeTSurfHorizon(std::move(surface))));
    monitor.Progress(0.9 + 0.1 * static_cast<double>(datasets.size()) / static_cast<double>(surfaces.size()));
  }
  return datasets;
}
