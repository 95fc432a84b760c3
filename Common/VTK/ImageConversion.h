// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsImageConversion_h
#define SeismicHorizonsImageConversion_h

class vtkImageData;

namespace SeismicHorizons
{
struct ImageFrame;
struct LatticeImage;

void PlaceImage(vtkImageData* image, const ImageFrame& frame);

/// The output is empty; it shares the memory of arrays.
void ToVTK(const LatticeImage& image, vtkImageData* output);
}

#endif
