// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonWriter
 * @brief   base of the writers of horizons
 *
 * The input is a vtkPolyData, a vtkUnstructuredGrid of such cells, or a composite dataset of them. All horizons go into
 * one file or, in formats of one horizon each, into a file each. A file is written under a temporary name in the same
 * folder and renamed when complete: if writing fails or is stopped, an existing file is unchanged. Several files are
 * all written, or none.
 *
 * Write() returns 1 if the file was written, else 0. Each failure gives one error that starts with the name of the
 * file, and GetErrorCode() is NoFileNameError, CannotOpenFileError, OutOfDiskSpaceError, or UnknownError for all else
 * (vtkErrorCode.h).
 */

#ifndef vtkHorizonWriter_h
#define vtkHorizonWriter_h

#include "vtkSeismicHorizonsModule.h"
#include "vtkWriter.h"

#include <ostream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
class Monitor;
struct NamedHorizon;
}
class vtkPolyData;

class VTKSEISMICHORIZONS_EXPORT vtkHorizonWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkHorizonWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write. Range: a path in UTF-8. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * On: MPI processes write one file together, and all must call Write(). Off: each writes all horizons. Default: off.
   *
   * As ParaView does. Each process requests its piece of the horizons; the first one writes them all.
   */
  vtkSetMacro(Gathered, vtkTypeBool);
  vtkGetMacro(Gathered, vtkTypeBool);
  vtkBooleanMacro(Gathered, vtkTypeBool);
  ///@}

  /// Asks for the part of this process.
  vtkTypeBool ProcessRequest(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkHorizonWriter() = default;
  ~vtkHorizonWriter() override;

  /// The name is from the block, the surface ID or the file, in this order.
  struct WrittenHorizon
  {
    std::string Name;
    vtkPolyData* Data;
  };

  /// True writes each horizon into its own file, such as "reek_Top.irap" for "reek.irap"; underscores replace invalid
  /// characters.
  virtual bool WritesFileForEach() const { return false; }

  /// All horizons have points. Throws SeismicHorizons::InputError if the format cannot hold them.
  virtual void PrintHorizons(const std::vector<WrittenHorizon>&, std::ostream&, const SeismicHorizons::Monitor&) {}

  /// By default calls PrintHorizons with all horizons or, if WritesFileForEach, with each. `subject` becomes the file at
  /// work.
  virtual void WriteFiles(const std::string& path, const std::vector<WrittenHorizon>& horizons,
    const SeismicHorizons::Monitor& monitor, std::string& subject);

  static std::vector<SeismicHorizons::NamedHorizon> ToPlain(const std::vector<WrittenHorizon>& horizons);

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkHorizonWriter(const vtkHorizonWriter&) = delete;
  void operator=(const vtkHorizonWriter&) = delete;

  char* FileName = nullptr;
  vtkTypeBool Gathered = 0;
};

#endif
