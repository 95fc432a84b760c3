// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGOCADTSurfWriter
 * @brief   writes meshes of horizons as triangulated surfaces of GOCAD (.ts)
 *
 * Each horizon becomes an object of the type TSurf, all of them in one file, in text
 * (Documentation/GOCADTSurfWriter.md). It has the name of its block, else "Horizon <ID>" by the surface ID of its first
 * point, else the name of the file without its extension; of several with one name the second gets " (2)", and so on.
 * Horizons without points are left out.
 *
 * Polygons have to be triangles. Written are the points that triangles have, in double precision with as many digits as
 * reading them back takes, and the triangles. Where there is cell data of the name Part, the triangles of each number
 * become a TFACE of their own; a point that several of them have in common is an ATOM in all but the first. Lines and
 * vertex cells are not written, nor are other cell data.
 *
 * Field data that are looked at: VerticalUnit, HorizontalUnit, CoordinateSystem (text), and Colour (3 numbers: red,
 * green and blue from 0 to 1), as vtkGOCADTSurfReader gives them.
 *
 * Time is linear but for the sorting of the points of each part; memory is about 110 bytes for each point and 8 for
 * each of its attributes, of the horizon that is being written.
 *
 * @sa vtkGOCADTSurfReader
 */

#ifndef vtkGOCADTSurfWriter_h
#define vtkGOCADTSurfWriter_h

#include "vtkHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkGOCADTSurfWriter : public vtkHorizonWriter
{
public:
  static vtkGOCADTSurfWriter* New();
  vtkTypeMacro(vtkGOCADTSurfWriter, vtkHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where z of the file grows to.
  enum VerticalSense
  {
    Elevation = 0,
    Depth = 1
  };

  ///@{
  /**
   * Where z of the file grows to, its ZPOSITIVE. z of the input always grows upwards. Elevation: upwards, as it is.
   * Depth: downwards; z is written as its negative, and triangles are turned around, so that they face the same side.
   * Default: Elevation.
   */
  vtkSetClampMacro(VerticalPositive, int, Elevation, Depth);
  vtkGetMacro(VerticalPositive, int);
  void SetVerticalPositiveToElevation() { this->SetVerticalPositive(Elevation); }
  void SetVerticalPositiveToDepth() { this->SetVerticalPositive(Depth); }
  ///@}

  ///@{
  /**
   * The unit of z that the file states, as "m", "ft", "ms" or "s". Numbers are not converted. Default: empty, which
   * takes the field data VerticalUnit of each horizon, and "m" where there are none.
   */
  vtkSetStringMacro(VerticalUnit);
  vtkGetStringMacro(VerticalUnit);
  ///@}

  ///@{
  /**
   * The unit of x and y that the file states. Numbers are not converted. Default: empty, which takes the field data
   * HorizontalUnit of each horizon, and "m" where there are none.
   */
  vtkSetStringMacro(HorizontalUnit);
  vtkGetStringMacro(HorizontalUnit);
  ///@}

  ///@{
  /**
   * The name of the coordinate system that the file states. Coordinates are not converted. Default: empty, which takes
   * the field data CoordinateSystem of each horizon, and "Default", GOCAD's own word, where there are none.
   */
  vtkSetStringMacro(CoordinateSystemName);
  vtkGetStringMacro(CoordinateSystemName);
  ///@}

  ///@{
  /**
   * Whether point arrays of numbers become properties, of as many numbers for each vertex as they have components. What
   * is not finite is written as a number that stands for no value: -99999, or one with more nines where the array has
   * that as a value. Default: on.
   */
  vtkSetMacro(WriteAttributes, bool);
  vtkGetMacro(WriteAttributes, bool);
  vtkBooleanMacro(WriteAttributes, bool);
  ///@}

  ///@{
  /**
   * Whether the border is written (BSTONE and BORDER): one section for each loop of the sides that belong to one
   * triangle alone. Default: on.
   */
  vtkSetMacro(WriteBorders, bool);
  vtkGetMacro(WriteBorders, bool);
  vtkBooleanMacro(WriteBorders, bool);
  ///@}

protected:
  vtkGOCADTSurfWriter() = default;
  ~vtkGOCADTSurfWriter() override;

  void PrintHorizons(
    const std::vector<NamedHorizon>& horizons, std::ostream& stream, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkGOCADTSurfWriter(const vtkGOCADTSurfWriter&) = delete;
  void operator=(const vtkGOCADTSurfWriter&) = delete;

  int VerticalPositive = Elevation;
  char* VerticalUnit = nullptr;
  char* HorizontalUnit = nullptr;
  char* CoordinateSystemName = nullptr;
  bool WriteAttributes = true;
  bool WriteBorders = true;
};

#endif
