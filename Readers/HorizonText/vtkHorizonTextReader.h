// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonTextReader
 * @brief   reads horizons from text files of interpretation programs
 *
 * A line is a pick: inline and crossline, x and y, or all four; z; any number of attributes; before them perhaps the
 * name of the horizon. Files have no header, a line of names, or many lines of header; fields are separated by blanks,
 * tabs, commas or semicolons. Formats of OpendTect, IESX (GeoQuest), Charisma, OpenWorks, EarthVision (scattered data),
 * Petrel (points with attributes) and RMS (attributes) are recognised by content, unnamed columns by their values
 * (Documentation/HorizonText.md). If that fails, set Columns.
 *
 * The file is read once, or twice if it has several horizons and their list is requested; each process reads the whole
 * file. The peak of memory is 8 bytes per number of a pick, plus 16 bytes per pick.
 *
 * An invalid file gives one error that starts with its name and has the number of the line.
 *
 * @sa vtkHorizonGridReader vtkHorizonFromPoints
 */

#ifndef vtkHorizonTextReader_h
#define vtkHorizonTextReader_h

#include "vtkHorizonFileSeries.h"
#include "vtkHorizonProperty.h"
#include "vtkPickHorizonSource.h"
#include "vtkSeismicHorizonsModule.h"

#include <memory>

class VTKSEISMICHORIZONS_EXPORT vtkHorizonTextReader : public vtkPickHorizonSource
{
public:
  static vtkHorizonTextReader* New();
  vtkTypeMacro(vtkHorizonTextReader, vtkPickHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file, plain or gzipped; several files are time steps. See "Series of files" in Window.md. Range: a path in
   * UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 if the file begins with lines of picks whose columns are recognised, under any name. Without names or line
   * numbers, x and y must be on a lattice; under names of other files, such as .csv and .txt, they always must be, and
   * named columns need one of z. Under a name without an extension, or with one that only picks have, also 1 for
   * ambiguous columns of numbers: reading reports what to do.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  /**
   * Contents of the columns: X, Y, Z, Inline, Crossline, Name (of the horizon), or an attribute; - or _ skips one.
   * Empty: from header or values. See "Columns" in HorizonText.md. Range: names, separated by commas, or blanks without
   * commas. Default: empty.
   */
  vtkHorizonTextMacro(Columns);

  /**
   * Numbers and words that mean no value, besides the usual ones. Points without z are skipped. See "No value" in
   * HorizonText.md. Range: numbers and words, separated by blanks or commas. Default: -999.25 -99999 9999900.
   */
  vtkHorizonTextMacro(NullValues);

  ///@{
  /**
   * Lines to skip at the start; a recognised header may follow. 0: automatic. Range: at least 0. Default: 0.
   */
  vtkSetClampMacro(HeaderLines, int, 0, VTK_INT_MAX);
  vtkGetMacro(HeaderLines, int);
  ///@}

  /**
   * Reads only lines with this value in a column, as COLUMN=VALUE. Empty: all lines. Range: a name, =, and a value.
   * Default: empty.
   */
  vtkHorizonTextMacro(Where);

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
  char* Where = nullptr;

  struct FileContent;
  std::unique_ptr<FileContent> Content;
};

#endif
