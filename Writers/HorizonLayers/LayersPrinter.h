// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints cells of layers in formats of simulators and meshers (Documentation/HorizonLayers.md). Coordinates have
// all digits of double precision.

#ifndef SeismicHorizonsLayersPrinter_h
#define SeismicHorizonsLayersPrinter_h

#include "Common/Base/Monitor.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Wedges, pyramids and tetrahedra with vertical sides; z increases upwards.
struct VolumeCells
{
  std::vector<std::array<double, 3>> Points;
  /// Cells have 6, 5 or 4 corners in the order of VTK; Ends is the end of each cell in Corners.
  std::vector<std::int64_t> Corners;
  std::vector<std::int64_t> Ends;
  std::vector<int> Layers; // Layer of each cell, from 0 at the top.
  std::vector<int> Sublayers; // the same within its layer
  std::vector<unsigned char> FaultFaces; // bit n: face n of FacesOfCell is at a fault
  std::vector<std::int64_t> Triangles; // equal for cells above each other
  std::vector<std::string> Names;
  std::vector<std::string> Horizons; // one more than names; empty if unknown
  std::string LengthUnit; // "METERS", "FEET", or empty if unknown.

  std::size_t Size() const { return this->Ends.size(); }
  std::int64_t FirstCorner(std::size_t cell) const { return cell == 0 ? 0 : this->Ends[cell - 1]; }
  std::size_t SizeOf(std::size_t cell) const { return std::size_t(this->Ends[cell] - this->FirstCorner(cell)); }
};

/// Throws InputError for no cells, coordinates that are not finite, invalid corners, and layers without a name.
void CheckCells(const VolumeCells& cells);

/// ASCII of Gmsh 4.1. Each layer is a named physical volume, and each group of LayerBoundary.h a physical surface.
void PrintGmsh(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor = Monitor());

/// Each layer is a set of elements, and each group of LayerBoundary.h a surface of element faces. Pyramids are wedges
/// with a repeated node.
void PrintAbaqus(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor = Monitor());

/// DISV of MODFLOW 6. Each sublayer is a layer of the model. Cells are horizontal, at mean heights, which preserves volume; idomain is -1 where a layer
/// pinches out, 0 without a cell. Throws InputError if cells of a triangle are not above each other.
void PrintDISV(const VolumeCells& cells, std::ostream& stream, const Monitor& monitor = Monitor());

// ---- For the printers --------------------------------------------------------------------------------------------
template <typename Work>
void ForEach(std::size_t count, const Monitor& monitor, Work&& work)
{
  constexpr std::size_t betweenReports = 1 << 14;
  for (std::size_t n = 0; n < count; ++n)
  {
    if (n % betweenReports == 0)
    {
      monitor.Progress(double(n) / double(count));
    }
    work(n);
  }
}

inline std::string WithoutQuotes(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c == '"' || std::iscntrl(static_cast<unsigned char>(c)); }, '_');
  return name;
}
}

#endif
