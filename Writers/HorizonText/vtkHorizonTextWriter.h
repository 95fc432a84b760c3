// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonTextWriter
 * @brief   writes horizons as lines of text: inline, crossline, x, y, z and attributes
 *
 * One line per column, as OpendTect writes them: tab-separated, with a header of one line; 1e30 for no value of an
 * attribute. Inline and crossline are written if all horizons have LineNumbers in their field data. All horizons go
 * into one file; if there are several, each line begins with the name in quotes. Numbers have all their digits.
 *
 * Horizons without triangles have their point arrays of real numbers as attributes; meshes have none.
 *
 * Lines of faults are written as a table of fault, x, y, z, stick and node, as by vtkFaultLinesWriter.
 *
 * @sa vtkHorizonTextReader vtkHorizonGridWriter vtkFaultLinesWriter
 */

#ifndef vtkHorizonTextWriter_h
#define vtkHorizonTextWriter_h

#include "vtkHorizonProperty.h"
#include "vtkLatticeHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h"

class VTKSEISMICHORIZONS_EXPORT vtkHorizonTextWriter : public vtkLatticeHorizonWriter
{
public:
  static vtkHorizonTextWriter* New();
  vtkTypeMacro(vtkHorizonTextWriter, vtkLatticeHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Writes the attributes of horizons without triangles. Default: on.
   *
   * These are point arrays of real numbers other than those of the stages.
   */
  vtkHorizonFlagMacro(WriteAttributes);

protected:
  vtkHorizonTextWriter() = default;
  ~vtkHorizonTextWriter() override = default;

  void PrintHorizons(const std::vector<WrittenHorizon>& horizons, std::ostream& stream,
    const SeismicHorizons::Monitor& monitor) override;

  void WriteFiles(const std::string& path, const std::vector<WrittenHorizon>& horizons,
    const SeismicHorizons::Monitor& monitor, std::string& subject) override;

private:
  vtkHorizonTextWriter(const vtkHorizonTextWriter&) = delete;
  void operator=(const vtkHorizonTextWriter&) = delete;

  bool WriteAttributes = true;
};

#endif
