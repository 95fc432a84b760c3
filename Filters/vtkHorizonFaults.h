// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonFaults
 * @brief   detects faults in a horizon, or uses fault lines that you supply
 *
 * Input 0: a horizon, or a composite dataset of such; at most one point in a column of the lattice. Input 1, which may
 * be left out: fault traces, polygons or sticks, as lines or polygons of vtkPolyData in world coordinates. Of traces and
 * polygons only the places on the map count.
 *
 * Output 0: the horizon with all its points, arrays and cells, but without points inside fault polygons (Polygons). New
 * field data, in place of such as there are; a link joins two neighbouring columns of the lattice:
 *  - CutLinks (3 int): i, j and side of each link that a fault cuts; side 0 is the link to column (i + 1, j), 1 that to
 *    (i, j + 1). By j, i and side, each once. Columns may be missing
 *  - CutThrow (double): height beyond the link minus height before it, in vertical indices; nan where it is not known
 *  - CutLine (int): the number of the fault line that the link belongs to
 *  - FaultNoise (double, one value): standard deviation of height differences due to noise alone, in vertical indices
 *  - SmallestFaultThrow (double, one value): the smallest throw that a fault reaches somewhere, in vertical indices, as
 *    it was given or follows from the noise
 *  - BlankedPoints (vtkIdType, one value): how many points inside polygons were left out, where lines are given
 * Later stages mesh each side of the cuts independently.
 *
 * Output 1: the fault lines as polylines, with the point data array Throw (double): how much larger the vertical index
 * is on the left of the line than on its right; lines run so that it is positive on the whole. Cell data: FaultLine
 * (int).
 *
 * Output 2: with Sticks the surfaces of faults, as triangles between sticks that stand side by side; empty for all
 * horizons but the first, as they are the same. Cell data: FaultName (string).
 *
 * With Detect, a link may be cut where the height difference, less the median of those within three columns, is at
 * least the larger of 2.5 times the noise and half of SmallestThrow. Such links are joined where they meet, over gaps
 * of a link or two; groups with five links of the larger of 4 times the noise and SmallestThrow stay when they are long
 * enough. Of each group a tree is kept that has the largest differences, without short branches. Gaps of up to
 * LargestGap missing columns are cut in the middle when planes through the points on both sides are as far apart there.
 * Faults that bend the surface over up to LargestRamp columns are cut in the middle: where the mean height of as many
 * columns beyond a link, less that of those before it, is at its largest, and falls within half of that width.
 * Lines on both sides of a hole are joined when they are in line and their throws are alike (JoinThroughHoles).
 *
 * Linear time, on several threads, with the same result on any number of them; 16 bytes per column of the bounding box,
 * wide bands without points left out, and 16 per point beyond input and output.
 *
 * Errors: two points in one column, a point between columns or off the lattice, no lattice in the field data, a
 * parameter out of its range, a line with a point that is not finite, polygons around all points. A warning where no
 * given line passes the horizon.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonHoleFilling
 */

#ifndef vtkHorizonFaults_h
#define vtkHorizonFaults_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <vector>

