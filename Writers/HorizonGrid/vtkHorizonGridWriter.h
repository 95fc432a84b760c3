// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonGridWriter
 * @brief   writes horizons as regular grids
 *
 * A grid covers the lattice of its horizon; columns without a point have the null value of the format
 * (Documentation/HorizonGridFormats.md). A file holds one grid: of several horizons each goes into a file of its own,
 * whose name has that of the horizon behind an underscore, with underscores for what file names cannot have:
 * "reek_Top.irap". Numbers have all their digits.
 *
 * @sa vtkHorizonGridReader vtkHorizonTextWriter
 */

#ifndef vtkHorizonGridWriter_h
#define vtkHorizonGridWriter_h

#include "vtkLatticeHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

class VTKSEISMICHORIZONS_EXPORT vtkHorizonGridWriter : public vtkLatticeHorizonWriter
{
public:
  static vtkHorizonGridWriter* New();
  vtkTypeMacro(vtkHorizonGridWriter, vtkLatticeHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Format.
  enum GridKind
  {
    ByExtension = 0,
    IrapText = 1,
    Zmap = 2,
    IrapBinary = 3
  };

  ///@{
  /**
   * The format of the file. ByExtension: ZMAP+ for names that end in .zmap or .zmp, IRAP classic binary for .gri and
   * .irapbin, IRAP classic ASCII for others. IrapText: IRAP classic ASCII, for lattices with perpendicular steps,
   * rotated or not. Zmap: ZMAP+, for lattices along the axes; others are resampled on such a one, with a warning.
   * IrapBinary: IRAP classic binary, as IrapText, in single precision. Default: ByExtension.
   */
  vtkSetClampMacro(Format, int, ByExtension, IrapBinary);
  vtkGetMacro(Format, int);
  void SetFormatToByExtension() { this->SetFormat(ByExtension); }
  void SetFormatToIrapText() { this->SetFormat(IrapText); }
  void SetFormatToZmap() { this->SetFormat(Zmap); }
  void SetFormatToIrapBinary() { this->SetFormat(IrapBinary); }
  ///@}

protected:
  vtkHorizonGridWriter() = default;
  ~vtkHorizonGridWriter() override = default;

  bool WritesFileForEach() const override { return true; }
  void PrintHorizons(
    const std::vector<NamedHorizon>& horizons, std::ostream& stream, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonGridWriter(const vtkHorizonGridWriter&) = delete;
  void operator=(const vtkHorizonGridWriter&) = delete;

  GridKind ChooseFormat();

  int Format = ByExtension;
};

#endif
