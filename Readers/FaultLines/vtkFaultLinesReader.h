// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFaultLinesReader
 * @brief   reads fault traces, polygons and sticks from text files of other programs
 *
 * GOCAD PLine (.pl), ZMAP+ points and polygons, CPS-3 lines (.flt), IRAP and RMS polygons (.pol), Charisma sticks, and
 * lines of x y z; recognised by what is in the file (Documentation/FaultLinesReader.md).
 *
 * The output is a vtkPolyData with a polyline for each line of the file, its points in double precision. z is that of
 * the file, but for GOCAD objects whose z counts downwards, where it is its negative. Cell data: FaultName (text), the
 * name or number that the file gives the line, where it gives any. Lines of a single point are left out.
 *
 * A file that is missing or breaks its format gives one error, which starts with the name of the file and has the
 * number of the line; the output is empty then, and GetErrorCode() says what kind, as that of vtkHorizonSource does.
 *
 * @sa vtkHorizonFaults
 */

#ifndef vtkFaultLinesReader_h
#define vtkFaultLinesReader_h

#include "vtkHorizonFileSeries.h" // for the files
#include "vtkPolyDataAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkFaultLinesReader : public vtkPolyDataAlgorithm
{
public:
  static vtkFaultLinesReader* New();
  vtkTypeMacro(vtkFaultLinesReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// 1 for names that end in .pl, .pol or .flt, and for other files where they have what only fault lines have: GOCAD
  /// PLine, segments of ZMAP+, names of CPS-3, sticks of Charisma, ends of polylines of IRAP, but for one at the end of
  /// the file; else 0.
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * The file; it may be compressed by gzip. Several are a series: the first for time 0, the second for time 1, and so
   * on. See "Series of files" in Window.md. Range: a path in UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /// Values of VerticalDirection.
  enum VerticalSense
  {
    Down = 0,
    Up = 1
  };

  ///@{
  /**
   * The direction in which z of sticks increases, which must be that of the horizon's reader. Down: world z decreases
   * with it, as for time and depth. Up: world z increases with it, as for elevation. GOCAD files state their own.
   * Default: Down.
   */
  vtkSetClampMacro(VerticalDirection, int, Down, Up);
  vtkGetMacro(VerticalDirection, int);
  void SetVerticalDirectionToDown() { this->SetVerticalDirection(Down); }
  void SetVerticalDirectionToUp() { this->SetVerticalDirection(Up); }
  ///@}

protected:
  vtkFaultLinesReader();
  ~vtkFaultLinesReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFaultLinesReader(const vtkFaultLinesReader&) = delete;
  void operator=(const vtkFaultLinesReader&) = delete;

  SeismicHorizons::FileSeries Files;
  int VerticalDirection = Down;
};

#endif
