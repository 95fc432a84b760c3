// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVerneySparseMatrixReader
 * @brief   reads horizons from a sparse-matrix file (.vsm)
 *
 * The file lists the voxels of horizons, column by column of a lattice of nX x nY x nZ cells, each with a vertical
 * index, a surface ID, a thickness, an amplitude and a real z (Documentation/VerneySparseMatrix.md).
 *
 * The output is a vtkPartitionedDataSetCollection with one partitioned dataset per selected horizon, by ascending
 * surface ID, named "Horizon <ID>": a vtkPolyData with one point and one vertex cell per voxel. With OutputType Images
 * it is a map, a vtkImageData; with Volume the whole output is one vtkImageData.
 *
 * Point data of the vtkPolyData, one component each:
 * - SurfaceId (int): the ID of the horizon
 * - VerticalIndex (int): k, from 0 to nZ - 1; the active scalars
 * - Thickness, Amplitude, RealZ (double): as in the file
 *
 * Point data of a map, which covers the bounding box of the horizon's columns at z = 0:
 * - SurfaceId (int)
 * - Elevation (double): the world z of the point in the vtkPolyData, by which to warp the map; the active scalars
 * - VerticalIndex, Thickness, Amplitude, RealZ (double): as above
 * - vtkGhostType (unsigned char): blanks columns without a voxel, where arrays of doubles are nan
 *
 * Point data of a volume, with a point at the centre of each cell of the lattice or of the bounding box (VolumeExtent).
 * Its axes are i, j and k, or i, j and -k where the former are left-handed in the world.
 * - SurfaceId (int): the ID of the horizon that has the voxel, or BackgroundValue
 * - Amplitude or Thickness (float), if VolumeArray selects it: as in the file, or 0 without a voxel
 *
 * Field data, one tuple each:
 * - LatticeDimensions (int, 3 components): nX, nY, nZ
 * - LatticeToWorld (double, 16 components): the affine map from (i, j, k) to world coordinates, row by row. Its columns
 *   are (ColumnStep, 0), (RowStep, 0), (0, 0, +-VerticalStep) and Origin; see VerticalDirection for the sign, and ZFrom
 *   for the last two
 * - VerticalDirection (int, 1 component): -1 for Down, 1 for Up
 * - VerticalUnit, VerticalDomain (string): if they are given
 * - DroppedDuplicates (vtkIdType, 1 component): the voxels left out by DuplicatePolicy; of all selected horizons in a
 *   volume
 *
 * The file is read once, on several threads; later requests with other parameters read it again. Time is linear in its
 * size. The peak of memory is 36 bytes per voxel of the file, selected or not, plus 36 bytes per voxel of the output,
 * or the volume's 4 or 8 bytes per point. With LeastMemory, horizons that are not selected take none. Each process
 * reads the whole file.
 *
 * A missing or invalid file gives one error that starts with its name and has the number of the line; the output is
 * then empty.
 *
 * @sa vtkHorizonExteriorBoundary
 */

#ifndef vtkVerneySparseMatrixReader_h
#define vtkVerneySparseMatrixReader_h

#include "vtkHorizonFileSeries.h"
#include "vtkHorizonProperty.h"
#include "vtkHorizonSource.h"
#include "vtkSeismicHorizonsModule.h"

#include <memory>

