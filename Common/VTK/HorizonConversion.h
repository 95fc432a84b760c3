// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Conversion between plain data and VTK's, which share the memory. An array that came from VTK returns as the same
// object.

#ifndef SeismicHorizonsHorizonConversion_h
#define SeismicHorizonsHorizonConversion_h

#include "Common/Horizon/Horizon.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkAbstractArray;
class vtkCellArray;
class vtkDataObject;
class vtkFieldData;
class vtkPolyData;
class vtkTable;

namespace SeismicHorizons
{
/// Arrays in another layout than that of C are copied. Values other than numbers become texts.
DataArray FromVTK(vtkAbstractArray* array);
ArrayTable FromVTK(vtkFieldData* data);
Cells FromVTK(vtkCellArray* cells);
Horizon FromVTK(vtkPolyData* horizon);

vtkSmartPointer<vtkAbstractArray> ToVTK(const DataArray& array);
/// Adds to the arrays that are there.
void ToVTK(const ArrayTable& data, vtkFieldData* output);
void ToVTK(const ArrayTable& columns, vtkTable* output);
/// Replaces the output.
void ToVTK(const Horizon& horizon, vtkPolyData* output);
vtkSmartPointer<vtkPolyData> ToVTK(const Horizon& horizon);
}

#endif
