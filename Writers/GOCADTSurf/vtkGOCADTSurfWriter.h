// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGOCADTSurfWriter
 * @brief   writes horizon meshes as GOCAD triangulated surfaces (.ts)
 *
 * Each horizon becomes an object of type TSurf, all in one text file (Documentation/GOCADTSurf.md). It has the
 * name of its block, else "Horizon <ID>" by the surface ID of its first point, else the name of the file without
 * extension; repeated names get " (2)" and so on. Horizons without points are left out.
 *
 * Polygons must be triangles. The points of triangles are written in double precision, with as many digits as needed to
 * read them back exactly. If there is cell data Part, the triangles of each number become a TFACE; a point that several
 * share is an ATOM in all but the first. Lines, vertex cells and other cell data are not written.
 *
 * Field data used: VerticalUnit, HorizontalUnit, CoordinateSystem (text), and Colour (3 numbers: red, green and blue
 * from 0 to 1), as from vtkGOCADTSurfReader.
 *
 * Time is linear except for sorting the points of each part; memory is about 110 bytes per point and 8 per attribute,
 * of the horizon being written.
 *
 * @sa vtkGOCADTSurfReader
 */

#ifndef vtkGOCADTSurfWriter_h
#define vtkGOCADTSurfWriter_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h"

class VTKSEISMICHORIZONS_EXPORT vtkGOCADTSurfWriter : public vtkHorizonWriter
{
public:
  static vtkGOCADTSurfWriter* New();
  vtkTypeMacro(vtkGOCADTSurfWriter, vtkHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Direction of increasing z in the file (ZPOSITIVE). Elevation: up. Depth: down; triangles are flipped. Default:
   * Elevation.
   */
  vtkHorizonChoice2Macro(VerticalPositive, VerticalSense, Elevation, Depth);

  /**
   * Unit of z, such as m or ms; no conversion. Empty: as in the data, else none. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(VerticalUnit);

  /**
   * Unit of x and y, such as m or ft; no conversion. Empty: as in the data, else none. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(HorizontalUnit);

  /**
   * Coordinate system; no conversion. Empty: as in the data, else Default, GOCAD's word for none. Range: any text.
   * Default: empty.
   */
  vtkHorizonTextMacro(CoordinateSystemName);

  /**
   * Point arrays written as properties. PickArrays: attributes of picks, such as Amplitude. AllArrays: also those of
   * stages, such as Distance. See "Attributes" in GOCADTSurf.md. Default: PickArrays.
   *
   * A property has the components of the array. No value is -99999, or a number with more nines if the array has that
   * value.
   */
  vtkHorizonChoice3Macro(WriteAttributes, AttributeChoice, NoArrays, PickArrays, AllArrays);

  /**
   * Writes outlines and holes (BSTONE and BORDER), which some programs, such as xtgeo, refuse. Default: off.
   */
  vtkHorizonFlagMacro(WriteBorders);

protected:
  vtkGOCADTSurfWriter() = default;
  ~vtkGOCADTSurfWriter() override;

  void PrintHorizons(const std::vector<WrittenHorizon>& horizons, std::ostream& stream,
    const SeismicHorizons::Monitor& monitor) override;

private:
  vtkGOCADTSurfWriter(const vtkGOCADTSurfWriter&) = delete;
  void operator=(const vtkGOCADTSurfWriter&) = delete;

  int VerticalPositive = Elevation;
  char* VerticalUnit = nullptr;
  char* HorizontalUnit = nullptr;
  char* CoordinateSystemName = nullptr;
  int WriteAttributes = PickArrays;
  bool WriteBorders = false;
};

#endif
