// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFaultLinesWriter
 * @brief   writes fault traces, polygons, cutoffs and sticks as text
 *
 * The input has lines or polygons in world coordinates, as of vtkFaultLinesReader and vtkHorizonFaults, with the cell
 * data FaultName and FaultStick (text), both optional. The extension of the file says the format: .pl GOCAD PLine, an
 * object for each fault; .pol IRAP, without names, a file for each fault; .csv and all others tables of fault, x, y, z,
 * stick and node. Numbers have all their digits.
 *
 * @sa vtkFaultLinesReader
 */

#ifndef vtkFaultLinesWriter_h
#define vtkFaultLinesWriter_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h"

class VTKSEISMICHORIZONS_EXPORT vtkFaultLinesWriter : public vtkHorizonWriter
{
public:
  static vtkFaultLinesWriter* New();
  vtkTypeMacro(vtkFaultLinesWriter, vtkHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Direction of increasing z in the file. AsRead: as in the file of the lines or their horizon, else up. Elevation:
   * up. Depth: down. Default: AsRead.
   */
  vtkHorizonChoice3Macro(VerticalPositive, VerticalSense, AsRead, Elevation, Depth);

protected:
  vtkFaultLinesWriter() = default;
  ~vtkFaultLinesWriter() override = default;

  void WriteFiles(const std::string& path, const std::vector<WrittenHorizon>& lines,
    const SeismicHorizons::Monitor& monitor, std::string& subject) override;

private:
  vtkFaultLinesWriter(const vtkFaultLinesWriter&) = delete;
  void operator=(const vtkFaultLinesWriter&) = delete;

  int VerticalPositive = AsRead;
};

#endif
