// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonGridReader
 * @brief   reads a horizon from a grid file
 *
 * Reads grids of IRAP (classic ASCII and binary), STORM, ZMAP+, CPS-3, EarthVision, Surfer 6 and 7, GXF and Esri
 * (ASCII), recognised by content, never by extension (Documentation/HorizonGrid.md). Rotation, flipped axes and
 * node positions are kept; nodes without a value are left out and counted in DroppedNulls.
 *
 * The horizon is named as in the file, else after the file. Each process reads the whole file. The peak of memory is 24
 * bytes per node besides the output.
 *
 * An invalid file gives one error that starts with its name and says where.
 *
 * @sa vtkHorizonTextReader vtkHorizonFromImage vtkHorizonGridWriter
 */

#ifndef vtkHorizonGridReader_h
#define vtkHorizonGridReader_h

#include "vtkHorizonFileSeries.h"
#include "vtkSeismicHorizonsModule.h"
#include "vtkSurveyHorizonSource.h"

#include <memory>

class VTKSEISMICHORIZONS_EXPORT vtkHorizonGridReader : public vtkSurveyHorizonSource
{
public:
  static vtkHorizonGridReader* New();
  vtkTypeMacro(vtkHorizonGridReader, vtkSurveyHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file, plain or gzipped; several files are time steps. See "Series of files" in Window.md. Range: a path in
   * UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * Numbers and words that mean no value, besides usual words and the null value of the format or file. Unit: that of
   * z. Range: numbers and words, separated by blanks or commas. Default: empty.
   */
  vtkHorizonTextMacro(NullValues);

  /**
   * 1 when the file begins as one of these formats does.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkHorizonGridReader();
  ~vtkHorizonGridReader() override;

  std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor& monitor) override;
  SeismicHorizons::SurveyHorizons ReadSurvey(const SeismicHorizons::Monitor& monitor) override;
  std::string DescribeFormat() override;
  SeismicHorizons::FileSeries* GetFiles() override { return &this->Files; }

private:
  vtkHorizonGridReader(const vtkHorizonGridReader&) = delete;
  void operator=(const vtkHorizonGridReader&) = delete;

  SeismicHorizons::FileSeries Files;
  char* NullValues = nullptr;

  struct FileContent;
  std::unique_ptr<FileContent> Content;
};

#endif
