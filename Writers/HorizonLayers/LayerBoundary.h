// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The faces around the stack of layers and between layers, each in one group:
//
//    - Top and Base: no layer is above or below;
//    - Sides and Faults: vertical, at an outline or at a fault;
//    - a horizon: between two layers, or where the layer on one side is absent amid the stack. Where layers pinch out,
//      horizons are one, and their group has all their names: "Sand, Shale".

#ifndef SeismicHorizonsLayerBoundary_h
#define SeismicHorizonsLayerBoundary_h

#include "LayersPrinter.h"

namespace SeismicHorizons
{
struct BoundaryFace
{
  std::vector<std::int64_t> Points; // counter-clockwise from outside the cell
  std::int64_t Cell; // the upper one of two
  std::size_t Number; // in FacesOfCell
};

/// Connected faces of a group with one region on each side, as Gmsh wants entities.
struct BoundarySurface
{
  std::size_t Group;
  int Region; // of the cells
  int Other; // -1 if none
  std::vector<BoundaryFace> Faces;
};

struct LayerBoundary
{
  std::vector<int> Regions; // by cell: connected cells of a layer have the same number, from 0
  std::vector<std::string> Names; // of groups
  std::vector<std::string> PlainNames; // letters, digits and underscores
  std::vector<BoundarySurface> Surfaces; // by group
};

/// Throws InputError if more than two cells share a face.
LayerBoundary FindBoundary(const VolumeCells& cells, const Monitor& monitor = Monitor());

/// In letters, digits and underscores, at most 60.
std::string PlainName(const std::string& name);
}

#endif
