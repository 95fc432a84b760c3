// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGOCADTSurfWriter
 * @brief   writes horizon meshes as triangulated surfaces of GOCAD (.ts)
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
   * The direction in which z of the file increases (ZPOSITIVE). Elevation: up, z as in the data. Depth: down; z is
   * negated, and triangles are flipped to face the same side. Default: Elevation.
   */
  vtkHorizonChoice2Macro(VerticalPositive, VerticalSense, Elevation, Depth);

  /**
   * The unit of z, such as m or ms, without conversion. Empty: as in the data (field data VerticalUnit), else none.
   * Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(VerticalUnit);

  /**
   * The unit of x and y, such as m or ft, without conversion. Empty: as in the data (field data HorizontalUnit), else
   * none. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(HorizontalUnit);

  /**
   * The coordinate system, without conversion. Empty: as in the data (field data CoordinateSystem), else Default,
   * GOCAD's word for none. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(CoordinateSystemName);

  /**
   * Which point arrays become properties of vertices. NoArrays: none. PickArrays: the attributes of picks, such as
   * Amplitude, but not arrays of the stages. AllArrays: all, such as Distance. See "Attributes" in GOCADTSurf.md.
   * Default: PickArrays.
   *
   * A property has the components of the array. No value is -99999, or a number with more nines if the array has that
   * value.
   */
  vtkHorizonChoice3Macro(WriteAttributes, AttributeChoice, NoArrays, PickArrays, AllArrays);

  /**
   * Writes the borders of surfaces, outlines and holes (BSTONE and BORDER). Some programs, such as xtgeo, refuse files
   * with them. Default: off.
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
