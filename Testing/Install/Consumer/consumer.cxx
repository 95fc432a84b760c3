// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts the triangles that the whole pipeline makes of a file.

#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonTriangulation.h"
#include "vtkVerneySparseMatrixReader.h"

#include <vtkDataObject.h>
#include <vtkNew.h>

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: consumer FILE.vsm\n";
    return 2;
  }
  vtkNew<vtkVerneySparseMatrixReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkHorizonBoundarySimplification> simplified;
  simplified->SetInputConnection(boundary->GetOutputPort());
  vtkNew<vtkHorizonRoughSimplification> rough;
  rough->SetInputConnection(simplified->GetOutputPort());
  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetInputConnection(rough->GetOutputPort());
  mesh->Update();
  const vtkIdType cells = mesh->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL);
  std::cout << cells << " cells\n";
  return cells > 0 ? 0 : 1;
}
