// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTSurfDataSet_h
#define SeismicHorizonsTSurfDataSet_h

#include "Common/Survey/TSurf.h"

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace SeismicHorizons
{
/// The triangles of a TSurf with z upwards, and what else is known of it as arrays (Documentation/GOCADTSurfReader.md).
/// Where z of the file grows downwards, triangles are turned around with it, so that they face the same side.
vtkSmartPointer<vtkPolyData> MakeTSurfDataSet(TSurf surface);
}

#endif
