// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSealedModelWriter
 * @brief   writes sealed models for modellers and meshers (GOCAD .ml, Gmsh .msh, STL .stl)
 *
 * The input is the surfaces of vtkHorizonSealedModel, triangles that enclose bodies. The extension selects the format
 * (Documentation/HorizonSealedModel.md); coordinates are in double precision, z upwards. A file appears complete or not
 * at all.
 *
 * Write() returns 1 if the file was written, else 0. Each failure gives one error that starts with the name of the
 * file, and GetErrorCode() is one of vtkErrorCode. If several processes call it, the one that has cells writes.
 *
 * @sa vtkHorizonLayersWriter
 */

#ifndef vtkSealedModelWriter_h
#define vtkSealedModelWriter_h

#include "vtkSeismicHorizonsModule.h"
#include "vtkWriter.h"

class VTKSEISMICHORIZONS_EXPORT vtkSealedModelWriter : public vtkWriter
{
public:
  static vtkSealedModelWriter* New();
  vtkTypeMacro(vtkSealedModelWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write. Range: a path in UTF-8. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkSealedModelWriter() = default;
  ~vtkSealedModelWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkSealedModelWriter(const vtkSealedModelWriter&) = delete;
  void operator=(const vtkSealedModelWriter&) = delete;

  char* FileName = nullptr;
};

#endif
