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

#include "vtkNew.h" // for the selection
#include "vtkPartitionedDataSetCollectionAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro
#include "vtkSmartPointer.h" // for the datasets

#include <cstdint> // for numbers of points
#include <string> // for names
#include <unordered_set> // for the choice
#include <vector> // for lists

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
   * The horizons to load, by name. Range: on, off. Default: all on.
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

  /// Tells of an output only that it can be made in pieces.
  static int AnnouncePieces(vtkInformationVector* outputs);

  /// Asks for all inputs whole, out of which each process makes its own horizons.
  int AskForWholeInput(vtkInformationVector** inputs);

  // The following throw InputError (Common/Errors.h).

  /// Refuses parameters, before any data are looked at.
  virtual void CheckParameters() {}

  /// The names of all horizons there are, in their order. Of several that are the same, the later ones get a number.
  virtual std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor& monitor) = 0;

  /// Makes the datasets of some horizons, by their numbers in that list.
  virtual std::vector<vtkSmartPointer<vtkDataObject>> MakeHorizons(
    const std::vector<int>& numbers, const SeismicHorizons::Monitor& monitor) = 0;

  /// How large each horizon of that list is, in points or anything that is about in proportion to them, when the list
  /// has been made; empty where it is not known. Horizons are dealt out to pieces by this, so that it has to be the
  /// same on all processes.
  virtual std::vector<std::int64_t> CountHorizonPoints() { return {}; }

  /// Says what is known of an output before it is made, when the numbers of the chosen horizons are known.
  virtual void DescribeOutput(const std::vector<int>& numbers, vtkInformation* outputInformation);

  /// Makes the output that `outputInformation` asks for out of the chosen horizons, by their names and numbers in the
  /// list: a collection of them.
  virtual void MakeOutput(const std::vector<std::string>& names, const std::vector<int>& numbers,
    vtkInformation* outputInformation, const SeismicHorizons::Monitor& monitor);

  /// The files that horizons are read from; null where they come from elsewhere.
  virtual SeismicHorizons::FileSeries* GetFiles() { return nullptr; }

  /// What errors begin with that come from the data: the name of the file, and ": ".
  std::string ErrorPrefix();

private:
  vtkHorizonSource(const vtkHorizonSource&) = delete;
  void operator=(const vtkHorizonSource&) = delete;

  std::vector<std::string> NameHorizons(const SeismicHorizons::Monitor& monitor);
  void List(const std::vector<std::string>& names);

  vtkNew<vtkDataArraySelection> HorizonSelection;
  vtkNew<vtkIdTypeArray> HorizonSizes;
  std::unordered_set<std::string> Disabled; // names of horizons, of those that are not listed
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
