// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonLayersWriter
 * @brief   writes layers for simulators and meshers (Gmsh .msh, Abaqus .inp, MODFLOW 6 .disv, VTK .vtu)
 *
 * The input is the cells of vtkHorizonLayers. The extension selects the format, each with its own order of corners;
 * coordinates are in double precision, z upwards (Documentation/HorizonLayers.md). .msh and .inp have groups of
 * faces: Top, Base, Sides, Faults and horizons. .vtu has any cells, with all arrays. A file appears complete or not at
 * all.
 *
 * Write() returns 1 if the file was written, else 0. Each failure gives one error that starts with the name of the
 * file, and GetErrorCode() is one of vtkErrorCode. If several processes call it, the one that has cells writes.
 *
 * @sa vtkHorizonLayers
 */

#ifndef vtkHorizonLayersWriter_h
#define vtkHorizonLayersWriter_h

#include "vtkSeismicHorizonsModule.h"
#include "vtkWriter.h"

class VTKSEISMICHORIZONS_EXPORT vtkHorizonLayersWriter : public vtkWriter
{
public:
  static vtkHorizonLayersWriter* New();
  vtkTypeMacro(vtkHorizonLayersWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write. Range: a path in UTF-8. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkHorizonLayersWriter() = default;
  ~vtkHorizonLayersWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkHorizonLayersWriter(const vtkHorizonLayersWriter&) = delete;
  void operator=(const vtkHorizonLayersWriter&) = delete;

  char* FileName = nullptr;
};

#endif
