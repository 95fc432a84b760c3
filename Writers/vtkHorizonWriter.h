// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonWriter
 * @brief   base of the writers of horizons
 *
 * Takes a vtkPolyData, a vtkUnstructuredGrid of such cells, or a composite dataset of them. All horizons go into one
 * file, or in formats of one horizon each into a file of its own. A file is written under another name in the same
 * folder and gets its own once it is complete: nothing is left of a file that could not be written to its end, or whose
 * writing was stopped, and a file of that name stays as it was. Several files are all written, or none.
 *
 * Write() returns 1 when the file was written. Whatever is wrong gives one error, which begins with the name of the
 * file; Write() returns 0 then, and GetErrorCode() gives one of vtkErrorCode: NoFileNameError, CannotOpenFileError,
 * OutOfDiskSpaceError, or UnknownError for all else.
 */

#ifndef vtkHorizonWriter_h
#define vtkHorizonWriter_h

#include "vtkSeismicHorizonsModule.h" // for the export macro
#include "vtkWriter.h"

#include <ostream> // for the file
#include <string> // for names
#include <vector> // for the horizons

namespace SeismicHorizons
{
class Monitor;
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
   * Whether all processes of a program, ranks of MPI, write as one: each asks for its part of the horizons, and the first
   * one writes those of all. All of them have to call Write() then, as ParaView makes them. Off: each process that calls it asks
   * for all horizons, and writes them. Default: off.
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

  /// A horizon, and what it is called: by its block, else by its surface ID, else by the file.
  struct NamedHorizon
  {
    std::string Name;
    vtkPolyData* Data;
  };

  /// Whether each of several horizons goes into a file of its own. Its name is that of the file with that of the
  /// horizon behind an underscore, and underscores for what file names cannot have: "reek_Top.irap" for "reek.irap".
  virtual bool WritesFileForEach() const { return false; }

  /// Writes the horizons, of which there is at least one, and all of which have points. Throws
  /// SeismicHorizons::InputError on what the format cannot hold.
  virtual void PrintHorizons(
    const std::vector<NamedHorizon>& horizons, std::ostream& stream, const SeismicHorizons::Monitor& monitor) = 0;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkHorizonWriter(const vtkHorizonWriter&) = delete;
  void operator=(const vtkHorizonWriter&) = delete;

  /// Writes each horizon into the file of its number; all of them, or none.
  void WriteFiles(const std::vector<std::string>& names, const std::vector<NamedHorizon>& horizons,
    const SeismicHorizons::Monitor& monitor, std::string& subject);

  void WriteHorizons(
    const std::vector<NamedHorizon>& horizons, const SeismicHorizons::Monitor& monitor, std::string& subject);

  char* FileName = nullptr;
  vtkTypeBool Gathered = 0;
};

#endif
