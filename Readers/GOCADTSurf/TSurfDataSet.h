// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTSurfDataSet_h
#define SeismicHorizonsTSurfDataSet_h

#include "Common/Survey/TSurf.h"

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace SeismicHorizons
{
/// Arrays are described in Documentation/GOCADTSurfReader.md. If z of the file increases downwards, triangles are
/// reversed with it and keep their orientation.
vtkSmartPointer<vtkPolyData> MakeTSurfDataSet(TSurf surface);
}

#endif
