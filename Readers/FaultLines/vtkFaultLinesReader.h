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
 * number of the line; the output is empty then. The whole file is held in memory.
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

  ///@{
  /**
   * The path of the file, in UTF-8. Several are a series: each is that of a time, 0, 1, 2 and so on in the
   * order in which they were added, and the output is that of the time which is asked for. SetFileName() takes one file
   * in place of all. GetFileName() without an index gives the first. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /// Where z grows to.
  enum VerticalSense
  {
    Down = 0,
    Up = 1
  };

  ///@{
  /**
   * Where z grows to. Down: to smaller world z, as time and depth do. Up: to larger world z, as elevation does. GOCAD
   * files say it themselves. It counts for sticks alone, and has to be that of the horizon's reader. Default: Down.
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
