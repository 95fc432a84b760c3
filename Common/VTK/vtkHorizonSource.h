// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSource
 * @brief   base of what horizons come from: the choice of horizons, and the collection they are put in
 *
 * The output is a vtkPartitionedDataSetCollection with one partitioned dataset per selected horizon, which has its
 * name. Its vtkDataAssembly has a node for each, below the root "Horizons": the name without the characters that names
 * of nodes cannot have, and as it is in the attribute "label".
 *
 * When pieces are asked for, the selected horizons are dealt out by size: the one with the most points first, each to
 * the piece that has the fewest points so far; of equal horizons the first goes first, of equal pieces the first takes
 * it. Where sizes are not known before the horizons are made, they are dealt out in turn. In each piece the horizons of
 * others are partitioned datasets without a partition.
 *
 * What is wrong with a file or with a parameter gives one error; the output is empty then, and GetErrorCode() says what
 * it was: NoFileNameError, FileNotFoundError, CannotOpenFileError, PrematureEndOfFileError, FileFormatError, or
 * UnknownError for all else (vtkErrorCode.h).
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
   * Which horizons are loaded, by name (SetHorizonStatus in Python and C++). Range: on, off. Default: all on.
   *
   * UpdateInformation() fills the list; where horizons come from an input, Update() does. A choice is kept when another
   * file has a horizon of that name too, or when the horizon comes back that a window left out, and it may be made
   * before the list is filled.
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
   * The number of points of each horizon, in the order of the list, or an estimate in proportion to it. Empty where
   * nothing is known.
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
