// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonGridReader
 * @brief   reads a horizon from a grid file of a gridding program
 *
 * Grids of IRAP (classic ASCII and binary), STORM, ZMAP+, CPS-3, EarthVision, Surfer 6 and 7, GXF and Esri (ASCII) are
 * recognised by what is in them, never by their extension (Documentation/HorizonGridFormats.md). Rotation, flipped axes
 * and the places of nodes are kept; nodes without a value are left out and counted in DroppedNulls.
 *
 * The horizon has the name that the file gives it, or that of the file, without its folder and extension. The whole
 * file is read by each of several processes. Memory is 24 bytes for each node, at the peak, besides the output.
 *
 * A file that breaks its format gives one error, which starts with the name of the file and says where.
 *
 * @sa vtkHorizonTextReader vtkHorizonFromImage vtkHorizonGridWriter
 */

#ifndef vtkHorizonGridReader_h
#define vtkHorizonGridReader_h

#include "vtkHorizonFileSeries.h" // for the files
#include "vtkSeismicHorizonsModule.h" // for the export macro
#include "vtkSurveyHorizonSource.h"

#include <memory> // for std::unique_ptr

class VTKSEISMICHORIZONS_EXPORT vtkHorizonGridReader : public vtkSurveyHorizonSource
{
public:
  static vtkHorizonGridReader* New();
  vtkTypeMacro(vtkHorizonGridReader, vtkSurveyHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file; it may be compressed by gzip. Several are a series: the first for time 0, the second for time 1, and so
   * on. See "Series of files" in Window.md. Range: a path in UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

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

  struct FileContent;
  std::unique_ptr<FileContent> Content;
};

#endif
