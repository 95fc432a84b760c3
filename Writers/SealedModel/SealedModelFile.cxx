// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealedModelFile.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/SurveyFields.h"
#include "Common/Text/InputFile.h"
#include "Common/Text/OutputFile.h"
#include "ModelPrinters.h"

#include <algorithm>
#include <map>
#include <utility>

namespace SeismicHorizons
{
namespace
{
const DataArray& RequireModelArray(const ArrayTable& data, const char* name, bool isText)
{
  const DataArray* const array = data.Find(name);
  if (!array || array->IsText() != isText || array->IsFloating() || array->Components() != 1)
  {
    throw InputError(std::string("no array ") + name + (isText ? " of texts" : " of whole numbers") +
      ", expected the surfaces of Horizon Sealed Model");
  }
  return *array;
}

int WholeAt(const DataArray& array, std::int64_t n)
{
  constexpr double most = 1 << 30;
  return int(std::clamp(array.At(n), -most, most));
}

void ReadModelTriangles(const Horizon& surfaces, ClosedModel& model, const Monitor& monitor)
{
  constexpr std::int64_t mostTriangles = 1 << 29;
  constexpr std::int64_t betweenReports = 1 << 14;
  const std::int64_t count = surfaces.Polygons.Size();
  if (count == 0 || count != surfaces.NumberOfCells() || count > mostTriangles)
  {
    throw InputError(std::to_string(count) + " polygons of " + std::to_string(surfaces.NumberOfCells()) +
      " cells, expected only triangles, 1 to " + std::to_string(mostTriangles));
  }
  const DataArray& names = RequireModelArray(surfaces.CellData, CellArray::SurfaceName, true);
  const DataArray& types = RequireModelArray(surfaces.CellData, CellArray::SurfaceType, false);
  const DataArray& above = RequireModelArray(surfaces.CellData, CellArray::BodyAbove, false);
  const DataArray& below = RequireModelArray(surfaces.CellData, CellArray::BodyBelow, false);
  std::map<std::pair<std::string, int>, std::size_t> numbers; // of surfaces
  for (std::int64_t n = 0; n < count; ++n)
  {
    if (n % betweenReports == 0)
    {
      monitor.Progress(double(n) / double(count));
    }
    const int type = WholeAt(types, n);
    if (surfaces.Polygons.Length(n) != 3 || type < 0 || type > 3)
    {
      throw InputError("polygon " + std::to_string(n) + " of " + std::to_string(surfaces.Polygons.Length(n)) +
        " points, SurfaceType " + std::to_string(type) + ", expected triangles of the types 0 to 3");
    }
    const std::string& name = names.Texts()[std::size_t(n)];
    const auto [number, isNew] = numbers.try_emplace({ name, type }, numbers.size());
    if (isNew)
    {
      model.Surfaces.push_back({ name, type });
    }
    const auto point = [&](std::int64_t corner) { return PointId(surfaces.Polygons.At(n, corner)); };
    model.Triangles.push_back(
      { { point(0), point(1), point(2) }, number->second, { WholeAt(above, n), WholeAt(below, n) } });
  }
}

ClosedModel ReadClosedModel(const Horizon& surfaces, const Monitor& monitor)
{
  CheckArraySizes(surfaces);
  ClosedModel model;
  ReadModelTriangles(surfaces, model, monitor);
  const DataArray& names = RequireModelArray(surfaces.FieldData, FieldArray::BodyName, true);
  const DataArray& layers = RequireModelArray(surfaces.FieldData, FieldArray::BodyLayer, false);
  const DataArray& blocks = RequireModelArray(surfaces.FieldData, FieldArray::BodyBlock, false);
  RequireTuples(layers, names.Tuples(), "bodies");
  RequireTuples(blocks, names.Tuples(), "bodies");
  for (std::int64_t n = 0; n < names.Tuples(); ++n)
  {
    model.Bodies.push_back({ names.Texts()[std::size_t(n)], WholeAt(layers, n), WholeAt(blocks, n) });
  }
  for (std::int64_t point = 0; point < surfaces.NumberOfPoints(); ++point)
  {
    const Eigen::Vector3d place = surfaces.Place(point);
    model.Points.push_back({ place.x(), place.y(), place.z() });
  }
  model.Survey = ReadSurveyFields(surfaces.FieldData);
  return model;
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteSealedModel(const std::string& path, const Horizon& surfaces, const Monitor& monitor)
{
  const std::string format = ExtensionOf(path);
  const auto print = format == "ml" ? PrintModel3d
    : format == "msh"               ? PrintModelGmsh
    : format == "stl"               ? PrintModelSTL
                                    : nullptr;
  if (!print)
  {
    throw InputError("extension \"" + format + "\", expected ml, msh or stl");
  }
  const ClosedModel model = ReadClosedModel(surfaces, monitor.Step(0.0, 0.2));
  const ModelTopology topology = FindTopology(model, monitor.Step(0.2, 0.5));
  WriteOutputFile(path, [&](std::ostream& stream) { print(model, topology, stream, monitor.Step(0.5, 1.0)); });
}
}
