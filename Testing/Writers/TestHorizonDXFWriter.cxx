// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The writer of drawings: its groups are taken apart again, counted, and compared with the meshes.

#include "Filters/HorizonFixtures.h"
#include "Readers/FileFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkHorizonDXFWriter.h"
#include "vtkMultiBlockDataSet.h"

#include <cmath>
#include <map>
#include <sstream>

using namespace FileFixtures;
using HorizonFixtures::Errors;

namespace
{
/// The folder for files of this test.
std::string Folder;

/// Two triangles over four points and a line.
vtkSmartPointer<vtkPolyData> MakeMesh(double x)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(x, 6079543.1, -1500.125);
  points->InsertNextPoint(x + 1.0 / 3.0, 6079543.0, -1e-9);
  points->InsertNextPoint(x + 12.5, 6079555.5, 1.0);
  points->InsertNextPoint(x, 6079555.5, 2000000.0);
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 0, 2, 3 });
  mesh->SetPolys(triangles);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  mesh->SetLines(lines);
  return mesh;
}

using Group = std::pair<int, std::string>;

std::vector<Group> ReadGroups(const std::string& file)
{
  std::istringstream lines(ReadText(file));
  std::vector<Group> groups;
  std::string code;
  std::string value;
  while (std::getline(lines, code) && std::getline(lines, value))
  {
    groups.emplace_back(std::stoi(code), value);
  }
  return groups;
}

/// The faces of each layer: 12 numbers for each.
std::map<std::string, std::vector<double>> ReadFaces(const std::vector<Group>& groups)
{
  std::map<std::string, std::vector<double>> faces;
  std::string entity;
  std::string layer;
  for (const auto& [code, value] : groups)
  {
    entity = code == 0 ? value : entity;
    if (entity == "3DFACE" && code == 8)
    {
      layer = value;
    }
    else if (entity == "3DFACE" && code >= 10)
    {
      CHECK_EQUAL(code, 10 * (int(faces[layer].size()) % 3 + 1) + int(faces[layer].size()) / 3 % 4);
      faces[layer].push_back(std::stod(value));
    }
  }
  return faces;
}

vtkSmartPointer<vtkHorizonDXFWriter> MakeWriter(vtkDataObject* input, const std::string& name)
{
  auto writer = vtkSmartPointer<vtkHorizonDXFWriter>::New();
  writer->SetInputDataObject(input);
  writer->SetFileName((Folder + '/' + name).c_str());
  return writer;
}

/// Names of layers: what they cannot have, too long, the same but for case, and of the file.
void HorizonsAreLayers()
{
  const std::string longName(40, 'n');
  const std::vector<std::string> names = { "Top Reek/1", "top_reek_1", "", longName, longName + "2", "H\xC3\xB6lle" };
  const std::vector<std::string> layers = { "Top_Reek_1", "top_reek_1_2", "drawing_x", std::string(31, 'n'),
    std::string(29, 'n') + "_2", "H_lle" };
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int n = 0; n < names.size(); ++n)
  {
    blocks->SetBlock(n, MakeMesh(604321.25 + n));
    blocks->GetMetaData(n)->Set(vtkCompositeDataSet::NAME(), names[n].c_str());
  }
  blocks->SetBlock(unsigned(names.size()), vtkNew<vtkPolyData>()); // is left out
  const auto writer = MakeWriter(blocks, "drawing x.dxf");
  CHECK_EQUAL(writer->Write(), 1);
  const std::vector<Group> groups = ReadGroups(writer->GetFileName());
  CHECK(groups.front() == Group(0, "SECTION") && groups.back() == Group(0, "EOF"));
  CHECK(std::count(groups.begin(), groups.end(), Group(1, "AC1009")) == 1);
  CHECK(std::count(groups.begin(), groups.end(), Group(0, "3DFACE")) == 12);
  CHECK(std::count(groups.begin(), groups.end(), Group(0, "SECTION")) == 3);
  CHECK(std::count(groups.begin(), groups.end(), Group(0, "ENDSEC")) == 3);
  CHECK(std::count(groups.begin(), groups.end(), Group(0, "LAYER")) == 6);
  const auto faces = ReadFaces(groups);
  CHECK_EQUAL(faces.size(), layers.size());
  for (std::size_t n = 0; n < layers.size(); ++n)
  {
    CHECK(std::count(groups.begin(), groups.end(), Group(2, layers[n])) == 1);
    CHECK(faces.count(layers[n]) == 1);
    const auto mesh = MakeMesh(604321.25 + double(n));
    std::vector<double> expected; // the last corner twice
    for (const vtkIdType point : { 0, 1, 2, 2, 0, 2, 3, 3 })
    {
      const double* const place = mesh->GetPoint(point);
      expected.insert(expected.end(), place, place + 3);
    }
    CHECK(faces.count(layers[n]) == 1 && faces.at(layers[n]) == expected);
  }
}

void WrongInputGivesOneErrorEach()
{
  const std::string path = WriteText(Folder + "/kept.dxf", "as it was");
  const auto check = [&path](vtkDataObject* input, const std::string& message)
  {
    const auto writer = MakeWriter(input, "kept.dxf");
    const Errors errors(writer);
    CHECK_EQUAL(writer->Write(), 0);
    CHECK_EQUAL(errors.Count(), 1u);
    CHECK(errors.FirstContains(path + ": " + message));
    CHECK_EQUAL(ReadText(path), "as it was");
  };
  check(vtkNew<vtkPolyData>(), "no horizon with points, expected something to write");
  const auto points = MakeMesh(0);
  points->SetPolys(nullptr);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeMesh(0));
  blocks->SetBlock(1, points);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "thin");
  check(blocks, "thin: 4 points without triangles, expected a mesh, as the triangulation makes it; leave out");
  check(MakeMesh(std::nan("")), "kept: coordinate nan of point 0, expected a finite number");
  const auto full = MakeWriter(MakeMesh(0), "x");
  full->SetFileName("/dev/full");
  const Errors errors(full);
  CHECK_EQUAL(full->Write(), 0);
  CHECK(errors.FirstContains("/dev/full: writing failed after 0 bytes, expected disk space for the rest of the file"));
  CHECK_EQUAL(full->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::OutOfDiskSpaceError));
}
}

int TestHorizonDXFWriter(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestHorizonDXFWriter");
  HorizonsAreLayers();
  WrongInputGivesOneErrorEach();
  return Check::Result();
}
