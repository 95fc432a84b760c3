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
/// The names of files, in UTF-8. The time of each is its place in the list, from 0.
class VTKSEISMICHORIZONS_EXPORT FileSeries
{
public:
  /// Takes one name in place of all; none where it is null. Whether that is a change.
  bool SetName(const char* name);

  /// Puts a name behind the others.
  void AddName(const char* name);

  /// Whether that is a change.
  bool Clear();

  /// The number of files.
  int GetSize() const { return static_cast<int>(this->Names.size()); }

  /// Null where there is no such name.
  const char* GetName(int index) const;

  /// The file to read: that of the time which Choose() found. Null where there is none.
  const char* GetCurrent() const { return this->GetName(this->Current); }

  /// Tells the times of a series, none of a single file; and chooses the file of the time that was asked for last.
  void Announce(vtkInformation* outputInformation);

  /// Chooses the file of the time that an output is asked for: the last one whose time is not later, else the first. An
  /// output that Mark() does not follow is asked for again.
  void Choose(vtkInformation* outputInformation);

  /// Marks the output as that of the chosen file, so that it is made again at another time.
  void Mark(vtkInformation* outputInformation) const;

  /// Prints the names as the property FileName.
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
