// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonMeshWriter
 * @brief   writes horizon meshes for other programs (.vtp, .stl, .ply, .obj), one file per horizon
 *
 * The extension selects the format. Several horizons become files with the name of the horizon after an underscore:
 * "reek_Top.stl" for "reek.stl". Horizons without points are left out.
 *
 * .vtp has all of a horizon: arrays, points and outlines. The others have triangles only, z upwards, in double
 * precision: .stl and .obj as text, .ply as binary (Documentation/Formats.md).
 *
 * @sa vtkGOCADTSurfWriter vtkHorizonDXFWriter
 */

#ifndef vtkHorizonMeshWriter_h
#define vtkHorizonMeshWriter_h

#include "vtkHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h"

class VTKSEISMICHORIZONS_EXPORT vtkHorizonMeshWriter : public vtkHorizonWriter
{
public:
  static vtkHorizonMeshWriter* New();
  vtkTypeMacro(vtkHorizonMeshWriter, vtkHorizonWriter);

protected:
  vtkHorizonMeshWriter() = default;
  ~vtkHorizonMeshWriter() override = default;

  bool WritesFileForEach() const override { return true; }
  void PrintHorizons(const std::vector<WrittenHorizon>& horizons, std::ostream& stream,
    const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonMeshWriter(const vtkHorizonMeshWriter&) = delete;
  void operator=(const vtkHorizonMeshWriter&) = delete;
};

#endif
