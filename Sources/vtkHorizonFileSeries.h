// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The files of a reader: one, or a series of them, one for each time. ParaView's own class for series,
 * vtkFileSeriesReader, is not used: it continues after an error of the reader, which is then reported twice; a stop
 * does not reach the reader within; and without ParaView there are no series.
 */

#ifndef vtkHorizonFileSeries_h
#define vtkHorizonFileSeries_h

#include "vtkSeismicHorizonsModule.h"
#include "vtkSetGet.h"

#include <string>
#include <vector>

class vtkIndent;
class vtkInformation;

namespace SeismicHorizons
{
/// File names in UTF-8. The time of a file is its position in the list, from 0.
class VTKSEISMICHORIZONS_EXPORT FileSeries
{
public:
  /// Replaces all names; null clears the list. Returns true if the list changes.
  bool SetName(const char* name);

  /// Appends a name.
  void AddName(const char* name);

  /// Returns true if the list changes.
  bool Clear();

  /// Returns the number of files.
  int GetSize() const { return static_cast<int>(this->Names.size()); }

  /// Returns null for an invalid index.
  const char* GetName(int index) const;

  /// Returns the file that Choose() found, or null.
  const char* GetCurrent() const { return this->GetName(this->Current); }

  /// Announces the times of a series, and chooses the file of the last requested time.
  void Announce(vtkInformation* outputInformation);

  /// Chooses the last file that is not later than the requested time, or else the first. VTK repeats a request without
  /// Mark().
  void Choose(vtkInformation* outputInformation);

  /// Stamps the output with the chosen time, so that VTK updates it for another time.
  void Mark(vtkInformation* outputInformation) const;

  /// The text resembles a property FileName.
  void Print(ostream& os, vtkIndent indent) const;

private:
  void ChooseByTime(vtkInformation* outputInformation);

  std::vector<std::string> Names;
  int Current = 0;
};
}

/**
 * The methods by which a reader is given its files, for a class with a member `Files` of the type FileSeries.
 * SetFileName() takes one file in place of all, AddFileName() one more; GetFileName() without an index gives the first.
 * The output is that of the time which is asked for.
 */
#define vtkHorizonFileNamesMacro()                                                                                     \
  virtual void SetFileName(VTK_FILEPATH const char* fileName)                                                          \
  {                                                                                                                    \
    if (this->Files.SetName(fileName))                                                                                 \
    {                                                                                                                  \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual void AddFileName(VTK_FILEPATH const char* fileName)                                                          \
  {                                                                                                                    \
    this->Files.AddName(fileName);                                                                                     \
    this->Modified();                                                                                                  \
  }                                                                                                                    \
  virtual void ClearFileNames()                                                                                        \
  {                                                                                                                    \
    if (this->Files.Clear())                                                                                           \
    {                                                                                                                  \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual int GetNumberOfFileNames()                                                                                   \
  {                                                                                                                    \
    return this->Files.GetSize();                                                                                      \
  }                                                                                                                    \
  virtual VTK_FILEPATH const char* GetFileName(int index)                                                              \
  {                                                                                                                    \
    return this->Files.GetName(index);                                                                                 \
  }                                                                                                                    \
  virtual VTK_FILEPATH const char* GetFileName()                                                                       \
  {                                                                                                                    \
    return this->Files.GetName(0);                                                                                     \
  }

#endif