namespace SeismicHorizons
{
class SparseMatrixFile;
struct LatticeFrame;
struct SparseMatrix;
struct SparseMatrixOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkVerneySparseMatrixReader : public vtkHorizonSource
{
public:
  static vtkVerneySparseMatrixReader* New();
  vtkTypeMacro(vtkVerneySparseMatrixReader, vtkHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file, plain or gzipped; several files are time steps. See "Series of files" in Window.md. Range: a path in
   * UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 for names that end in .vsm or .vsm.gz, in either case: reading reports what is wrong. For other names, 1 if the
   * first line, within 4095 bytes, is three positive integers separated by blanks, and the lines after it hold only
   * voxels, within 64 kilobytes; else 0. A byte order mark is skipped.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  /**
   * Smallest horizon listed, within the ranges. Unit: points. Range: at least 1. Default: 1.
   */
  vtkHorizonNumberMacro(SmallestHorizonSize, vtkIdType);

  /**
   * First and last column (i). Unit: columns. Range: at least 0, or -1 for the end. Default: 0, -1.
   */
  vtkHorizonVectorMacro(ColumnRange, int, 2);

  /**
   * First and last row (j). Unit: rows. Range: at least 0, or -1 for the end. Default: 0, -1.
   */
  vtkHorizonVectorMacro(RowRange, int, 2);

  /**
   * For files larger than memory: reads selected horizons and rows only. Not for volumes. See "Files larger than
   * memory" in VerneySparseMatrix.md. Default: off.
   *
   * The list has the number of points of each horizon in each row, and is kept for other rows and horizons.
   */
  vtkHorizonFlagMacro(LeastMemory);

  /**
   * With LeastMemory, after UpdateInformation(): the number of points of a horizon in some rows (and the ColumnRange).
   * 0 for other names.
   */
  vtkIdType GetNumberOfPointsInRows(const char* name, int firstRow, int lastRow);

  /**
   * With LeastMemory, after UpdateInformation(): the number of rows of the lattice; else 0.
   */
  int GetNumberOfRows();

  /**
   * What horizons become. Points: the input of stages. Images: maps at z = 0. Volume: one image of all. Images and
   * volumes need perpendicular ColumnStep and RowStep. See "Output" in VerneySparseMatrix.md. Default: Points.
   *
   * One vtkPolyData or vtkImageData per horizon, or one vtkImageData for a volume; GetOutput() gives null for a volume,
   * use GetOutputDataObject(0).
   */
  vtkHorizonChoice3Macro(OutputType, OutputKind, Points, Images, Volume);

  /**
   * What a volume covers. Whole: the lattice. BoundingBox: the selected horizons. Default: Whole.
   */
  vtkHorizonChoice2Macro(VolumeExtent, VolumeBox, Whole, BoundingBox);

  /**
   * Active scalars of a volume; Amplitude and Thickness are added to SurfaceId. Default: SurfaceId.
   */
  vtkHorizonChoice3Macro(VolumeArray, VolumeContent, SurfaceId, Amplitude, Thickness);

  /**
   * SurfaceId of a volume where there is no voxel. Range: an integer that is not the ID of a selected horizon. Default:
   * 0.
   */
  vtkHorizonNumberMacro(BackgroundValue, int);

  /**
   * Largest memory of a volume, per process; more is an error. Unit: MB (2^20 bytes). Range: at least 1. Default: 2048.
   */
  vtkHorizonNumberMacro(VolumeMemoryLimit, int);

  /**
   * World z of points. VerticalIndex: from Origin and VerticalStep. RealZ: time or depth in the file. See "World
   * coordinates" in VerneySparseMatrix.md. Default: VerticalIndex.
   *
   * With RealZ, LatticeToWorld has the straight line that best fits real z to the vertical index, over all voxels in
   * the ranges (with LeastMemory those in the ColumnRange), so that a height of 1 in lattice units remains one vertical
   * index. If real z or the index is constant, Origin and VerticalStep are used. The voxels of a volume always lie
   * where LatticeToWorld puts their vertical index.
   */
  vtkHorizonChoice2Macro(ZFrom, ZSource, VerticalIndex, RealZ);

  /**
   * Centre of cell (0, 0, 0). Unit: world units. Range: finite. Default: 0, 0, 0.
   */
  vtkHorizonVectorMacro(Origin, double, 3);

  /**
   * Step in x and y to the next column (i). Unit: world units. Range: finite, not parallel to RowStep. Default: 1, 0.
   */
  vtkHorizonVectorMacro(ColumnStep, double, 2);

  /**
   * Step in x and y to the next row (j). Unit: world units. Range: finite, not parallel to ColumnStep. Default: 0, 1.
   */
  vtkHorizonVectorMacro(RowStep, double, 2);

  /**
   * Length of a vertical index; negative reverses the direction. Unit: world units. Range: finite, not 0. Default: 1.
   *
   * z is Origin's z minus (VerticalDirection Down) or plus (Up) VerticalStep times the index.
   */
  vtkHorizonNumberMacro(VerticalStep, double);

  /**
   * Direction of increasing vertical indices and real z. Default: Down.
   */
  vtkHorizonChoice2Macro(VerticalDirection, VerticalSense, Down, Up);

  /**
   * Unit of z (see ZFrom): ms, s, m or ft; no conversion. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(VerticalUnit);

  /**
   * Time or depth. Empty: from the unit. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(VerticalDomain);

  /**
   * Which of several voxels in a column is kept. StrongestAmplitude: the largest absolute amplitude, then the topmost.
   * Topmost, Lowest: by vertical index. Sheets: all, for reverse faults; not with LeastMemory. Mean: their mean. See
   * "Sheets" in VerneySparseMatrix.md. Default: StrongestAmplitude.
   *
   * The second sheet is named "Horizon 7 (2)"; see ColumnSheets.h.
   */
  vtkHorizonChoice5Macro(DuplicatePolicy, DuplicateChoice, StrongestAmplitude, Topmost, Lowest, Sheets, Mean);

protected:
  vtkVerneySparseMatrixReader();
  ~vtkVerneySparseMatrixReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  void CheckParameters() override;
  /// Names are "Horizon <ID>", by ascending ID.
  std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor& monitor) override;
  std::vector<std::int64_t> CountHorizonPoints() override;
  std::vector<vtkSmartPointer<vtkDataObject>> MakeHorizons(
    const std::vector<int>& numbers, const SeismicHorizons::Monitor& monitor) override;
  void DescribeOutput(const std::vector<int>& numbers, vtkInformation* outputInformation) override;
  void MakeOutput(const std::vector<std::string>& names, const std::vector<int>& numbers,
    vtkInformation* outputInformation, const SeismicHorizons::Monitor& monitor) override;
  SeismicHorizons::FileSeries* GetFiles() override { return &this->Files; }

private:
  vtkVerneySparseMatrixReader(const vtkVerneySparseMatrixReader&) = delete;
  void operator=(const vtkVerneySparseMatrixReader&) = delete;

