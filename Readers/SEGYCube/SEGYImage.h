// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSEGYImage_h
#define SeismicHorizonsSEGYImage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataArray.h"
#include "Common/Survey/ImageFrame.h"
#include "Common/Survey/LatticeFrame.h"
#include "Common/Survey/LatticeImage.h"
#include "SEGYCube.h"
#include "SEGYWindow.h"

#include <cstdint>

namespace SeismicHorizons
{
struct CubeView
{
  LatticeFrame Frame;
  ImageFrame Image;
};

struct CubeImage
{
  LatticeImage Image; // amplitudes, and marks that hide points without a sample
  std::int64_t Nulls = 0; // as in SEGYWindow
};

/// Throws InputError if steps that are not perpendicular make an image of more than `tolerance` columns off.
CubeView MakeCubeView(
  const SEGYCube& cube, const SurveyDescription& survey, VerticalDirection direction, double tolerance);

CubeImage ReadCubeImage(const SEGYCube& cube, const CubeView& view, const CubeExtent& extent, const Monitor& monitor);

/// A warning, or nothing.
std::string NullsText(std::int64_t nulls);

/// Places each trace of a single line by its own header.
DataArray PlaceLineSamples(const SEGYCube& cube, const LatticeFrame& frame, const CubeExtent& extent);
}

#endif
