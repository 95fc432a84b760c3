// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVerneySparseMatrixReader
 * @brief   reads horizons from a sparse-matrix file (.vsm)
 *
 * The file holds the voxels of seismic horizons, column by column of a lattice of nX x nY x nZ cells, each with a
 * vertical index, a surface ID, a thickness, an amplitude and a real z (Documentation/FileFormat.md). It is a list of
 * voxels per column, not a sparse matrix of linear algebra; the name is that of the thesis it comes from.
 *
 * The output is a vtkPartitionedDataSetCollection with one partitioned dataset per selected horizon, by ascending
 * surface ID, named "Horizon <ID>". Its partition is a vtkPolyData with one point and one vertex cell per voxel: what
 * the stages work on. On request (OutputType) it is a map instead, a vtkImageData; or the whole output is one
 * vtkImageData, a volume with the voxels of all selected horizons.
 *
 * Point data of the vtkPolyData, one component each:
 * - SurfaceId (int): the ID of the horizon
 * - VerticalIndex (int): k, from 0 to nZ - 1; the active scalars
 * - Thickness, Amplitude, RealZ (double): as in the file
 *
 * Point data of the vtkImageData, which covers the bounding box of the horizon's columns with one point for each, at
 * z = 0:
 * - SurfaceId (int)
 * - Elevation (double): the world z the point has in the vtkPolyData; warp by it along z to get the surface; the
 *   active scalars
 * - VerticalIndex, Thickness, Amplitude, RealZ (double): as above
 * - vtkGhostType (unsigned char): blanks the columns without a voxel, where all arrays of doubles are nan
 *
 * Point data of a volume, which has a point at the centre of each cell of the lattice or of the selected horizons'
 * bounding box (VolumeExtent). The extent is that of i, j and k; where these three are left-handed in the world, as
 * they are when k counts downwards and i and j do not, that of i, j and -k.
 * - SurfaceId (int): the ID of the horizon that has the voxel, or BackgroundValue
 * - Amplitude or Thickness (float), when VolumeArray asks for it: as in the file, or 0 where there is no voxel
 *
 * Field data, one tuple each:
 * - LatticeDimensions (int, 3 components): nX, nY, nZ
 * - LatticeToWorld (double, 16 components): the affine map from (i, j, k) to world coordinates, row by row. Its columns
 *   are (ColumnStep, 0), (RowStep, 0), (0, 0, +-VerticalStep) and Origin; see VerticalDirection for the sign, and
 *   Elevation for the last two.
 * - VerticalDirection (int, 1 component): -1 for Down, 1 for Up
 * - DroppedDuplicates (vtkIdType, 1 component): the voxels left out because the horizon has another one in the same
 *   column, see DuplicatePolicy; of all selected horizons in a volume
 *
 * The file is read once, for the list of horizons, and what was found is kept until the horizons are asked for; it is
 * read again when they are asked for another time, with other parameters say. Time is linear in the size of the file;
 * lines are parsed on several threads. The peak of memory is 36 bytes per voxel of the file, those of horizons that are
 * not selected included, plus 36 bytes per voxel of the output, which has 64 and takes arrays over as they are; or plus
 * what a volume takes, 4 or 8 bytes for each of its points. With LeastMemory, horizons that are not
 * selected take none.
 *
 * Of several processes each reads the whole file.
 *
 * A file that is missing or breaks the format gives one error, which starts with the name of the file and has the
 * number of the line; the output is empty then.
 *
 * @sa vtkHorizonExteriorBoundary
 */

#ifndef vtkVerneySparseMatrixReader_h
#define vtkVerneySparseMatrixReader_h