  SeismicHorizons::LatticeFrame MakeGivenFrame() const;
  SeismicHorizons::LatticeFrame MakeFrame() const;
  SeismicHorizons::SparseMatrixOptions MakeOptions() const;
  SeismicHorizons::SparseMatrix TakeMatrix(const std::vector<int>& numbers, const SeismicHorizons::Monitor& monitor);

  SeismicHorizons::FileSeries Files;
  vtkIdType SmallestHorizonSize = 1;
  int ColumnRange[2] = { 0, -1 };
  int RowRange[2] = { 0, -1 };
  bool LeastMemory = false;
  int OutputType = Points;
  int VolumeExtent = Whole;
  int VolumeArray = SurfaceId;
  int BackgroundValue = 0;
  int VolumeMemoryLimit = 2048;
  int ZFrom = VerticalIndex;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double ColumnStep[2] = { 1.0, 0.0 };
  double RowStep[2] = { 0.0, 1.0 };
  double VerticalStep = 1.0;
  int VerticalDirection = Down;
  char* VerticalUnit = nullptr;
  char* VerticalDomain = nullptr;
  int DuplicatePolicy = StrongestAmplitude;

  bool FileHasOverview = false;
  std::unique_ptr<SeismicHorizons::SparseMatrixFile> File;
};

#endif
