// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonDXFWriter
 * @brief   writes horizon meshes as drawings (.dxf)
 *
 * Each triangle becomes a 3DFACE, each horizon a layer, all of them in one file of AutoCAD R12 (AC1009), in text
 * (Documentation/HorizonDXFWriter.md). The layer has the name of the block, else "Horizon <ID>" by the surface ID of the
 * first point, else the name of the file without its extension; with underscores for what names of layers cannot have,
 * and 31 characters at most. Of several with one name the second gets "_2", and so on.
 * Horizons without points are left out.
 *
 * Polygons have to be triangles. Coordinates are as they are, z upwards, in double precision with as many digits as
 * reading them back takes. Lines, vertex cells and arrays are not written.
 *
 * Time is linear; memory is 36 bytes for each point, of the horizon that is being written.
 *
 * @sa vtkGOCADTSurfWriter
 */

#ifndef vtkHorizonDXFWriter_h
#define vtkHorizonDXFWriter_h

#include "vtkHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonDXFWriter : public vtkHorizonWriter
{
public:
  static vtkHorizonDXFWriter* New();
  vtkTypeMacro(vtkHorizonDXFWriter, vtkHorizonWriter);

protected:
  vtkHorizonDXFWriter() = default;
  ~vtkHorizonDXFWriter() override = default;

  void PrintHorizons(
    const std::vector<NamedHorizon>& horizons, std::ostream& stream, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonDXFWriter(const vtkHorizonDXFWriter&) = delete;
  void operator=(const vtkHorizonDXFWriter&) = delete;
};

#endif
