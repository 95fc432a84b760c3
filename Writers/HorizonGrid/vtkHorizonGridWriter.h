// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonGridWriter
 * @brief   writes horizons as regular grids
 *
 * A grid covers the lattice of its horizon; columns without a point have the null value of the format
 * (Documentation/HorizonGrid.md). Each file holds one grid: several horizons become files with the name of the
 * horizon after an underscore, such as "reek_Top.irap"; characters that file names cannot have become underscores.
 * Numbers have all their digits.
 *
 * @sa vtkHorizonGridReader vtkHorizonTextWriter
 */

#ifndef vtkHorizonGridWriter_h
#define vtkHorizonGridWriter_h

#include "vtkHorizonProperty.h"
#include "vtkLatticeHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h"

class VTKSEISMICHORIZONS_EXPORT vtkHorizonGridWriter : public vtkLatticeHorizonWriter
{
public:
  static vtkHorizonGridWriter* New();
  vtkTypeMacro(vtkHorizonGridWriter, vtkLatticeHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Format. ByExtension: that of the extension, else IRAP classic ASCII. Zmap: ZMAP+; rotated grids are resampled.
   * IrapBinary: single precision. See "What is written" in HorizonGrid.md. Default: ByExtension.
   */
  vtkHorizonChoice4Macro(Format, GridKind, ByExtension, IrapText, Zmap, IrapBinary);

protected:
  vtkHorizonGridWriter() = default;
  ~vtkHorizonGridWriter() override = default;

  bool WritesFileForEach() const override { return true; }
  void PrintHorizons(const std::vector<WrittenHorizon>& horizons, std::ostream& stream,
    const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonGridWriter(const vtkHorizonGridWriter&) = delete;
  void operator=(const vtkHorizonGridWriter&) = delete;

  int Format = ByExtension;
};

#endif
