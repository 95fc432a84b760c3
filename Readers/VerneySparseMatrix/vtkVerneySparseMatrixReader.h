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
struct HorizonPlacement;
struct LatticePlacement;
struct SparseMatrix;
struct SparseMatrixOptions;
struct SparseMatrixOverview;
}

class VTKSEISMICHORIZONS_EXPORT vtkVerneySparseMatrixReader : public vtkHorizonSource
{
public:
  static vtkVerneySparseMatrixReader* New();
  vtkTypeMacro(vtkVerneySparseMatrixReader, vtkHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The path of the file, in UTF-8. It may be compressed by gzip, whatever its name. Several are a series: each is that
   * of a time, 0, 1, 2 and so on in the order in which they were added, and the output is that of the time which is
   * asked for. SetFileName() takes one file in place of all. GetFileName() without an index gives the first. Default:
   * none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 for any name that ends in .vsm or .vsm.gz, in letters of either case: when something is wrong with the file,
   * reading it says what. For other names 1 when the first line of the file is what the format asks for: three positive
   * integers, separated by blanks, within the first 4095 bytes; else 0. A byte order mark before them is skipped.
   * Nothing else of the file is looked at.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * Horizons of fewer points, those in the ranges below, are not in the list. At least 1. Default: 1.
   */
  vtkSetMacro(SmallestHorizonSize, vtkIdType);
  vtkGetMacro(SmallestHorizonSize, vtkIdType);
  ///@}

  ///@{
  /**
   * The first and last column (i) and row (j) of the lattice that are loaded, counted from 0; -1 stands for the last
   * there is. The lattice stays that of the whole file. Default: 0, -1.
   */
  vtkSetVector2Macro(ColumnRange, int);
  vtkGetVector2Macro(ColumnRange, int);
  vtkSetVector2Macro(RowRange, int);
  vtkGetVector2Macro(RowRange, int);
  ///@}

  ///@{
  /**
   * Whether as little memory is used as can be, for files larger than it. On: a pass over the file lists the horizons,
   * and keeps nothing else but how many points each has in each row. Then only the selected ones are read, and of the
   * file only the RowRange. Listing and reading then takes two passes instead of one, but for other rows and horizons
   * the list is kept. It counts for nothing with a volume. Default: off.
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

  /// What horizons become.
  enum OutputKind
  {
    Points = 0,
    Images = 1,
    Volume = 2
  };

  ///@{
  /**
   * What horizons become. Points: a vtkPolyData each, for the stages. Images: a map each, as vtkImageData. Volume: the
   * output is one vtkImageData with all of them, and GetOutput() gives null; use GetOutputDataObject(0). For the last
   * two ColumnStep and RowStep must be perpendicular. Default: Points.
   */
  vtkSetClampMacro(OutputType, int, Points, Volume);
  vtkGetMacro(OutputType, int);
  void SetOutputTypeToPoints() { this->SetOutputType(Points); }
  void SetOutputTypeToImages() { this->SetOutputType(Images); }
  void SetOutputTypeToVolume() { this->SetOutputType(Volume); }
  ///@}

  /// What a volume covers.
  enum VolumeBox
  {
    Whole = 0,
    BoundingBox = 1
  };

  ///@{
  /**
   * What a volume covers. Whole: all cells of the lattice, whatever is chosen. BoundingBox: the least box with all
   * voxels of the chosen horizons. Default: Whole.
   */
  vtkSetClampMacro(VolumeExtent, int, Whole, BoundingBox);
  vtkGetMacro(VolumeExtent, int);
  void SetVolumeExtentToWhole() { this->SetVolumeExtent(Whole); }
  void SetVolumeExtentToBoundingBox() { this->SetVolumeExtent(BoundingBox); }
  ///@}

  /// What a volume shows.
  enum VolumeContent
  {
    SurfaceId = 0,
    Amplitude = 1,
    Thickness = 2
  };

  ///@{
  /**
   * The active scalars of a volume. SurfaceId is there always, each of the others when it is chosen. Default:
   * SurfaceId.
   */
  vtkSetClampMacro(VolumeArray, int, SurfaceId, Thickness);
  vtkGetMacro(VolumeArray, int);
  void SetVolumeArrayToSurfaceId() { this->SetVolumeArray(SurfaceId); }
  void SetVolumeArrayToAmplitude() { this->SetVolumeArray(Amplitude); }
  void SetVolumeArrayToThickness() { this->SetVolumeArray(Thickness); }
  ///@}

  ///@{
  /**
   * The SurfaceId of a volume where there is no voxel. It must not be the ID of a horizon that is loaded. Default: 0.
   */
  vtkSetMacro(BackgroundValue, int);
  vtkGetMacro(BackgroundValue, int);
  ///@}

  ///@{
  /**
   * The most memory that the arrays of a volume may take on a process, in MB (2^20 bytes). A larger volume is an error
   * that says how much it takes. At least 1. Default: 2048.
   */
  vtkSetMacro(VolumeMemoryLimit, int);
  vtkGetMacro(VolumeMemoryLimit, int);
  ///@}

  /// Where the z coordinate of a point comes from.
  enum ElevationSource
  {
    VerticalIndex = 0,
    RealZ = 1
  };

  ///@{
  /**
   * The z coordinate of the points. VerticalIndex: Origin's z, minus or plus VerticalStep times the vertical index.
   * RealZ: minus or plus the real z of the voxel, in the unit of the file; in place of Origin's z and VerticalStep,
   * LatticeToWorld then holds the straight line that fits it over the vertical index best, for all voxels in the ranges
   * (with LeastMemory those in the ColumnRange), so that a height of 1 in lattice units is one vertical index all the
   * same. (Where real z or the index is the same everywhere there is no such line, and Origin and VerticalStep hold.)
   * The sign is that of VerticalDirection. The voxels of a volume always lie where LatticeToWorld puts their vertical
   * index. Default: VerticalIndex.
   */
  vtkSetClampMacro(Elevation, int, VerticalIndex, RealZ);
  vtkGetMacro(Elevation, int);
  void SetElevationToVerticalIndex() { this->SetElevation(VerticalIndex); }
  void SetElevationToRealZ() { this->SetElevation(RealZ); }
  ///@}

  ///@{
  /**
   * The world coordinates of the centre of cell (0, 0, 0). Finite. Default: 0, 0, 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * The step in x and y from a cell to the next one along i, in world units. Finite, and not parallel to RowStep.
   * Default: 1, 0.
   */
  vtkSetVector2Macro(ColumnStep, double);
  vtkGetVector2Macro(ColumnStep, double);
  ///@}

  ///@{
  /**
   * The step in x and y from a cell to the next one along j, in world units. Finite, and not parallel to ColumnStep.
   * Default: 0, 1.
   */
  vtkSetVector2Macro(RowStep, double);
  vtkGetVector2Macro(RowStep, double);
  ///@}

  ///@{
  /**
   * The length along z from a vertical index to the next one, in world units: z is Origin's z minus (VerticalDirection
   * Down) or plus (Up) VerticalStep times the index. Finite, not 0; a negative one turns the direction around. Default:
   * 1.
   */
  vtkSetMacro(VerticalStep, double);
  vtkGetMacro(VerticalStep, double);
  ///@}

  /// Where vertical indices and real z grow to.
  enum VerticalSense
  {
    Down = 0,
    Up = 1
  };

  ///@{
  /**
   * Where vertical indices and real z grow to. Down: to smaller z, as time and depth do. Up: to larger z. Default:
   * Down.
   */
  vtkSetClampMacro(VerticalDirection, int, Down, Up);
  vtkGetMacro(VerticalDirection, int);
  void SetVerticalDirectionToDown() { this->SetVerticalDirection(Down); }
  void SetVerticalDirectionToUp() { this->SetVerticalDirection(Up); }
  ///@}

  /// Which voxel is kept when a horizon has several in one column.
  enum DuplicateChoice
  {
    StrongestAmplitude = 0,
    Topmost = 1,
    Lowest = 2,
    Sheets = 3
  };

  ///@{
  /**
   * Which voxel is kept when a horizon has several in one column. StrongestAmplitude: the one of largest absolute
   * amplitude, of equal ones that of smallest vertical index. Topmost: that of smallest vertical index. Lowest: that of
   * largest vertical index. The others are left out and counted in DroppedDuplicates. Sheets: all, as at reverse
   * faults: each sheet is a horizon of its own, the second named "Horizon 7 (2)", told apart by connection in space
   * (ColumnSheets.h). Not with LeastMemory. Default: StrongestAmplitude.
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

  SeismicHorizons::LatticePlacement MakePlacement() const;
  SeismicHorizons::HorizonPlacement MakeHorizonPlacement() const;
  SeismicHorizons::SparseMatrixOptions MakeOptions() const;
  void UpdateContent(const SeismicHorizons::Monitor& monitor);
  void UpdateOverview(const SeismicHorizons::Monitor& monitor);
  const SeismicHorizons::SparseMatrixOverview* FindOverview() const;
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
  int Elevation = VerticalIndex;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double ColumnStep[2] = { 1.0, 0.0 };
  double RowStep[2] = { 0.0, 1.0 };
  double VerticalStep = 1.0;
  int VerticalDirection = Down;
  int DuplicatePolicy = StrongestAmplitude;

  struct FileContent;
  std::unique_ptr<FileContent> Content; // what was found when the file was read last
};

#endif
