// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSEGYCubeReader
 * @brief   reads a post-stack seismic cube, or a line of one, from a SEG-Y file
 *
 * Each trace is placed by its inline and crossline numbers, so lines may be missing, truncated or in any order. The
 * header bytes of line numbers and coordinates are found (Documentation/SEGYCube.md) or set. Samples are IBM or
 * IEEE floats or integers, in either byte order.
 *
 * The first output is one vtkImageData: crosslines along i, inlines along j, samples along k, as in the lattice of
 * horizons of the same survey. Its extent is that of the window (InlineRange, CrosslineRange, SampleRange), in indices
 * of the whole cube. The image is rotated as the survey is. World z is time or depth, delays included, with the sign of
 * VerticalDirection.
 *
 * Point data:
 * - Amplitude (float): the samples; only integers of more than 24 bits and doubles are rounded
 * - vtkGhostType (unsigned char): hides points without a sample, whose Amplitude is 0: columns without a trace, dead
 *   traces, traces of zeros, samples of 1e30 or more or nan, and, where delays differ, points above or below a trace.
 *   Only if the window has such points
 *
 * Field data, one tuple each:
 * - LatticeDimensions (int, 3 components): of the whole cube
 * - LatticeToWorld (double, 16 components): the affine map from (i, j, k) to world coordinates, row by row
 * - LineNumbers, LatticeDeviation, VerticalDirection, VerticalUnit, VerticalDomain, HorizontalUnit, CoordinateSystem:
 *   as from vtkHorizonTextReader
 * - StrongAmplitude (double): the 98th percentile of the absolute nonzero samples of 200 traces
 * - ImageDeviation (double): the largest distance, in columns, of image points from where LatticeToWorld has them; 0 if
 *   the steps of the survey are perpendicular
 * - TextHeader (string, 40 tuples): the lines of the textual header
 *
 * The second output is one vtkStructuredGrid, for files of one inline or crossline whose traces have x and y: the same
 * samples, each trace at its own position, also on bent lines. It is empty for other files.
 *
 * Headers are read once per file; the samples of a window on request, by several threads, and by each process its own
 * piece. Memory is that of the window, some megabytes per thread, and 4 bytes per trace of the file; up to 100 per
 * trace while headers are read.
 *
 * A file that is not a post-stack cube gives one error that starts with the name of the file; GetErrorCode() gives its
 * kind, as that of vtkHorizonSource.
 *
 * @sa vtkHorizonTextReader
 */

#ifndef vtkSEGYCubeReader_h
#define vtkSEGYCubeReader_h

#include "vtkHorizonFileSeries.h"
#include "vtkHorizonProperty.h"
#include "vtkImageAlgorithm.h"
#include "vtkSeismicHorizonsModule.h"

#include <memory>
#include <string>

namespace SeismicHorizons
{
class Monitor;
struct CubeView;
struct SEGYOptions;
struct SurveyDescription;
}

