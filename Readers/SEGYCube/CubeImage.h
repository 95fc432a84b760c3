// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCubeImage_h
#define SeismicHorizonsCubeImage_h

#include "Common/Monitor.h"
#include "Common/VTK/HorizonDataSet.h"
#include "SEGYWindow.h"

class vtkImageData;
class vtkInformation;
class vtkStructuredGrid;

namespace SeismicHorizons
{
/// A cube, as its user wants it, and the image that holds it.
struct CubeView
{
  LatticeFrame Frame;
  ImageFrame Image;
};

/// Tells the pipeline what image there will be.
void Announce(const CubeView& view, const CubeExtent& extent, vtkInformation* info);

/// Fills an image with the samples of an extent. Gives how many of them are nan or infinite.
std::int64_t FillImage(
  const SEGYCube& cube, const CubeView& view, const CubeExtent& extent, vtkImageData* image, const Monitor& monitor);

/// Tells the pipeline what line there will be: an empty extent where the cube is none.
void AnnounceLine(const SEGYCube& cube, const CubeExtent& extent, vtkInformation* info);

/// The samples of an image, with each trace where its header says; leaves the line empty where the cube is none.
void FillLine(const SEGYCube& cube, const CubeView& view, vtkImageData* image, vtkStructuredGrid* line);
}

#endif
