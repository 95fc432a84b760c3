// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSEGYCubeReader
 * @brief   reads a seismic cube after stacking, or a line of one, from a SEG-Y file
 *
 * Every trace is put where its header says: by its inline and crossline number, whatever the order of the file, so that
 * lines may be missing, cut short or in any order. The bytes of the line numbers and places are found
 * (Documentation/SEGYCubeReader.md), or given. Floats of IBM and IEEE and integers are read, in either byte order.
 *
 * The output is one vtkImageData. Crosslines count along i, inlines along j, and samples along k, as on the lattice of
 * horizons of the same survey; its extent is that of the window (InlineRange, CrosslineRange, SampleRange) in the
 * indices of the whole cube. The image is turned as the survey is, so that its points are where traces and samples are.
 * World z is the time or depth of a sample, with the sign of VerticalDirection; the delay of the traces is in it.
 *
 * Point data:
 * - Amplitude (float): the samples; exact but for integers of more than 24 bits, and doubles, which are rounded
 * - vtkGhostType (unsigned char): hides points without a sample, whose Amplitude is 0: those of columns without a
 * trace, of traces that are dead by their header or are all zeros, and, where delays differ, above or below a trace.
 * Only where there are such points in the window
 *
 * Field data, one tuple each:
 * - LatticeDimensions (int, 3 components): of the whole cube
 * - LatticeToWorld (double, 16 components): the affine map from (i, j, k) to world coordinates, row by row
 * - LineNumbers, LatticeDeviation, VerticalDirection, VerticalUnit, VerticalDomain, HorizontalUnit, CoordinateSystem:
 * as from vtkHorizonTextReader
 * - ImageDeviation (double): how far, in columns, a point of the image is at most from where LatticeToWorld has it.
 *   Images can not be sheared; 0 where the steps of the survey are perpendicular
 * - TextHeader (string, 40 tuples): the lines of the text that the file begins with
 *
 * The headers of all traces are read once for each file, and the samples of a window when they are asked for: by
 * several threads, and by several processes each its own part. Memory is the window's and some megabytes for each
 * thread, and 4 bytes for each trace of the file; up to 100 for each while headers are looked at.
 *
 * What is no cube after stacking gives one error, which starts with the name of the file.
 *
 * @sa vtkHorizonTextReader
 */

#ifndef vtkSEGYCubeReader_h
#define vtkSEGYCubeReader_h

#include "vtkHorizonFileSeries.h" // for the files
#include "vtkImageAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for the description

