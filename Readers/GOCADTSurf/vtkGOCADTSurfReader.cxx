// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGOCADTSurfReader.h"

#include "Common/Base/Monitor.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "TSurfDataSet.h"
#include "TSurfParser.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

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
  return names;
}

/// Where z grows to, and why.
std::string DescribeSense(const std::vector<TSurf>& surfaces)
{
  const auto isDown = [](const TSurf& surface) { return surface.Positive == VerticalPositive::Depth; };
  const auto down = std::count_if(surfaces.begin(), surfaces.end(), isDown);
  const bool isSaid = std::any_of(surfaces.begin(), surfaces.end(), [](const TSurf& s) { return s.HasPositive; });
  const char* const way = down == 0 ? "upwards" : "downwards";
  return std::string("z increases ") + way +
    (down > 0 && down < std::ptrdiff_t(surfaces.size()) ? " in some surfaces" : "") +
    (isSaid ? ", as ZPOSITIVE of the file says" : ", as nothing in the file says otherwise");
}
}

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
      return type && (isOwn || *type != "pline");
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
    datasets.push_back(MakeTSurfDataSet(std::move(surface)));
    monitor.Progress(0.9 + 0.1 * static_cast<double>(datasets.size()) / static_cast<double>(surfaces.size()));
  }
  return datasets;
}