class VTKSEISMICHORIZONS_EXPORT vtkSEGYCubeReader : public vtkImageAlgorithm
{
public:
  static vtkSEGYCubeReader* New();
  vtkTypeMacro(vtkSEGYCubeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The SEG-Y file. Several files are time steps. See "Series of files" in Window.md. Range: a path in UTF-8. Default:
   * none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 if the file begins as SEG-Y files do: 3600 bytes and a trace header, with a valid format code, in either byte
   * order, and a number of samples. Without the extension .sgy, .segy or .seg it must also begin with text and end with
   * a whole trace, since other binary files may have such numbers there.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  /**
   * The byte of the inline number in trace headers, from 1; 189 in the standard. 0, with a CrosslineByte of 0: found
   * automatically. -1: none, all traces are on one inline. Range: -1 to 237. Default: 0.
   */
  vtkHorizonNumberMacro(InlineByte, int);

  /**
   * As InlineByte, for the crossline number; 193 in the standard. Range: -1 to 237. Default: 0.
   *
   * Only one of the two can be -1.
   */
  vtkHorizonNumberMacro(CrosslineByte, int);

  /**
   * The byte of x in trace headers, from 1; 181 in the standard. 0, with a YByte of 0: found automatically. -1, with a
   * YByte of -1: x is the crossline, y the inline. Range: -1 to 237. Default: 0.
   */
  vtkHorizonNumberMacro(XByte, int);

  /**
   * As XByte, for y; 185 in the standard. Range: -1 to 237. Default: 0.
   */
  vtkHorizonNumberMacro(YByte, int);

  /**
   * The first and last inline to read; 0, -1 for all. Unit: line numbers. Range: any. Default: 0, -1.
   */
  vtkHorizonVectorMacro(InlineRange, int, 2);

  /**
   * The first and last crossline to read; 0, -1 for all. Unit: line numbers. Range: any. Default: 0, -1.
   */
  vtkHorizonVectorMacro(CrosslineRange, int, 2);

  /**
   * The first and last sample (k) to read; -1 for the end. Unit: vertical indices. Range: at least 0, or -1 for the
   * end. Default: 0, -1.
   */
  vtkHorizonVectorMacro(SampleRange, int, 2);

  /// Values of SampleFormat: the codes of SEG-Y.
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

  /**
   * The sample format, for files that state a wrong one: many samples are then above 1e30 and thus missing, or all look
   * like noise. Default: FromFile.
   */
  vtkHorizonNumberMacro(SampleFormat, int);

  /**
   * The samples per trace. 0: as the file states, or as the traces do if that does not fit. Range: at least 0. Default:
   * 0.
   */
  vtkHorizonNumberMacro(NumberOfSamples, int);

  /**
   * Leaves out an incomplete last trace, with a warning. Off: it is an error. Default: off.
   */
  vtkHorizonFlagMacro(IgnoreIncompleteTrace);

  /**
   * Which of several traces with the same inline and crossline is used. Refuse: an error. First, Last: by order in the
   * file. Mean: their mean, without traces of zeros. Dead traces never count beside others. Default: Refuse.
   */
  vtkHorizonChoice4Macro(DuplicatePolicy, DuplicateChoice, Refuse, First, Last, Mean);

  /**
   * How traces are aligned whose delay is not whole steps from that of most others. Interpolate: by cubic polynomials.
   * Nearest: samples move by up to half a step. Default: Interpolate.
   */
  vtkHorizonChoice2Macro(DelayPolicy, DelayChoice, Interpolate, Nearest);

  /**
   * The step between samples. 0: a thousandth of the interval in the file, which is ms for time, m or ft in most depth
   * cubes. Unit: that of z. Range: finite, at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(VerticalStep, double);

  /**
   * The direction of world z in which time or depth increases. Default: Down.
   */
  vtkHorizonChoice2Macro(VerticalDirection, VerticalSense, Down, Up);

  /**
   * The unit of z: ms, s, m or ft, without conversion. Empty: ms; set m or ft for a depth cube. Range: any text.
   * Default: empty.
   */
  vtkHorizonTextMacro(VerticalUnit);

  /**
   * Time or depth. Empty: from the unit. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(VerticalDomain);

  /**
   * The unit of x and y: m or ft, without conversion. Empty: as in the file. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(HorizontalUnit);

  /**
   * The name of the coordinate system of x and y, without conversion. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(CoordinateSystem);

  /**
   * The largest distance of x and y from the lattice, as a fraction of the step. Up to a tenth of the traces may be
   * farther off, with a warning. If more are, within 0.55, as irregular midpoints are, the lattice is that of least
   * squares; otherwise line numbers replace x and y, both with a warning. Unit: columns. Range: more than 0, less than
   * 0.5. Default: 0.25.
   */
  vtkHorizonNumberMacro(LatticeTolerance, double);

  /**
   * The largest distance of image points from their true positions; images cannot be sheared, so lines must be nearly
   * perpendicular. Unit: columns. Range: at least 0. Default: 0.5.
   */
  vtkHorizonNumberMacro(ImageTolerance, double);

  /**
   * What was found in the headers: format and byte order, lines and their bytes, missing and dead traces, coordinates,
   * and vertical indices. Empty before the first update.
   */
  const char* GetDescription() { return this->Description.c_str(); }

protected:
  vtkSEGYCubeReader();
  ~vtkSEGYCubeReader() override;

  vtkTypeBool ProcessRequest(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSEGYCubeReader(const vtkSEGYCubeReader&) = delete;
  void operator=(const vtkSEGYCubeReader&) = delete;

  SeismicHorizons::SEGYOptions MakeOptions() const;
  SeismicHorizons::SurveyDescription MakeSurvey() const;
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
  int NumberOfSamples = 0;
  bool IgnoreIncompleteTrace = false;
  int DuplicatePolicy = Refuse;
  int DelayPolicy = Interpolate;
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
  bool IsInformationStopped = false;
  std::unique_ptr<FileContent> Content;
};

#endif