namespace SeismicHorizons
{
class Monitor;
struct CubeView;
struct SEGYOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkSEGYCubeReader : public vtkImageAlgorithm
{
public:
  static vtkSEGYCubeReader* New();
  vtkTypeMacro(vtkSEGYCubeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The path of the file, in UTF-8. Several are a series: each is that of a time, 0, 1, 2 and so on in the
   * order in which they were added, and the output is that of the time which is asked for. SetFileName() takes one file
   * in place of all. GetFileName() without an index gives the first. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 when the file begins as SEG-Y files do: 3600 bytes and the header of a trace, with a format code there is, in
   * either byte order, and a number of samples.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * The bytes of the trace headers, counted from 1, where the numbers of inline and crossline begin (integers of 4
   * bytes). 0 for both: they are found. -1: there are none, all traces are on one line; only one of the two. Default:
   * 0.
   */
  vtkSetMacro(InlineByte, int);
  vtkGetMacro(InlineByte, int);
  vtkSetMacro(CrosslineByte, int);
  vtkGetMacro(CrosslineByte, int);
  ///@}

  ///@{
  /**
   * The bytes of the trace headers, counted from 1, where x and y begin (integers of 4 bytes, with the scalar of byte
   * 71). 0 for both: they are found. -1 for both: x is the crossline, and y the inline. Default: 0.
   */
  vtkSetMacro(XByte, int);
  vtkGetMacro(XByte, int);
  vtkSetMacro(YByte, int);
  vtkGetMacro(YByte, int);
  ///@}

  ///@{
  /**
   * The first and last inline and crossline that are read, by their numbers; all where the first is the larger one.
   * Default: 0, -1.
   */
  vtkSetVector2Macro(InlineRange, int);
  vtkGetVector2Macro(InlineRange, int);
  vtkSetVector2Macro(CrosslineRange, int);
  vtkGetVector2Macro(CrosslineRange, int);
  ///@}

  ///@{
  /**
   * The first and last vertical index (k) that are read, from 0; -1 stands for the last there is. Default: 0, -1.
   */
  vtkSetVector2Macro(SampleRange, int);
  vtkGetVector2Macro(SampleRange, int);
  ///@}

  /// How samples are stored. The values are the codes of SEG-Y.
  enum SampleFormatCode
  {
    FromFile = 0,
    IbmFloat = 1,
    Integer32 = 2,
    Integer16 = 3,
    IeeeFloat = 5,
    IeeeDouble = 6,
    Integer24 = 7,
    Integer8 = 8,
    Unsigned32 = 10,
    Unsigned16 = 11,
    Unsigned24 = 15,
    Unsigned8 = 16
  };

  ///@{
  /**
   * How samples are stored, where the file says something else than it has. Default: FromFile.
   */
  vtkSetMacro(SampleFormat, int);
  vtkGetMacro(SampleFormat, int);
  ///@}

  ///@{
  /**
   * The step from a sample to the next, in the unit of z. 0: a thousandth of the interval of the file, which is
   * milliseconds for time, and metres or feet in most files of depth. Finite, at least 0. Default: 0.
   */
  vtkSetMacro(VerticalStep, double);
  vtkGetMacro(VerticalStep, double);
  ///@}

  /// Where time or depth grows to.
  enum VerticalSense
  {
    Down = 0,
    Up = 1
  };

  ///@{
  /**
   * Where time or depth grows to. Down: to smaller world z. Up: to larger world z. Default: Down.
   */
  vtkSetClampMacro(VerticalDirection, int, Down, Up);
  vtkGetMacro(VerticalDirection, int);
  void SetVerticalDirectionToDown() { this->SetVerticalDirection(Down); }
  void SetVerticalDirectionToUp() { this->SetVerticalDirection(Up); }
  ///@}

  ///@{
  /**
   * What is put into the field data: the unit of z ("ms", "s", "m", "ft"), whether z is "time" or "depth", the unit of
   * x and y, and the name of their coordinate system. They change no number. Default: empty, for what the file says; it
   * says "ms" and "time" always, as its standard does.
   */
  vtkSetStringMacro(VerticalUnit);
  vtkGetStringMacro(VerticalUnit);
  vtkSetStringMacro(VerticalDomain);
  vtkGetStringMacro(VerticalDomain);
  vtkSetStringMacro(HorizontalUnit);
  vtkGetStringMacro(HorizontalUnit);
  vtkSetStringMacro(CoordinateSystem);
  vtkGetStringMacro(CoordinateSystem);
  ///@}

  ///@{
  /**
   * How far traces may be off their columns, as a part of the step, for x and y to be used: whole metres are up to
   * 0.1 off where lines are 6 m apart. More than 0, less than 0.5. Default: 0.25.
   */
  vtkSetMacro(LatticeTolerance, double);
  vtkGetMacro(LatticeTolerance, double);
  ///@}

  ///@{
  /**
   * How far, in columns, points of the image may be from where LatticeToWorld has them. A survey whose steps are too
   * far from perpendicular for that is an error, which says how far they are. At least 0. Default: 0.5.
   */
  vtkSetMacro(ImageTolerance, double);
  vtkGetMacro(ImageTolerance, double);
  ///@}

  /**
   * What was found in the file, for people: lines of text. Empty before the first update.
   */
  const char* GetDescription() { return this->Description.c_str(); }

protected:
  vtkSEGYCubeReader();
  ~vtkSEGYCubeReader() override;

  vtkTypeBool ProcessRequest(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSEGYCubeReader(const vtkSEGYCubeReader&) = delete;
  void operator=(const vtkSEGYCubeReader&) = delete;

  SeismicHorizons::SEGYOptions MakeOptions() const;
  SeismicHorizons::CubeView MakeView() const;
  void UpdateContent(const SeismicHorizons::Monitor& monitor);

  SeismicHorizons::FileSeries Files;
  int InlineByte = 0;
  int CrosslineByte = 0;
  int XByte = 0;
  int YByte = 0;
  int InlineRange[2] = { 0, -1 };
  int CrosslineRange[2] = { 0, -1 };
  int SampleRange[2] = { 0, -1 };
  int SampleFormat = FromFile;
  double VerticalStep = 0.0;
  int VerticalDirection = Down;
  char* VerticalUnit = nullptr;
  char* VerticalDomain = nullptr;
  char* HorizontalUnit = nullptr;
  char* CoordinateSystem = nullptr;
  double LatticeTolerance = 0.25;
  double ImageTolerance = 0.5;
  std::string Description;

  struct FileContent;
  std::unique_ptr<FileContent> Content; // what was found when the headers were read last
};

#endif
