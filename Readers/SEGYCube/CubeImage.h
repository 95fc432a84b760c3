// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCubeImage_h
#define SeismicHorizonsCubeImage_h

#include "Common/Base/Monitor.h"
#include "Common/VTK/HorizonDataSet.h"
#include "SEGYWindow.h"

class vtkImageData;
class vtkInformation;
class vtkStructuredGrid;

namespace SeismicHorizons
{
struct CubeView
{
  LatticeFrame Frame;
  ImageFrame Image;
};

void Announce(const CubeView& view, const CubeExtent& extent, vtkInformation* info);

/// Returns the number of samples that are nan or infinite.
std::int64_t FillImage(
  const SEGYCube& cube, const CubeView& view, const CubeExtent& extent, vtkImageData* image, const Monitor& monitor);

/// The extent is empty unless the cube is a single line.
void AnnounceLine(const SEGYCube& cube, const CubeExtent& extent, vtkInformation* info);

/// Places each trace by its own header. The line stays empty unless the cube is a single line.
void FillLine(const SEGYCube& cube, const CubeView& view, vtkImageData* image, vtkStructuredGrid* line);
}

#endif
