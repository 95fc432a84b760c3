// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSEGYCubeReader
 * @brief   reads a post-stack seismic cube, or a line of one, from a SEG-Y file
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
 * - StrongAmplitude (double): the size that 98 % of the samples stay below, by 200 traces all over the file; zeros do not count.
 * - ImageDeviation (double): how far, in columns, a point of the image is at most from where LatticeToWorld has it.
 *   Images cannot be sheared; 0 where the steps of the survey are perpendicular
 * - TextHeader (string, 40 tuples): the lines of the text that the file begins with
 *
 * The headers of all traces are read once for each file, and the samples of a window when they are asked for: by
 * several threads, and by several processes each its own part. Memory is the window's and some megabytes for each
 * thread, and 4 bytes for each trace of the file; up to 100 for each while headers are looked at.
 *
 * The second output is one vtkStructuredGrid, for files of one inline or crossline whose traces have x and y: the same
 * samples, each trace where its own header says, on a line that need not be straight. It is empty for other files.
 *
 * What is no cube after stacking gives one error, which starts with the name of the file; GetErrorCode() says what
 * kind, as that of vtkHorizonSource does.
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
   * The SEG-Y file. Several are a series: the first for time 0, the second for time 1, and so on. See "Series of files"
   * in Window.md. Range: a path in UTF-8. Default: none.
   */
  vtkHorizonFileNamesMacro();
  ///@}

  /**
   * 1 when the file begins as SEG-Y files do: 3600 bytes and the header of a trace, with a format code there is, in
   * either byte order, and a number of samples. Where its name does not end in .sgy, .segy or .seg, it has to begin with
   * text, and end with a trace, as other binary files may have such numbers there.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * The byte of the trace headers, from 1, of the inline number, a 4-byte integer: 189 by the standard, 9 or 5 in many
   * files. 0 here and for the crossline: found automatically. -1: none, all traces are on one inline. Range: -1 to
   * 237. Default: 0.
   */
  vtkSetMacro(InlineByte, int);
  vtkGetMacro(InlineByte, int);
  ///@}

  ///@{
  /**
   * The byte of the trace headers, from 1, of the crossline number, a 4-byte integer: 193 by the standard, 21 or 13 in
   * many files. 0 here and for the inline: found automatically. -1: none, all traces are on one crossline. Range: -1
   * to 237. Default: 0.
   *
   * Only one of the two can be -1.
   */
  vtkSetMacro(CrosslineByte, int);
  vtkGetMacro(CrosslineByte, int);
  ///@}

  ///@{
  /**
   * The byte of the trace headers, from 1, of x, a 4-byte integer with the scalar of byte 71: 181 by the standard, 73
   * or 81 in many files. 0 for x and y: found automatically. -1 for both: x is the crossline, and y the inline. Range:
   * -1 to 237. Default: 0.
   */
  vtkSetMacro(XByte, int);
  vtkGetMacro(XByte, int);
  ///@}

  ///@{
  /**
   * The byte of the trace headers, from 1, of y, a 4-byte integer with the scalar of byte 71: 185 by the standard, 77
   * or 85 in many files. 0 for x and y: found automatically. -1 for both: x is the crossline, and y the inline. Range:
   * -1 to 237. Default: 0.
   */
  vtkSetMacro(YByte, int);
  vtkGetMacro(YByte, int);
  ///@}

  ///@{
  /**
   * The first and the last inline to read; 0, -1 for all. Unit: line numbers. Range: any. Default: 0, -1.
   */
  vtkSetVector2Macro(InlineRange, int);
  vtkGetVector2Macro(InlineRange, int);
  ///@}

  ///@{
  /**
   * The first and the last crossline to read; 0, -1 for all. Unit: line numbers. Range: any. Default: 0, -1.
   */
  vtkSetVector2Macro(CrosslineRange, int);
  vtkGetVector2Macro(CrosslineRange, int);
  ///@}

  ///@{
  /**
   * The first and the last sample (k) to read; -1 stands for the end. Unit: vertical indices. Range: at least 0, or -1
   * for the end. Default: 0, -1.
   */
  vtkSetVector2Macro(SampleRange, int);
  vtkGetVector2Macro(SampleRange, int);
  ///@}

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

  ///@{
  /**
   * The format of samples, for files that state a wrong one: amplitudes are then around 1e30, or look like noise.
   * Default: FromFile.
   */
  vtkSetMacro(SampleFormat, int);
  vtkGetMacro(SampleFormat, int);
  ///@}

  ///@{
  /**
   * The number of samples of a trace. 0: that of the file, or of the traces if it does not fit them. Range: at least
   * 0. Default: 0.
   */
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Whether an incomplete last trace is left out, with a warning. Off: it is an error. Default: off.
   */
  vtkSetMacro(IgnoreIncompleteTrace, bool);
  vtkGetMacro(IgnoreIncompleteTrace, bool);
  vtkBooleanMacro(IgnoreIncompleteTrace, bool);
  ///@}

  /// Values of DuplicatePolicy.
  enum DuplicateChoice
  {
    Refuse = 0,
    First = 1,
    Last = 2,
    Mean = 3
  };

  ///@{
  /**
   * How several traces with the same inline and crossline are treated. Refuse: an error. First, Last: the first or the
   * last in the file. Mean: the mean of their samples, without traces of zeros. Dead traces never count beside others.
   * Default: Refuse.
   */
  vtkSetClampMacro(DuplicatePolicy, int, Refuse, Mean);
  vtkGetMacro(DuplicatePolicy, int);
  void SetDuplicatePolicyToRefuse() { this->SetDuplicatePolicy(Refuse); }
  void SetDuplicatePolicyToFirst() { this->SetDuplicatePolicy(First); }
  void SetDuplicatePolicyToLast() { this->SetDuplicatePolicy(Last); }
  void SetDuplicatePolicyToMean() { this->SetDuplicatePolicy(Mean); }
  ///@}

  /// Values of DelayPolicy.
  enum DelayChoice
  {
    Interpolate = 0,
    Nearest = 1
  };

  ///@{
  /**
   * How traces are treated whose delay is not whole steps from that of most others; there is a warning. Interpolate:
   * samples at whole steps, by cubic polynomials. Nearest: samples move by up to half a step. Default: Interpolate.
   */
  vtkSetClampMacro(DelayPolicy, int, Interpolate, Nearest);
  vtkGetMacro(DelayPolicy, int);
  void SetDelayPolicyToInterpolate() { this->SetDelayPolicy(Interpolate); }
  void SetDelayPolicyToNearest() { this->SetDelayPolicy(Nearest); }
  ///@}

  ///@{
  /**
   * The step between samples. 0: a thousandth of the interval in the file: milliseconds for time, metres or feet in
   * most depth cubes. Unit: that of z. Range: finite, at least 0. Default: 0.
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
   * The direction in which time or depth increases. Down: world z decreases with it. Up: world z increases with it.
   * Default: Down.
   */
  vtkSetClampMacro(VerticalDirection, int, Down, Up);
  vtkGetMacro(VerticalDirection, int);
  void SetVerticalDirectionToDown() { this->SetVerticalDirection(Down); }
  void SetVerticalDirectionToUp() { this->SetVerticalDirection(Up); }
  ///@}

  ///@{
  /**
   * The unit of z for the field data: ms, s, m or ft, without conversion. Empty: ms, as in the standard; choose m or
   * ft for a depth cube. Range: any text. Default: empty.
   */
  vtkSetStringMacro(VerticalUnit);
  vtkGetStringMacro(VerticalUnit);
  ///@}

  ///@{
  /**
   * Whether z is time or depth, for the field data, without conversion. Empty: from the unit. Range: any text.
   * Default: empty.
   */
  vtkSetStringMacro(VerticalDomain);
  vtkGetStringMacro(VerticalDomain);
  ///@}

  ///@{
  /**
   * The unit of x and y for the field data: m or ft, without conversion. Empty: as in the file. Range: any text.
   * Default: empty.
   */
  vtkSetStringMacro(HorizontalUnit);
  vtkGetStringMacro(HorizontalUnit);
  ///@}

  ///@{
  /**
   * The name of the coordinate system of x and y, for the field data, without conversion. Range: any text. Default:
   * empty.
   */
  vtkSetStringMacro(CoordinateSystem);
  vtkGetStringMacro(CoordinateSystem);
  ///@}

  ///@{
  /**
   * The largest distance of x and y from the lattice, as a fraction of the step. Up to a tenth of the traces may be
   * farther off, with a warning; if more are, line numbers replace x and y. Whole metres are up to 0.1 off if lines
   * are 6 m apart. Unit: columns. Range: more than 0, less than 0.5. Default: 0.25.
   */
  vtkSetMacro(LatticeTolerance, double);
  vtkGetMacro(LatticeTolerance, double);
  ///@}

  ///@{
  /**
   * The largest distance of points of the image from their true places. Images can be rotated, but not sheared: lines
   * too far from perpendicular are an error. Unit: columns. Range: at least 0. Default: 0.5.
   */
  vtkSetMacro(ImageTolerance, double);
  vtkGetMacro(ImageTolerance, double);
  ///@}

  /**
   * What was found in the headers: format and byte order, the inlines and crosslines and the bytes of their numbers,
   * missing and dead traces, coordinates, and vertical indices. Empty before the first update.
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
  std::unique_ptr<FileContent> Content; // what was found when the headers were read last
};

#endif
