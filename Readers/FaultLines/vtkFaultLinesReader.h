// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFaultLinesReader
 * @brief   reads fault traces, polygons and sticks from text files of other programs
 *
 * Reads GOCAD PLine (.pl), ZMAP+ points and polygons, CPS-3 lines (.flt), IRAP and RMS polygons (.pol), Charisma
 * sticks, and lines of x y z, recognised by content (Documentation/FaultLinesReader.md).
 *
 * The output is a vtkPolyData with a polyline per line of the file, in double precision. z is that of the file, negated
 * for GOCAD objects whose z increases downwards. Cell data: FaultName (text), the name or number of the line in the
 * file, if any. Lines of a single point are left out.
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

class VTKSEISMICHORIZONS_EXPORT vtkFaultLinesReader : public vtkPolyDataAlgorithm
{
public:
  static vtkFaultLinesReader* New();
  vtkTypeMacro(vtkFaultLinesReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// 1 for names that end in .pl, .pol or .flt, and for files that have what only fault lines have: a GOCAD PLine,
  /// segments of ZMAP+, names of CPS-3, sticks of Charisma, or ends of polylines of IRAP other than at the end of the
  /// file; else 0.
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * The file, plain or compressed by gzip. Several files are time steps. See "Series of files" in Window.md. Range: a
   * path in UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * The direction of world z in which z of sticks increases; it must match the horizon's reader. GOCAD files state
   * their own. Automatic: Up if no z is positive, as Petrel writes depths; else Down. Default: Automatic.
   */
  vtkHorizonChoice3Macro(VerticalDirection, VerticalSense, Down, Up, Automatic);

protected:
  vtkFaultLinesReader();
  ~vtkFaultLinesReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFaultLinesReader(const vtkFaultLinesReader&) = delete;
  void operator=(const vtkFaultLinesReader&) = delete;

  SeismicHorizons::FileSeries Files;
  int VerticalDirection = Automatic;
};

#endif
