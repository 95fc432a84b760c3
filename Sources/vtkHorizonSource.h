// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSource
 * @brief   base of sources of horizons: selection, and the output collection
 *
 * The output is a vtkPartitionedDataSetCollection with one named partitioned dataset per selected horizon. Its
 * vtkDataAssembly has a node for each below the root "Horizons": the name without characters that are invalid in names
 * of nodes; the attribute "label" has the full name.
 *
 * If pieces are requested, the selected horizons are distributed by size: the largest first, each to the piece with the
 * fewest points so far, ties to the first. Where sizes are unknown, they are distributed in turn. In each piece the
 * horizons of others are partitioned datasets without a partition.
 *
 * An invalid file or parameter gives one error; the output is then empty, and GetErrorCode() is NoFileNameError,
 * FileNotFoundError, CannotOpenFileError, PrematureEndOfFileError, FileFormatError, or UnknownError for all else
 * (vtkErrorCode.h).
 */

#ifndef vtkHorizonSource_h
#define vtkHorizonSource_h

#include "vtkNew.h"
#include "vtkPartitionedDataSetCollectionAlgorithm.h"
#include "vtkSeismicHorizonsModule.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

namespace SeismicHorizons
{
class FileSeries;
class Monitor;
}
class vtkDataArraySelection;
class vtkDataObject;
class vtkIdTypeArray;

class VTKSEISMICHORIZONS_EXPORT vtkHorizonSource : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  vtkTypeMacro(vtkHorizonSource, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The horizons to load. Range: on, off. Default: all on.
   *
   * UpdateInformation() fills the list; where horizons come from an input, Update() does. A choice may be made before
   * that, and is kept for horizons of the same name in other files, and for those that a window left out and that come
   * back.
   */
  vtkDataArraySelection* GetHorizonSelection();
  int GetNumberOfHorizons();
  const char* GetHorizonName(int index);
  int GetHorizonStatus(const char* name);
  void SetHorizonStatus(const char* name, int status);
  void EnableAllHorizons();
  void DisableAllHorizons();
  ///@}

  /**
   * The number of points of each horizon, in the order of the list, or an estimate in proportion to it. Empty if
   * unknown.
   */
  vtkIdTypeArray* GetHorizonSizes();

  /// Later when a selection has changed.
  vtkMTimeType GetMTime() override;

protected:
  vtkHorizonSource();
  ~vtkHorizonSource() override;

  vtkTypeBool ProcessRequest(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Outputs can be made in pieces.
  static int AnnouncePieces(vtkInformationVector* outputs);

  /// Requests whole inputs, from which each process makes its own horizons.
  int AskForWholeInput(vtkInformationVector** inputs);

  // The following functions throw InputError (Common/Base/Errors.h).

  /// Called before any data are read.
  virtual void CheckParameters() {}

  /// Lists the names of all horizons; repeated names get a number.
  virtual std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor& monitor) = 0;

  /// Makes the datasets of some horizons, given by their positions in the list.
  virtual std::vector<vtkSmartPointer<vtkDataObject>> MakeHorizons(
    const std::vector<int>& numbers, const SeismicHorizons::Monitor& monitor) = 0;

  /// Returns the sizes of listed horizons, roughly proportional to their points, or nothing. They distribute horizons
  /// to pieces, and must be equal on all processes.
  virtual std::vector<std::int64_t> CountHorizonPoints() { return {}; }

  /// Adds information on the output, given the positions of the chosen horizons.
  virtual void DescribeOutput(const std::vector<int>& numbers, vtkInformation* outputInformation);

  /// Makes the requested collection of the chosen horizons, given by their names and positions in the list.
  virtual void MakeOutput(const std::vector<std::string>& names, const std::vector<int>& numbers,
    vtkInformation* outputInformation, const SeismicHorizons::Monitor& monitor);

  /// Null unless horizons are read from files.
  virtual SeismicHorizons::FileSeries* GetFiles() { return nullptr; }

  /// Errors in the data start with the name of the file and ": ".
  std::string ErrorPrefix();

private:
  vtkHorizonSource(const vtkHorizonSource&) = delete;
  void operator=(const vtkHorizonSource&) = delete;

  std::vector<std::string> NameHorizons(const SeismicHorizons::Monitor& monitor);
  void List(const std::vector<std::string>& names);

  vtkNew<vtkDataArraySelection> HorizonSelection;
  vtkNew<vtkIdTypeArray> HorizonSizes;
  std::unordered_set<std::string> Disabled; // Disabled names that are not listed.
  bool IsInformationStopped = false;
};

/**
 * What makes a source with one input port a filter: the methods by which it is given data, and those by which it asks
 * for them. Its horizons are known when the data are there.
 */
#define vtkHorizonInputMacro()                                                                                         \
public:                                                                                                                \
  void SetInputData(vtkDataObject* input)                                                                              \
  {                                                                                                                    \
    this->SetInputData(0, input);                                                                                      \
  }                                                                                                                    \
  void SetInputData(int port, vtkDataObject* input)                                                                    \
  {                                                                                                                    \
    this->SetInputDataInternal(port, input);                                                                           \
  }                                                                                                                    \
                                                                                                                       \
protected:                                                                                                             \
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override              \
  {                                                                                                                    \
    return AnnouncePieces(outputs);                                                                                    \
  }                                                                                                                    \
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) override              \
  {                                                                                                                    \
    return AskForWholeInput(inputs);                                                                                   \
  }

#endif
