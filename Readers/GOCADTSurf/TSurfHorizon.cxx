// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TSurfHorizon.h"

#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/NamedHorizon.h"
#include "Common/Survey/SurveyFields.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace SeismicHorizons
{
namespace
{
DataArray MakeSurfaceVertices(const TSurf& surface)
{
  const double upwards = surface.Positive == VerticalPositive::Depth ? -1.0 : 1.0;
  DataArray places = NewArray<double>("Points", std::int64_t(surface.Vertices.size()), 3);
  auto* place = places.As<double>();
  for (const auto& [x, y, z] : surface.Vertices)
  {
    *place++ = x;
    *place++ = y;
    *place++ = upwards * z;
  }
  return places;
}

Cells MakeSurfaceCells(const TSurf& surface)
{
  const bool isTurned = surface.Positive == VerticalPositive::Depth;
  const auto size = std::int64_t(surface.Triangles.size());
  Cells cells = { NewArray<int>("", size + 1), NewArray<int>("", 3 * size) };
  int* offset = cells.Offsets.As<int>();
  int* corner = cells.Points.As<int>();
  *offset = 0;
  for (const auto& [a, b, c] : surface.Triangles)
  {
    *corner++ = a;
    *corner++ = isTurned ? c : b;
    *corner++ = isTurned ? b : c;
    offset[1] = offset[0] + 3;
    ++offset;
  }
  return cells;
}

/// Frees each property after copying it.
void AddProperties(std::vector<TSurfProperty>& properties, ArrayTable& data)
{
  std::vector<std::string> names(properties.size());
  std::transform(
    properties.begin(), properties.end(), names.begin(), [](const TSurfProperty& property) { return property.Name; });
  names = MakeDistinct(std::move(names));
  for (std::size_t n = 0; n < properties.size(); ++n)
  {
    TSurfProperty& property = properties[n];
    const auto size = std::int64_t(property.Values.size() / property.Size);
    DataArray array = NewArray<double>(names[n].c_str(), size, int(property.Size));
    std::copy(property.Values.begin(), property.Values.end(), array.As<double>());
    property.Values = std::vector<double>();
    array.Unit = property.Unit;
    data.Add(std::move(array));
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
Horizon MakeTSurfHorizon(TSurf surface)
{
  Horizon horizon;
  horizon.Places = MakeSurfaceVertices(surface);
  horizon.Polygons = MakeSurfaceCells(surface);
  AddProperties(surface.Properties, horizon.PointData);
  if (!surface.Parts.empty())
  {
    AddArray<int>(horizon.CellData, CellArray::Part, surface.Parts);
  }
  const bool isDown = surface.Positive == VerticalPositive::Depth;
  AddValue<int>(horizon.FieldData, FieldArray::VerticalDirection, isDown ? -1 : 1);
  AddSurveyFields(surface.Survey, horizon.FieldData);
  if (surface.Colour)
  {
    AddTuple<double>(horizon.FieldData, FieldArray::Colour, *surface.Colour);
  }
  return horizon;
}

//----------------------------------------------------------------------------------------------------------------------
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

//----------------------------------------------------------------------------------------------------------------------
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