namespace SeismicHorizons
{
struct FaultDetectionOptions;
struct LatticePoints;
struct MapPlace;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonFaults : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonFaults* New();
  vtkTypeMacro(vtkHorizonFaults, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Polygons.
  enum PolygonUses
  {
    Blank = 0,
    Cut = 1,
    Leave = 2
  };

  ///@{
  /**
   * Whether surfaces of Sticks continue at both ends by the distance of the last two sticks. Default: off.
   */
  vtkSetMacro(ExtendSticks, bool);
  vtkGetMacro(ExtendSticks, bool);
  vtkBooleanMacro(ExtendSticks, bool);
  ///@}

  ///@{
  /**
   * What fault polygons among Traces do. Blank: points inside, where values are made up, are left out. Cut: they stay,
   * as islands. Leave: nothing. Default: Blank.
   */
  vtkSetClampMacro(Polygons, int, Blank, Leave);
  vtkGetMacro(Polygons, int);
  void SetPolygonsToBlank() { this->SetPolygons(Blank); }
  void SetPolygonsToCut() { this->SetPolygons(Cut); }
  void SetPolygonsToLeave() { this->SetPolygons(Leave); }
  ///@}

  ///@{
  /**
   * Whether faults are detected in the heights. Off: only lines that you supply cut. Default: on.
   */
  vtkSetMacro(Detect, bool);
  vtkGetMacro(Detect, bool);
  vtkBooleanMacro(Detect, bool);
  ///@}

  ///@{
  /**
   * The throw that a fault must reach somewhere; its ends are found down to half of it. 0: eight times the noise of the
   * heights of each horizon. Unit: ThrowUnit. Range: at least 0. Default: 0.
   */
  vtkSetMacro(SmallestThrow, double);
  vtkGetMacro(SmallestThrow, double);
  ///@}

  ///@{
  /**
   * Standard deviation of height differences between neighbouring columns due to noise alone. 0: measured on each
   * horizon. Unit: ThrowUnit. Range: at least 0. Default: 0.
   */
  vtkSetMacro(Noise, double);
  vtkGetMacro(Noise, double);
  ///@}

  /// Values of ThrowUnit.
  enum ThrowUnits
  {
    Lattice = 0,
    World = 1
  };

  ///@{
  /**
   * The unit of SmallestThrow and Noise. Lattice: one vertical index, a voxel. World: the unit of z. Default: Lattice.
   */
  vtkSetClampMacro(ThrowUnit, int, Lattice, World);
  vtkGetMacro(ThrowUnit, int);
  void SetThrowUnitToLattice() { this->SetThrowUnit(Lattice); }
  void SetThrowUnitToWorld() { this->SetThrowUnit(World); }
  ///@}

  ///@{
  /**
   * The least extent of a fault along i or j. Unit: columns. Range: at least 0. Default: 20.
   */
  vtkSetMacro(SmallestExtent, int);
  vtkGetMacro(SmallestExtent, int);
  ///@}

  ///@{
  /**
   * Branches of a fault with fewer cut links are dropped. Unit: links. Range: at least 0. Default: 10.
   */
  vtkSetMacro(SmallestBranch, int);
  vtkGetMacro(SmallestBranch, int);
  ///@}

  ///@{
  /**
   * Faults are followed across up to this many missing columns in a row. Unit: columns. Range: at least 0. Default: 5.
   */
  vtkSetMacro(LargestGap, int);
  vtkGetMacro(LargestGap, int);
  ///@}

  ///@{
  /**
   * Also finds faults that bend the surface over up to this many columns instead of tearing it, and cuts them in the
   * middle. 0: none. Unit: columns. Range: 0 to 10. Default: 7.
   */
  vtkSetMacro(LargestRamp, int);
  vtkGetMacro(LargestRamp, int);
  ///@}

  ///@{
  /**
   * Whether fault lines that end at a hole and point to each other become one, if their throws are similar. Default:
   * on.
   */
  vtkSetMacro(JoinThroughHoles, bool);
  vtkGetMacro(JoinThroughHoles, bool);
  vtkBooleanMacro(JoinThroughHoles, bool);
  ///@}

  /**
   * Standard deviation of height differences due to noise alone, in vertical indices; the largest of all horizons of
   * the last update.
   */
  vtkGetMacro(MeasuredNoise, double);

  /// How many lines cut links, in all horizons of the last update.
  vtkGetMacro(NumberOfFaultLines, vtkIdType);

  /// How many links between columns are cut, in all horizons of the last update.
  vtkGetMacro(NumberOfCutLinks, vtkIdType);

  /// Values of LineType.
  enum LineTypes
  {
    Traces = 0,
    Sticks = 1
  };

  ///@{
  /**
   * What the fault lines are. Traces: fault traces or polygons, seen from above. Sticks: lines down faults; the horizon
   * is cut where it meets the surface between them, the third output. Default: Traces.
   *
   * Sticks of one fault agree in all words of the cell array FaultName but the last.
   */
  vtkSetClampMacro(LineType, int, Traces, Sticks);
  vtkGetMacro(LineType, int);
  void SetLineTypeToTraces() { this->SetLineType(Traces); }
  void SetLineTypeToSticks() { this->SetLineType(Sticks); }
  ///@}

  ///@{
  /**
   * Fault traces, polygons or sticks in the coordinates of the horizon, as of vtkFaultLinesReader; optional. Unit:
   * world units. Range: lines, polygons. Default: none.
   *
   * Input 1.
   */
  void SetFaultLinesConnection(vtkAlgorithmOutput* lines) { this->SetInputConnection(1, lines); }
  void RemoveFaultLines() { this->SetInputConnection(1, nullptr); }
  ///@}

protected:
  vtkHorizonFaults();
  ~vtkHorizonFaults() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void ProcessHorizon(vtkPolyData* input, const Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonFaults(const vtkHorizonFaults&) = delete;
  void operator=(const vtkHorizonFaults&) = delete;

  SeismicHorizons::FaultDetectionOptions MakeOptions() const;
  void UsePolygons(std::vector<std::vector<SeismicHorizons::MapPlace>>& polylines,
    SeismicHorizons::LatticePoints& points, const Outputs& outputs);

  int LineType = Traces;
  bool ExtendSticks = false;
  int Polygons = Blank;
  bool Detect = true;
  double SmallestThrow = 0.0;
  double Noise = 0.0;
  int ThrowUnit = Lattice;
  int SmallestExtent = 20;
  int SmallestBranch = 10;
  int LargestGap = 5;
  int LargestRamp = 7;
  bool JoinThroughHoles = true;
  double MeasuredNoise = 0.0;
  vtkIdType NumberOfFaultLines = 0;
  vtkIdType NumberOfCutLinks = 0;
  vtkIdType NumberOfGivenLines = 0; // that the last horizon was given
  bool DoesGivenLineCut = false; // any link of any horizon
};

#endif