#include "vtkHorizonFileSeries.h" // for the files
#include "vtkHorizonSource.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <memory> // for std::unique_ptr

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
   * The file; it may be compressed by gzip, whatever its name. Several are a series: the first for time 0, the second
   * for time 1, and so on. See "Series of files" in Window.md. Range: a path in UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 for any name that ends in .vsm or .vsm.gz, in letters of either case: when something is wrong with the file,
   * reading it says what. For other names 1 when the first line of the file is what the format asks for: three positive
   * integers, separated by blanks, within the first 4095 bytes, and the lines behind it have voxels and nothing else, as
   * far as 64 kilobytes go; else 0. A byte order mark is skipped.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * Horizons of fewer points in the ranges below are not listed. Unit: points. Range: at least 1. Default: 1.
   */
  vtkSetMacro(SmallestHorizonSize, vtkIdType);
  vtkGetMacro(SmallestHorizonSize, vtkIdType);
  ///@}

  ///@{
  /**
   * The first and the last column (i) to load, from 0; -1 stands for the end. The lattice is still that of the whole
   * file, and the whole file is checked. Unit: columns. Range: at least 0, or -1 for the end. Default: 0, -1.
   */
  vtkSetVector2Macro(ColumnRange, int);
  vtkGetVector2Macro(ColumnRange, int);
  ///@}

  ///@{
  /**
   * The first and the last row (j) to load, from 0; -1 stands for the end. The lattice is still that of the whole
   * file. Unit: rows. Range: at least 0, or -1 for the end. Default: 0, -1.
   */
  vtkSetVector2Macro(RowRange, int);
  vtkGetVector2Macro(RowRange, int);
  ///@}

  ///@{
  /**
   * For files larger than memory: one pass lists the horizons, then only the selected ones, and the rows asked for,
   * are read. Not for volumes. Default: off.
   *
   * The list has nothing else but how many points each horizon has in each row. It takes two passes instead of one, but
   * for other rows and horizons it is kept.
   */
  vtkSetMacro(LeastMemory, bool);
  vtkGetMacro(LeastMemory, bool);
  vtkBooleanMacro(LeastMemory, bool);
  ///@}

  /**
   * With LeastMemory, after UpdateInformation(): how many points a horizon has in some rows (and the ColumnRange). 0
   * for other names.
   */
  vtkIdType GetNumberOfPointsInRows(const char* name, int firstRow, int lastRow);

  /**
   * With LeastMemory, after UpdateInformation(): how many rows the lattice of the file has; else 0.
   */
  int GetNumberOfRows();

  /// Values of OutputType.
  enum OutputKind
  {
    Points = 0,
    Images = 1,
    Volume = 2
  };

  ///@{
  /**
   * What horizons become. Points: points in space, the input of the stages. Images: maps at z = 0, with a pixel for
   * every column and attributes as arrays; columns without the horizon are blank. Warp them by the array Elevation.
   * Volume: all horizons in one image, for slices and volume rendering. For the last two, ColumnStep and RowStep must
   * be perpendicular. Default: Points.
   *
   * Points are a vtkPolyData for each horizon, images a vtkImageData for each, a volume is one vtkImageData;
   * GetOutput() gives null for that, use GetOutputDataObject(0).
   */
  vtkSetClampMacro(OutputType, int, Points, Volume);
  vtkGetMacro(OutputType, int);
  void SetOutputTypeToPoints() { this->SetOutputType(Points); }
  void SetOutputTypeToImages() { this->SetOutputType(Images); }
  void SetOutputTypeToVolume() { this->SetOutputType(Volume); }
  ///@}

  /// Values of VolumeExtent.
  enum VolumeBox
  {
    Whole = 0,
    BoundingBox = 1
  };

  ///@{
  /**
   * What a volume covers. Whole: all cells of the lattice. BoundingBox: the smallest box with all voxels of the
   * selected horizons. Default: Whole.
   */
  vtkSetClampMacro(VolumeExtent, int, Whole, BoundingBox);
  vtkGetMacro(VolumeExtent, int);
  void SetVolumeExtentToWhole() { this->SetVolumeExtent(Whole); }
  void SetVolumeExtentToBoundingBox() { this->SetVolumeExtent(BoundingBox); }
  ///@}

  /// Values of VolumeArray.
  enum VolumeContent
  {
    SurfaceId = 0,
    Amplitude = 1,
    Thickness = 2
  };

  ///@{
  /**
   * The active scalars of a volume. The array SurfaceId has the ID of the horizon at each voxel; Amplitude or
   * Thickness add an array of these, 0 without a voxel. Default: SurfaceId.
   */
  vtkSetClampMacro(VolumeArray, int, SurfaceId, Thickness);
  vtkGetMacro(VolumeArray, int);
  void SetVolumeArrayToSurfaceId() { this->SetVolumeArray(SurfaceId); }
  void SetVolumeArrayToAmplitude() { this->SetVolumeArray(Amplitude); }
  void SetVolumeArrayToThickness() { this->SetVolumeArray(Thickness); }
  ///@}

  ///@{
  /**
   * The array SurfaceId of a volume where there is no voxel. Range: an integer that is not the ID of a selected
   * horizon. Default: 0.
   */
  vtkSetMacro(BackgroundValue, int);
  vtkGetMacro(BackgroundValue, int);
  ///@}

  ///@{
  /**
   * The largest memory of the arrays of a volume, on each process; a larger volume is an error. Unit: MB (2^20 bytes).
   * Range: at least 1. Default: 2048.
   */
  vtkSetMacro(VolumeMemoryLimit, int);
  vtkGetMacro(VolumeMemoryLimit, int);
  ///@}

  /// Values of ZFrom.
  enum ZSource
  {
    VerticalIndex = 0,
    RealZ = 1
  };

  ///@{
  /**
   * World z of the points. VerticalIndex: from the vertical index, Origin and VerticalStep. RealZ: the time or depth
   * in the file, without Origin and VerticalStep. VerticalDirection gives the sign. Voxels of a volume stay in their
   * cells, and stages measure distances and cell sizes in the lattice in both cases. Default: VerticalIndex.
   *
   * With RealZ, LatticeToWorld holds the straight line that fits real z over the vertical index best, for all voxels in
   * the ranges (with LeastMemory those in the ColumnRange), so that a height of 1 in lattice units is one vertical
   * index all the same. Where real z or the index is the same everywhere there is no such line, and Origin and
   * VerticalStep hold. The voxels of a volume always lie where LatticeToWorld puts their vertical index.
   */
  vtkSetClampMacro(ZFrom, int, VerticalIndex, RealZ);
  vtkGetMacro(ZFrom, int);
  void SetZFromToVerticalIndex() { this->SetZFrom(VerticalIndex); }
  void SetZFromToRealZ() { this->SetZFrom(RealZ); }
  ///@}

  ///@{
  /// The names of version 0.2, for scripts of that version. @deprecated Use SetZFrom.
  void SetElevation(int source) { this->SetZFrom(source); }
  void SetElevationToVerticalIndex() { this->SetZFrom(VerticalIndex); }
  void SetElevationToRealZ() { this->SetZFrom(RealZ); }
  ///@}

  ///@{
  /**
   * World coordinates of the centre of cell (0, 0, 0), the first voxel of the cube. Unit: world units. Range: finite.
   * Default: 0, 0, 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * The step in world x and y from a column to the next along i, which runs fastest in the file. Unit: world units.
   * Range: finite, not parallel to RowStep. Default: 1, 0.
   */
  vtkSetVector2Macro(ColumnStep, double);
  vtkGetVector2Macro(ColumnStep, double);
  ///@}

  ///@{
  /**
   * The step in world x and y from a row to the next along j. Unit: world units. Range: finite, not parallel to
   * ColumnStep. Default: 0, 1.
   */
  vtkSetVector2Macro(RowStep, double);
  vtkGetVector2Macro(RowStep, double);
  ///@}

  ///@{
  /**
   * The length along z from a vertical index to the next; a negative one reverses the direction. Unit: world units.
   * Range: finite, not 0. Default: 1.
   *
   * z is Origin's z minus (VerticalDirection Down) or plus (Up) VerticalStep times the index.
   */
  vtkSetMacro(VerticalStep, double);
  vtkGetMacro(VerticalStep, double);
  ///@}

  /// Values of VerticalDirection.
  enum VerticalSense
  {
    Down = 0,
    Up = 1
  };

  ///@{
  /**
   * The direction in which vertical indices and real z increase. Down: world z decreases with them, as for time and
   * depth. Up: world z increases with them. Default: Down.
   */
  vtkSetClampMacro(VerticalDirection, int, Down, Up);
  vtkGetMacro(VerticalDirection, int);
  void SetVerticalDirectionToDown() { this->SetVerticalDirection(Down); }
  void SetVerticalDirectionToUp() { this->SetVerticalDirection(Up); }
  ///@}

  /// Values of DuplicatePolicy.
  enum DuplicateChoice
  {
    StrongestAmplitude = 0,
    Topmost = 1,
    Lowest = 2,
    Sheets = 3
  };

  ///@{
  /**
   * Which of several voxels of a horizon in one column is kept. StrongestAmplitude: the one with the largest absolute
   * amplitude, of equal ones the topmost. Topmost, Lowest: the one with the smallest or largest vertical index.
   * Sheets: all, as at reverse faults; each connected sheet becomes a horizon; not with LeastMemory. Voxels left out
   * are counted in the field data DroppedDuplicates. See "Sheets" in VerneySparseMatrixReader.md. Default:
   * StrongestAmplitude.
   *
   * The second sheet is named "Horizon 7 (2)"; see ColumnSheets.h.
   */
  vtkSetClampMacro(DuplicatePolicy, int, StrongestAmplitude, Sheets);
  vtkGetMacro(DuplicatePolicy, int);
  void SetDuplicatePolicyToStrongestAmplitude() { this->SetDuplicatePolicy(StrongestAmplitude); }
  void SetDuplicatePolicyToTopmost() { this->SetDuplicatePolicy(Topmost); }
  void SetDuplicatePolicyToLowest() { this->SetDuplicatePolicy(Lowest); }
  void SetDuplicatePolicyToSheets() { this->SetDuplicatePolicy(Sheets); }
  ///@}

protected:
  vtkVerneySparseMatrixReader();
  ~vtkVerneySparseMatrixReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  void CheckParameters() override;
  /// "Horizon <ID>", by ascending ID.
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
  int DuplicatePolicy = StrongestAmplitude;

  bool FileHasOverview = false;
  std::unique_ptr<SeismicHorizons::SparseMatrixFile> File; // the one that was read last, and what was found in it
};

#endif
