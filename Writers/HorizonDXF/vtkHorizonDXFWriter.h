// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonDXFWriter
 * @brief   writes horizon meshes as drawings (.dxf)
 *
 * Each triangle becomes a 3DFACE, each horizon a layer, all in one text file of AutoCAD R12 (AC1009;
 * Documentation/Formats.md). The layer has the name of the block, else "Horizon <ID>" by the surface ID of the
 * first point, else the name of the file without extension; at most 31 characters, with underscores for invalid ones.
 * Repeated names get "_2" and so on. Horizons without points are left out.
 *
 * Polygons must be triangles. Coordinates are unchanged, z upwards, in double precision with as many digits as needed
 * to read them back exactly. Lines, vertex cells and arrays are not written.
 *
 * Time is linear; memory is 36 bytes per point of the horizon being written.
 *
 * @sa vtkGOCADTSurfWriter
 */

#ifndef vtkHorizonDXFWriter_h
#define vtkHorizonDXFWriter_h

#include "vtkHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h"

class VTKSEISMICHORIZONS_EXPORT vtkHorizonDXFWriter : public vtkHorizonWriter
{
public:
  static vtkHorizonDXFWriter* New();
  vtkTypeMacro(vtkHorizonDXFWriter, vtkHorizonWriter);

protected:
  vtkHorizonDXFWriter() = default;
  ~vtkHorizonDXFWriter() override = default;

  void PrintHorizons(const std::vector<WrittenHorizon>& horizons, std::ostream& stream,
    const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonDXFWriter(const vtkHorizonDXFWriter&) = delete;
  void operator=(const vtkHorizonDXFWriter&) = delete;
};

#endif
