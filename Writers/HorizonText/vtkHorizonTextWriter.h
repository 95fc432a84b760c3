// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonTextWriter
 * @brief   writes horizons as lines of text: inline, crossline, x, y, z and attributes
 *
 * A line for each column, in the form of OpendTect: separated by tabs, with a header of one line; 1e30 where an
 * attribute has no value. Inline and crossline are written where all horizons have LineNumbers in their field data.
 * All horizons go into one file; of several each line begins with the name in quotes. Numbers have all their digits.
 *
 * Horizons without triangles have their point arrays of real numbers as attributes; meshes have none.
 *
 * @sa vtkHorizonTextReader vtkHorizonGridWriter
 */

#ifndef vtkHorizonTextWriter_h
#define vtkHorizonTextWriter_h

#include "vtkLatticeHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonTextWriter : public vtkLatticeHorizonWriter
{
public:
  static vtkHorizonTextWriter* New();
  vtkTypeMacro(vtkHorizonTextWriter, vtkLatticeHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether point arrays of real numbers, other than those of the stages, are written as attributes; only horizons
   * without triangles have them. Default: on.
   */
  vtkSetMacro(WriteAttributes, bool);
  vtkGetMacro(WriteAttributes, bool);
  vtkBooleanMacro(WriteAttributes, bool);
  ///@}

protected:
  vtkHorizonTextWriter() = default;
  ~vtkHorizonTextWriter() override = default;

  void PrintHorizons(
    const std::vector<NamedHorizon>& horizons, std::ostream& stream, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonTextWriter(const vtkHorizonTextWriter&) = delete;
  void operator=(const vtkHorizonTextWriter&) = delete;

  bool WriteAttributes = true;
};

#endif
