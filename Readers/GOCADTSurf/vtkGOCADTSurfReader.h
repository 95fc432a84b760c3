// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGOCADTSurfReader
 * @brief   reads triangulated surfaces from a GOCAD file (.ts)
 *
 * Reads the objects of type TSurf in a text file and skips others (Documentation/GOCADTSurf.md).
 *
 * The output is a vtkPartitionedDataSetCollection with one partitioned dataset per selected surface, in the order of
 * the file, under its name. A surface without a name is "TSurf <n>", where n counts surfaces from 1; repeated names get
 * " (2)" and so on. Each is a vtkPolyData:
 * - points in double precision, z upwards. Where the file counts z downwards (ZPOSITIVE Depth), z is negated and
 *   triangles are flipped, so that they face the same side. Vertices are not merged, not even with an ATOM
 * - triangles, as polygons
 * - point data: an array of doubles per property, with the components of the file; nan for no value. Properties without
 *   values are left out
 * - cell data: Part (int), the number of the TFACE of each triangle, from 0, if there are several
 * - field data: VerticalDirection (int), -1 where the file counts z downwards, else 1; and, if stated, VerticalUnit,
 *   VerticalDomain ("time" or "depth", by the unit), HorizontalUnit, CoordinateSystem (text) and Colour (3 double: red,
 *   green and blue from 0 to 1)
 *
 * The file is read twice: to list its surfaces, then to load the selected ones. The list is kept while name, size and
 * modification time are unchanged. Time is linear in the size of the file.
 *
 * A missing or invalid file gives one error that starts with its name and has the number of the line; the output is
 * then empty.
 *
 * @sa vtkGOCADTSurfWriter
 */

#ifndef vtkGOCADTSurfReader_h
#define vtkGOCADTSurfReader_h

#include "vtkHorizonFileSeries.h"
#include "vtkHorizonSource.h"
#include "vtkSeismicHorizonsModule.h"

#include <memory>
#include <string>

class VTKSEISMICHORIZONS_EXPORT vtkGOCADTSurfReader : public vtkHorizonSource
{
public:
  static vtkGOCADTSurfReader* New();
  vtkTypeMacro(vtkGOCADTSurfReader, vtkHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file, plain or gzipped; several files are time steps. See "Series of files" in Window.md. Range: a path in
   * UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 if the first line that is neither blank nor a comment, within 4096 bytes, begins with the word GOCAD; else 0. If
   * the first object is a PLine, only for names that end in .ts, as vtkFaultLinesReader reads the others.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  /// The direction in which z of the file increases, and the reason. Empty before the first update.
  const char* GetDescription() { return this->Description.c_str(); }

protected:
  vtkGOCADTSurfReader();
  ~vtkGOCADTSurfReader() override;

  std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor& monitor) override;
  std::vector<std::int64_t> CountHorizonPoints() override;
  std::vector<vtkSmartPointer<vtkDataObject>> MakeHorizons(
    const std::vector<int>& numbers, const SeismicHorizons::Monitor& monitor) override;
  SeismicHorizons::FileSeries* GetFiles() override { return &this->Files; }

private:
  vtkGOCADTSurfReader(const vtkGOCADTSurfReader&) = delete;
  void operator=(const vtkGOCADTSurfReader&) = delete;

  SeismicHorizons::FileSeries Files;
  std::string Description;

  struct FileList;
  std::unique_ptr<FileList> List;
};

#endif
