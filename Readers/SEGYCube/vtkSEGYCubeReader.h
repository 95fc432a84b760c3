// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSEGYCubeReader
 * @brief   reads a post-stack seismic cube or line from a SEG-Y file
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
   * The SEG-Y file; several files are time steps. See "Series of files" in Window.md. Range: a path in UTF-8. Default:
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
   * Trace header byte of the inline number; 189 in the standard. 0 for InlineByte and CrosslineByte: found
   * automatically. -1: all traces are on one inline. Range: -1 to 237. Default: 0.
   */
  vtkHorizonNumberMacro(InlineByte, int);

  /**
   * As InlineByte, for the crossline; 193 in the standard. Range: -1 to 237. Default: 0.
   *
   * Only one of the two can be -1.
   */
  vtkHorizonNumberMacro(CrosslineByte, int);

  /**
   * Trace header byte of x; 181 in the standard. 0 for XByte and YByte: found automatically. -1 for both: x is the
   * crossline, y the inline. Range: -1 to 237. Default: 0.
   */
  vtkHorizonNumberMacro(XByte, int);

  /**
   * As XByte, for y; 185 in the standard. Range: -1 to 237. Default: 0.
   */
  vtkHorizonNumberMacro(YByte, int);

  /**
   * First and last inline; 0, -1 for all. Unit: line numbers. Range: any. Default: 0, -1.
   */
  vtkHorizonVectorMacro(InlineRange, int, 2);

  /**
   * First and last crossline; 0, -1 for all. Unit: line numbers. Range: any. Default: 0, -1.
   */
  vtkHorizonVectorMacro(CrosslineRange, int, 2);

  /**
   * First and last sample (k). Unit: vertical indices. Range: at least 0, or -1 for the end. Default: 0, -1.
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
   * Sample format; set it if many samples are missing or all look like noise. Default: FromFile.
   */
  vtkHorizonNumberMacro(SampleFormat, int);

  /**
   * Samples per trace. 0: as the file states, or its traces if that does not fit. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(NumberOfSamples, int);

  /**
   * Skips an incomplete last trace, with a warning. Off: an error. Default: off.
   */
  vtkHorizonFlagMacro(IgnoreIncompleteTrace);

  /**
   * Which of several traces in a column is used, dead ones last. Refuse: an error. First, Last: in file order. Mean:
   * their mean, without zero traces. Default: Refuse.
   */
  vtkHorizonChoice4Macro(DuplicatePolicy, DuplicateChoice, Refuse, First, Last, Mean);

  /**
   * How traces with delays off by fractions of a step are aligned. Interpolate: cubic. Nearest: by up to half a step.
   * Default: Interpolate.
   */
  vtkHorizonChoice2Macro(DelayPolicy, DelayChoice, Interpolate, Nearest);

  /**
   * Sample interval. 0: a thousandth of that in the file: ms, or m or ft in most depth cubes. Unit: that of z. Range:
   * finite, at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(VerticalStep, double);

  /**
   * Direction of increasing time or depth. Default: Down.
   */
  vtkHorizonChoice2Macro(VerticalDirection, VerticalSense, Down, Up);

  /**
   * Unit of z: ms, s, m or ft; no conversion. Empty: ms; set m or ft for depth. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(VerticalUnit);

  /**
   * Time or depth. Empty: from the unit. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(VerticalDomain);

  /**
   * Unit of x and y: m or ft; no conversion. Empty: as in the file. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(HorizontalUnit);

  /**
   * Coordinate system; no conversion. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(CoordinateSystem);

  /**
   * Largest distance of traces from the lattice; a tenth may be farther off, with a warning. See "How line numbers are
   * found" in SEGYCube.md. Unit: columns. Range: more than 0, less than 0.5. Default: 0.25.
   */
  vtkHorizonNumberMacro(LatticeTolerance, double);

  /**
   * Largest shift of image points, as images cannot be sheared. Unit: columns. Range: at least 0. Default: 0.5.
   */
  vtkHorizonNumberMacro(ImageTolerance, double);

  /**
   * What was found in the headers.
   *
   * Empty before the first update.
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
