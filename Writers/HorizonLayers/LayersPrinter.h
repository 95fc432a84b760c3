// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints cells of layers in formats of simulators and meshers (Documentation/HorizonLayersWriter.md). Coordinates have
// all digits of double precision.

#ifndef SeismicHorizonsLayersPrinter_h
#define SeismicHorizonsLayersPrinter_h

#include "Common/Monitor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Wedges, pyramids and tetrahedra with upright sides, z upwards.
struct VolumeCells
{
  std::vector<std::array<double, 3>> Points;
  /// Cells have 6, 5 or 4 corners, in the order of VTK: from Ends[n - 1] on, or 0, to before Ends[n].
  std::vector<std::int64_t> Corners;
  std::vector<std::int64_t> Ends;
  std::vector<int> Layers; // by cell, from 0, the uppermost
  std::vector<std::int64_t> Triangles; // by cell; cells over each other have the same
  std::vector<std::string> Names; // of layers
  std::string LengthUnit; // "METERS" or "FEET"; empty where it is not known

  std::size_t Size() const { return this->Ends.size(); }
  std::int64_t FirstCorner(std::size_t cell) const { return cell == 0 ? 0 : this->Ends[cell - 1]; }
  std::size_t SizeOf(std::size_t cell) const { return std::size_t(this->Ends[cell] - this->FirstCorner(cell)); }
};

/// Throws InputError where there is no cell, on coordinates that are not finite, on corners that are no points, and on
/// layers without a name.
void CheckCells(const VolumeCells& cells);

// Of cells that were checked.

/// Gmsh 4.1, as text: each layer is a physical volume with its name.
void PrintGmsh(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor = Monitor());

/// Abaqus: each layer is a set of elements. Pyramids are wedges with a node twice.
void PrintAbaqus(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor = Monitor());

/// The package DISV of MODFLOW 6. A cell is level: top and base are the means of their corners, which keeps its volume.
/// Where a layer pinches out between two others it is passed through (idomain -1); elsewhere there is no cell (0).
/// Throws InputError where cells of a triangle are not over each other.
void PrintDISV(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor = Monitor());
}

#endif
