// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGOCADTSurfWriter
 * @brief   writes horizon meshes as triangulated surfaces of GOCAD (.ts)
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

  /// Values of VerticalPositive.
  enum VerticalSense
  {
    Elevation = 0,
    Depth = 1
  };

  /// Values of WriteAttributes.
  enum AttributeChoice
  {
    NoArrays = 0,
    PickArrays = 1,
    AllArrays = 2
  };

  ///@{
  /**
   * The direction in which z of the file increases (ZPOSITIVE); z of the data always increases upwards. Elevation:
   * upwards, with z as it is. Depth: downwards, for depth or time; z is written as its negative, and triangles are
   * flipped so that they face the same side. Default: Elevation.
   */
  vtkSetClampMacro(VerticalPositive, int, Elevation, Depth);
  vtkGetMacro(VerticalPositive, int);
  void SetVerticalPositiveToElevation() { this->SetVerticalPositive(Elevation); }
  void SetVerticalPositiveToDepth() { this->SetVerticalPositive(Depth); }
  ///@}

  ///@{
  /**
   * The unit of z that the file states, such as m, ft, ms or s; numbers are not converted. Empty: that of the data
   * (field data VerticalUnit), else none, as where the unit is unknown. Range: any text. Default: empty.
   */
  vtkSetStringMacro(VerticalUnit);
  vtkGetStringMacro(VerticalUnit);
  ///@}

  ///@{
  /**
   * The unit of x and y that the file states, such as m or ft; numbers are not converted. Empty: that of the data
   * (field data HorizontalUnit), else none, as where the unit is unknown. Range: any text. Default: empty.
   */
  vtkSetStringMacro(HorizontalUnit);
  vtkGetStringMacro(HorizontalUnit);
  ///@}

  ///@{
  /**
   * The name of the coordinate system that the file states; coordinates are not converted. Empty: that of the data
   * (field data CoordinateSystem), else Default, GOCAD's own word for none. Range: any text. Default: empty.
   */
  vtkSetStringMacro(CoordinateSystemName);
  vtkGetStringMacro(CoordinateSystemName);
  ///@}

  ///@{
  /**
   * Which point arrays of numbers are written as properties of the vertices. What is not finite has no value in the
   * file. NoArrays: none. PickArrays: the attributes of picks, such as Amplitude; not what stages keep for themselves,
   * nor the heights of the file that the picks are from, which differ from z where stages moved it. AllArrays: all, for
   * maps of Distance, for instance. Default: PickArrays.
   *
   * A property has as many numbers for each vertex as the array has components. No value is -99999, or a number with
   * more nines where the array has that as a value.
   */
  vtkSetClampMacro(WriteAttributes, int, NoArrays, AllArrays);
  vtkGetMacro(WriteAttributes, int);
  void SetWriteAttributesToNoArrays() { this->SetWriteAttributes(NoArrays); }
  void SetWriteAttributesToPickArrays() { this->SetWriteAttributes(PickArrays); }
  void SetWriteAttributesToAllArrays() { this->SetWriteAttributes(AllArrays); }
  ///@}

  ///@{
  /**
   * Whether the border of each surface is written (BSTONE and BORDER), its outlines and holes; without it, modelling
   * programs find the border themselves. Programs that know nothing but vertices and triangles refuse files that have
   * it, xtgeo for instance. Default: off.
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
  int WriteAttributes = PickArrays;
  bool WriteBorders = false;
};

#endif
