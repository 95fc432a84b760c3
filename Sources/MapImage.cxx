// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MapImage.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
namespace
{
/// True for arrays of one component that are not marks of ghosts.
bool IsScalar(const DataArray& array)
{
  return !array.IsText() && array.Components() == 1 && array.Name != PointArray::Ghosts;
}

/// The active scalars, or else the first array; null without any of one component.
const DataArray* FindScalars(const ArrayTable& data)
{
  constexpr int scalars = 0;
  const auto active = std::find_if(data.begin(), data.end(),
    [](const DataArray& array) { return array.Role == scalars && !array.IsText() && array.Components() == 1; });
  const auto found = active != data.end() ? active : std::find_if(data.begin(), data.end(), IsScalar);
  return found == data.end() ? nullptr : &*found;
}

/// Null without numbers of that name.
const DataArray* FindElevation(const ArrayTable& data, const std::string& name)
{
  const DataArray* const array = name.empty() ? FindScalars(data) : data.Find(name);
  return array && !array->IsText() ? array : nullptr;
}

/// Columns are points, or centres of cells, half a spacing away.
SurveyLattice MakeLattice(const MapImage& image, bool areCells)
{
  const auto& extent = image.Extent;
  const ImageFrame& place = image.Place;
  if (place.Direction(2, 0) != 0.0 || place.Direction(2, 1) != 0.0)
  {
    throw InputError("an image that is not level, expected one whose rows and columns are level");
  }
  const int layers = extent[5] - extent[4] + (areCells ? 0 : 1);
  if (layers > 1)
  {
    throw InputError("an image of " + std::to_string(layers) + " layers, expected a map of one layer");
  }
  SurveyLattice lattice;
  const int lessPoints = areCells ? 0 : 1;
  lattice.Columns = { extent[1] - extent[0] + lessPoints, extent[3] - extent[2] + lessPoints };
  if (lattice.Columns[0] < 1 || lattice.Columns[1] < 1)
  {
    throw InputError("an image of " + std::to_string(lattice.Columns[0]) + " x " + std::to_string(lattice.Columns[1]) +
      (areCells ? " cells" : " points") + ", expected at least one each way");
  }
  lattice.ColumnStep = place.Spacing[0] * Eigen::Vector2d(place.Direction(0, 0), place.Direction(1, 0));
  lattice.RowStep = place.Spacing[1] * Eigen::Vector2d(place.Direction(0, 1), place.Direction(1, 1));
  const double half = areCells ? 0.5 : 0.0;
  lattice.Origin = Eigen::Vector2d(place.Origin[0], place.Origin[1]) + (extent[0] + half) * lattice.ColumnStep +
    (extent[2] + half) * lattice.RowStep;
  return lattice;
}

/// ParaView names heights so: in GDAL rasters and DEM files, and values of TIFF files.
bool AreElevations(const DataArray& array)
{
  return array.Name == "Elevation" || array.Name == "Tiff Scalars";
}

std::vector<double> Values(const DataArray& array, const NullValues& nulls)
{
  std::vector<double> values(std::size_t(array.Tuples()));
  for (std::size_t node = 0; node < values.size(); ++node)
  {
    const double value = array.At(std::int64_t(node));
    values[node] = std::isfinite(value) && !nulls.IsNullNumber(value) ? value : NoValue;
  }
  return values;
}

void Blank(std::vector<double>& values, const ArrayTable& data, int mask)
{
  const DataArray* const marks = data.Find(PointArray::Ghosts);
  const unsigned char* const ghosts = marks ? marks->As<unsigned char>() : nullptr;
  for (std::size_t node = 0; ghosts && node < values.size(); ++node)
  {
    values[node] = ghosts[node] & mask ? NoValue : values[node];
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid MakeHorizonGrid(const MapImage& image, const std::string& zArray, const NullValues& nulls)
{
  const DataArray* elevation = FindElevation(image.PointData, zArray);
  const bool areCells = !elevation;
  const ArrayTable& data = areCells ? image.CellData : image.PointData;
  elevation = areCells ? FindElevation(data, zArray) : elevation;
  if (!elevation)
  {
    throw InputError(zArray.empty() ? "an image without an array of one component, expected one with z"
                                    : "no array " + zArray + ", expected one with z");
  }
  HorizonGrid grid;
  grid.Lattice = MakeLattice(image, areCells);
  const std::int64_t nodes = std::int64_t(grid.Lattice.Columns[0]) * grid.Lattice.Columns[1];
  RequireTuples(data, nodes, areCells ? "cells" : "points");
  grid.Survey.IsUpright = AreElevations(*elevation);
  grid.Z = Values(*elevation, nulls);
  Blank(grid.Z, data, areCells ? GhostMark::HiddenCell : GhostMark::HiddenPoint);
  for (const DataArray& array : data)
  {
    if (IsScalar(array) && &array != elevation && !array.Name.empty())
    {
      grid.Attributes.push_back({ array.Name, Values(array, nulls) });
    }
  }
  return grid;
}
}
