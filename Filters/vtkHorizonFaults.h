// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonFaults
 * @brief   where faults tear a horizon: found in its heights, or along given lines
 *
 * Input 0: a horizon, or a composite dataset of such; at most one point in a column of the lattice. Input 1, which may
 * be left out: fault traces or polygons, as lines or polygons of vtkPolyData in world coordinates; only their places on
 * the map count.
 *
 * Output 0: the horizon with all its points, arrays and cells. New field data, in place of such as there are; a link
 * joins two neighbouring columns of the lattice:
 *  - CutLinks (3 int): i, j and side of each link that a fault cuts; side 0 is the link to column (i + 1, j), 1 that to
 *    (i, j + 1). By j, i and side, each once. Columns may be missing
 *  - CutThrow (double): height beyond the link minus height before it, in vertical indices; nan where it is not known
 *  - CutLine (int): the number of the fault line that the link belongs to
 *  - FaultNoise (double, one value): standard deviation of height differences by noise alone, in vertical indices
 * The stages after it mesh each side of the cuts for itself.
 *
 * Output 1: the fault lines as polylines, with the point data array Throw (double): how much larger the vertical index
 * is on the left of the line than on its right; lines run so that it is positive on the whole. Cell data: FaultLine
 * (int).
 *
 * With Detect, a link may be cut where the height difference, less the median of those within three columns, is at
 * least the larger of 2.5 times the noise and half of SmallestThrow. Such links are joined where they meet, over gaps
 * of a link or two; groups with five links of the larger of 4 times the noise and SmallestThrow stay when they are long
 * enough. Of each group a tree is kept that has the largest differences, without short branches. Gaps of up to
 * LargestGap missing columns are cut in the middle when planes through the points on both sides are as far apart there.
 * Faults that bend by ramps of several columns show as bundles of lines, or are missed where no single step is large.
 *
 * Linear time, on several threads, with the same result on any number of them; 16 bytes per column of the bounding box
 * and 16 per point beyond input and output.
 *
 * Errors: two points in one column, a point between columns or off the lattice, no lattice in the field data, a
 * parameter out of its range, a line with a point that is not finite. A warning where no given line passes the horizon.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonHoleFilling
 */

#ifndef vtkHorizonFaults_h
#define vtkHorizonFaults_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

namespace SeismicHorizons
{
struct FaultDetectionOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonFaults : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonFaults* New();
  vtkTypeMacro(vtkHorizonFaults, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether faults are looked for in the heights. Off: only given lines cut. Default: on.
   */
  vtkSetMacro(Detect, bool);
  vtkGetMacro(Detect, bool);
  vtkBooleanMacro(Detect, bool);
  ///@}

  ///@{
  /**
   * Only faults that somewhere throw by this much are found, in vertical indices; at least 0. Their ends, with smaller
   * throws down to half of it, are found with them. Default: 4.
   */
  vtkSetMacro(SmallestThrow, double);
  vtkGetMacro(SmallestThrow, double);
  ///@}

  ///@{
  /**
   * The standard deviation of differences between neighbouring columns by noise alone, in vertical indices; 0 to
   * measure it on each horizon. Default: 0.
   */
  vtkSetMacro(Noise, double);
  vtkGetMacro(Noise, double);
  ///@}

  ///@{
  /**
   * How many columns a fault spans along i or j at least. Default: 20.
   */
  vtkSetMacro(SmallestExtent, int);
  vtkGetMacro(SmallestExtent, int);
  ///@}

  ///@{
  /**
   * Branches of a fault that cut fewer links are left out. Default: 10.
   */
  vtkSetMacro(SmallestBranch, int);
  vtkGetMacro(SmallestBranch, int);
  ///@}

  ///@{
  /**
   * A fault is followed through gaps of at most so many missing columns, along i or j. Default: 5.
   */
  vtkSetMacro(LargestGap, int);
  vtkGetMacro(LargestGap, int);
  ///@}

  ///@{
  /**
   * Figures of the last update, all horizons together: the largest noise, the number of fault lines, and how many links
   * they cut.
   */
  vtkGetMacro(MeasuredNoise, double);
  vtkGetMacro(NumberOfFaultLines, vtkIdType);
  vtkGetMacro(NumberOfCutLinks, vtkIdType);
  ///@}

  /// What given lines are.
  enum LineTypes
  {
    Traces = 0,
    Sticks = 1
  };

  ///@{
  /**
   * What given lines are. Traces: they run along the horizon, seen from above, as fault traces and polygons do. Sticks:
   * they run down faults, and the trace of a fault goes through the places where its sticks, one after the other, pass
   * through the horizon; sticks of one fault agree in all words of the cell array FaultName but the last. Default:
   * Traces.
   */
  vtkSetClampMacro(LineType, int, Traces, Sticks);
  vtkGetMacro(LineType, int);
  void SetLineTypeToTraces() { this->SetLineType(Traces); }
  void SetLineTypeToSticks() { this->SetLineType(Sticks); }
  ///@}

  ///@{
  /**
   * The fault traces, polygons or sticks, input 1; none when they are removed.
   */
  void SetFaultLinesConnection(vtkAlgorithmOutput* lines) { this->SetInputConnection(1, lines); }
  void RemoveFaultLines() { this->SetInputConnection(1, nullptr); }
  ///@}

protected:
  vtkHorizonFaults();
  ~vtkHorizonFaults() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void ProcessHorizon(vtkPolyData* input, const Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonFaults(const vtkHorizonFaults&) = delete;
  void operator=(const vtkHorizonFaults&) = delete;

  SeismicHorizons::FaultDetectionOptions MakeOptions() const;

  int LineType = Traces;
  bool Detect = true;
  double SmallestThrow = 4.0;
  double Noise = 0.0;
  int SmallestExtent = 20;
  int SmallestBranch = 10;
  int LargestGap = 5;
  double MeasuredNoise = 0.0;
  vtkIdType NumberOfFaultLines = 0;
  vtkIdType NumberOfCutLinks = 0;
  vtkIdType NumberOfGivenLines = 0; // that the last horizon was given
  bool DoesGivenLineCut = false; // any link of any horizon
};

#endif
