// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizon_h
#define SeismicHorizonsHorizon_h

#include "DataArray.h"
#include "Types.h"

#include <Eigen/Core>

#include <cstdint>

namespace SeismicHorizons
{
/// Lists of points.
struct Cells
{
  DataArray Offsets; // one more than cells: the places of their first points in Points; Int or Id
  DataArray Points; // of the type of Offsets

  std::int64_t Size() const { return std::max<std::int64_t>(0, this->Offsets.Tuples() - 1); }
  std::int64_t Length(std::int64_t cell) const { return this->Offset(cell + 1) - this->Offset(cell); }
  std::int64_t At(std::int64_t cell, std::int64_t n) const { return Whole(this->Points, this->Offset(cell) + n); }

private:
  static std::int64_t Whole(const DataArray& array, std::int64_t n)
  {
    const int* const narrow = array.As<int>();
    return narrow ? narrow[n] : array.As<std::int64_t>()[n];
  }
  std::int64_t Offset(std::int64_t cell) const { return Whole(this->Offsets, cell); }
};

/// A horizon at any stage, with arrays as on Documentation/DataModel.md: points, loops as lines, and triangles as
/// polygons. Also other points, lines and surfaces, such as faults. Copies share the memory.
struct Horizon
{
  DataArray Places; // x, y and z in the world
  Cells Vertices; // one for each point, or none, in results
  Cells Lines;
  Cells Polygons;
  std::int64_t Strips = 0; // Stages refuse triangle strips.
  ArrayTable PointData;
  ArrayTable CellData; // of vertices, lines and polygons
  ArrayTable FieldData;

  std::int64_t NumberOfPoints() const { return this->Places.Tuples(); }
  std::int64_t NumberOfCells() const
  {
    return this->Vertices.Size() + this->Lines.Size() + this->Polygons.Size() + this->Strips;
  }
  bool IsMesh() const { return this->Polygons.Size() + this->Strips > 0; }

  Eigen::Vector3d Place(std::int64_t point) const
  {
    if (const double* const places = this->Places.As<double>())
    {
      return Eigen::Vector3d(places + 3 * point);
    }
    return { this->Places.At(point, 0), this->Places.At(point, 1), this->Places.At(point, 2) };
  }
};

/// Throws InputError unless arrays have a tuple per point or cell, and ghosts one component. Later code does not check
/// sizes.
void CheckArraySizes(const Horizon& horizon);

/// A cell per point, with 32-bit numbers if they suffice. Horizons share the memory, so that stages that drop few points
/// write no cells.
Cells MakeVertices(std::int64_t numberOfPoints);
}

#endif
