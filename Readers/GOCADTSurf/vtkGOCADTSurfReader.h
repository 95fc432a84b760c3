// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGOCADTSurfReader
 * @brief   reads triangulated surfaces from a GOCAD file (.ts)
 *
 * The file is text with one or more objects; those of the type TSurf are read, others are skipped
 * (Documentation/GOCADTSurfReader.md).
 *
 * The output is a vtkPartitionedDataSetCollection with one partitioned dataset per selected surface, in the order of
 * the file, under its name. A surface without a name is "TSurf <n>", where n counts the surfaces of the file from 1; of
 * several with one name the second gets " (2)", and so on. Its partition is a vtkPolyData:
 * - points in double precision, z upwards: where the file counts z downwards (ZPOSITIVE Depth), z is its negative, and
 *   triangles are turned around, so that they face the same side. A vertex that the file puts at the place of another
 *   one (ATOM) is a point of its own: nothing is merged;
 * - triangles, as polygons;
 * - point data: an array of doubles for each property, with as many components as the file says; nan where there is no
 *   value. A property that no vertex has a value of is left out;
 * - cell data: Part (int), the number of the TFACE of each triangle, from 0, where there are several;
 * - field data: VerticalDirection (int), -1 where the file counts z downwards, else 1; and where the file states them
 *   VerticalUnit, VerticalDomain ("time" or "depth", by the unit), HorizontalUnit, CoordinateSystem (text) and Colour
 * (3 double: red, green and blue from 0 to 1).
 *
 * The file is read twice: first to list its surfaces, then to load those that are selected. The list is kept as long
 * as the name, the size and the modification time of the file stay. Time is linear in the size of the file.
 *
 * A file that is missing or breaks the format gives one error, which starts with the name of the file and has the
 * number of the line; the output is empty then.
 *
 * @sa vtkGOCADTSurfWriter
 */

#ifndef vtkGOCADTSurfReader_h
#define vtkGOCADTSurfReader_h

#include "vtkHorizonFileSeries.h" // for the files
#include "vtkHorizonSource.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <memory> // for std::unique_ptr

class VTKSEISMICHORIZONS_EXPORT vtkGOCADTSurfReader : public vtkHorizonSource
{
public:
  static vtkGOCADTSurfReader* New();
  vtkTypeMacro(vtkGOCADTSurfReader, vtkHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file; it may be compressed by gzip. Several are a series: the first for time 0, the second for time 1, and so
   * on. See "Series of files" in Window.md. Range: a path in UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 when the first line that is neither blank nor a comment begins with the word GOCAD, within the first 4096 bytes;
   * else 0. Where its first object is a PLine only names that end in .ts will do, as vtkFaultLinesReader reads these.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

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

  struct FileList;
  std::unique_ptr<FileList> List; // what the last look at the file found
};

#endif
