// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFaultLinesReader
 * @brief   reads fault traces, polygons and sticks from text files of other programs
 *
 * Reads tables of points, as those of OpendTect, Kingdom, DUG and spreadsheets, GOCAD PLine (.pl), ZMAP+ points and
 * polygons, CPS-3 lines (.flt), IRAP and RMS polygons (.pol), sticks of Charisma and sticks and boundaries of IESX,
 * recognised by content (Documentation/FaultLines.md).
 *
 * The output is a vtkPolyData with a polyline per line of the files, in double precision. World z is that of the file,
 * negated if it increases downwards. Cell data, if the file has them: FaultName (text), the name of the fault, and
 * FaultStick (text), the number of the line. Lines of a single point are left out. Field data: VerticalDirection, -1 if
 * z of the first file increases downwards, else 1, and VerticalUnit and HorizontalUnit if its header says them.
 *
 * A missing or invalid file gives one error that starts with its name and has the number of the line; the output is
 * then empty, and GetErrorCode() gives its kind, as that of vtkHorizonSource.
 *
 * @sa vtkHorizonFaults
 */

#ifndef vtkFaultLinesReader_h
#define vtkFaultLinesReader_h

#include "vtkHorizonFileSeries.h"
#include "vtkHorizonProperty.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSeismicHorizonsModule.h"

#include <string>

class VTKSEISMICHORIZONS_EXPORT vtkFaultLinesReader : public vtkPolyDataAlgorithm
{
public:
  static vtkFaultLinesReader* New();
  vtkTypeMacro(vtkFaultLinesReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// 1 for names that end in .pl, .pol, .flt or .dufault, and for files that have what only fault lines have: a GOCAD PLine,
  /// segments of ZMAP+, names of CPS-3, sticks of Charisma, or ends of polylines of IRAP other than at the end of the
  /// file; also for tables with columns named after faults or sticks, or with numbers of sticks, that are no picks; else
  /// 0.
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * The files, plain or gzipped; all are read. Of several files, unnamed faults are named after their file. Range:
   * paths in UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * Direction of increasing z, as for the horizon; GOCAD files state theirs. Automatic: Up if no z is positive, else
   * Down. Default: Automatic.
   */
  vtkHorizonChoice3Macro(VerticalDirection, VerticalSense, Down, Up, Automatic);

  /**
   * Contents of the columns: X, Y, Z, Fault, Stick, Node; - or _ skips one. Empty: from header or values. See "Columns"
   * in FaultLines.md. Range: names, separated by commas, or blanks without commas. Default: empty.
   */
  vtkHorizonTextMacro(Columns);

  /**
   * Numbers and words that mean no z; such points are skipped. Range: numbers and words, separated by blanks or commas.
   * Default: empty.
   */
  vtkHorizonTextMacro(NullValues);

  ///@{
  /**
   * Lines to skip at the start; a recognised header may follow. 0: automatic. Range: at least 0. Default: 0.
   */
  vtkSetClampMacro(HeaderLines, int, 0, VTK_INT_MAX);
  vtkGetMacro(HeaderLines, int);
  ///@}

  /// What each file was taken for: columns, numbers of faults and lines, z and where it increases to. Valid after an
  /// update.
  const char* GetDescription() { return this->Description.c_str(); }

protected:
  vtkFaultLinesReader();
  ~vtkFaultLinesReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFaultLinesReader(const vtkFaultLinesReader&) = delete;
  void operator=(const vtkFaultLinesReader&) = delete;

  SeismicHorizons::FileSeries Files;
  int VerticalDirection = Automatic;
  char* Columns = nullptr;
  char* NullValues = nullptr;
  int HeaderLines = 0;
  std::string Description;
};

#endif
