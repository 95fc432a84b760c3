// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonTextReader
 * @brief   reads horizons from text files of interpretation programs
 *
 * A line is a pick: inline and crossline, x and y, or all four; z; any number of attributes; and in front of them
 * perhaps the name of the horizon. Files have no header, a line of names, or a header of many lines; fields are
 * separated by blanks, tabs, commas or semicolons. Headers and lines of OpendTect, IESX (GeoQuest), Charisma,
 * OpenWorks, EarthVision (scattered data), Petrel (points with attributes) and RMS (attributes) are recognised by what
 * is in them. Without names, columns are recognised by their values (Documentation/HorizonTextReader.md). Columns says
 * what they hold where that goes wrong.
 *
 * The file is read once, or twice where it has more than one horizon and the list of them is asked for. Of several
 * processes each reads the whole file. Memory is 8 bytes for each number of a pick, and 16 bytes, at the peak.
 *
 * A file that breaks its format gives one error, which starts with the name of the file and has the number of the line.
 *
 * @sa vtkHorizonGridReader vtkHorizonFromPoints
 */

#ifndef vtkHorizonTextReader_h
#define vtkHorizonTextReader_h

#include "vtkHorizonFileSeries.h" // for the files
#include "vtkPickHorizonSource.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <memory> // for std::unique_ptr

class VTKSEISMICHORIZONS_EXPORT vtkHorizonTextReader : public vtkPickHorizonSource
{
public:
  static vtkHorizonTextReader* New();
  vtkTypeMacro(vtkHorizonTextReader, vtkPickHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file; it may be compressed by gzip. Several are a series: the first for time 0, the second for time 1, and so
   * on. See "Series of files" in Window.md. Range: a path in UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 when the beginning of the file is that of one that this reader reads, under any name: lines of picks whose columns
   * are recognised. Where neither names nor line numbers say so, x and y have to be on a lattice. Under names that
   * belong to other files, such as .csv and .txt, they always have to, and columns that have names need one of z. Where
   * a name has no extension, or one that only picks have, it is also 1 for columns of numbers of which it is doubtful
   * what they are: reading them says what to do.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * What the columns hold: X, Y, Z, Inline, Crossline, Name (of the horizon), a minus sign for skipped columns, or the
   * name of an attribute. Empty: by the header or the values. See "Columns" in HorizonTextReader.md. Range: names,
   * separated by commas, or without any by blanks. Default: empty.
   */
  vtkSetStringMacro(Columns);
  vtkGetStringMacro(Columns);
  ///@}

  ///@{
  /**
   * Numbers and words that mean no value, besides nothing, stars, nan, null, none, undef, and numbers from 1e20.
   * Points without z are left out, and counted in the field data DroppedNulls; attributes become nan. See "No value"
   * in HorizonTextReader.md. Range: numbers and words, separated by blanks or commas. Default: -999.25 -99999 9999900.
   */
  vtkSetStringMacro(NullValues);
  vtkGetStringMacro(NullValues);
  ///@}

  ///@{
  /**
   * How many lines at the beginning of the file are skipped; a recognised header may follow. 0: found automatically.
   * Range: at least 0. Default: 0.
   */
  vtkSetClampMacro(HeaderLines, int, 0, VTK_INT_MAX);
  vtkGetMacro(HeaderLines, int);
  ///@}

protected:
  vtkHorizonTextReader();
  ~vtkHorizonTextReader() override;

  std::vector<std::string> ListNames(const SeismicHorizons::Monitor& monitor) override;
  std::vector<std::int64_t> CountPicks() override;
  vtkMTimeType GetPickTime() override;
  SeismicHorizons::PickTable ReadPicks(const SeismicHorizons::Monitor& monitor) override;
  std::string DescribeFormat() override;
  SeismicHorizons::FileSeries* GetFiles() override { return &this->Files; }

private:
  vtkHorizonTextReader(const vtkHorizonTextReader&) = delete;
  void operator=(const vtkHorizonTextReader&) = delete;

  void UpdateContent(const SeismicHorizons::Monitor& monitor);

  SeismicHorizons::FileSeries Files;
  char* Columns = nullptr;
  char* NullValues = nullptr;
  int HeaderLines = 0;

  struct FileContent;
  std::unique_ptr<FileContent> Content; // what was found when the file was looked at
};

#endif
