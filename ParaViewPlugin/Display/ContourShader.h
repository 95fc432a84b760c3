// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contours of sheets (see HorizonSheet.h) are drawn by the shader of their actor: as wide everywhere, on the surface
// however rough it is, at no cost.

#ifndef ContourShader_h
#define ContourShader_h

class vtkActor;

namespace SeismicHorizons
{
/// May be called before each rendering. Draws nothing where normals are of length 1, or missing.
void DrawContours(vtkActor* actor);
}

#endif
