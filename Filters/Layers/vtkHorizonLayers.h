// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonLayers
 * @brief   makes closed volumes of the layers between horizons
 *
 * Input: as of vtkHorizonStackStage, before any simplification. Heights change only where horizons cross.
 *
 * All layers share one triangulation on the map, with a height of each horizon at every vertex, so that layers fit
 * together without gaps. Each known point of each horizon is within MaximumError, vertically. Outputs:
 *  - 0 Layers: a vtkUnstructuredGrid of wedges with shared points; pyramids and tetrahedra where layers pinch out. Cell
 *    data: Layer and Sublayer (int, 0 the uppermost), Triangle (vtkIdType, of the plan), Thickness (the mean of the
 *    sublayer), Volume (double), and FaultFaces (unsigned char, bit n for face n of the cell, which is at a fault).
 *    Field data: LayerNames, HorizonNames, and ChosenMaximumError (double, lattice units) where MaximumError is
 *    automatic;
 *  - 1 Bodies: a closed surface for each layer that faces outwards. Cell data: Face (unsigned char: 0 top, 1 base, 2
 *    outline, 3 fault) and Layer;
 *  - 2 Horizons: the horizons on the plan, the uppermost first, with the arrays of their points. Field data:
 *    LargestError (lattice units), MovedColumns and FarthestMove (world units), where they crossed. Bodies and
 *    horizons have a ledger, LedgerColumns and LedgerArea, bodies LedgerVolume, too;
 *  - 3 Figures: a row for each layer: volume, area, thickness, crossings, cells, what is left out at faults and where
 *    points are missing, and the ledger: area and volume with known, filled, bridged and extrapolated heights;
 *  - 4 Volumes: the volume of each layer above a level contact, at 101 heights.
 *
 * Volumes are in units of x and y times those of z (column VolumeUnit), with a warning if z is time. They are exact for
 * the layers, which end at the middle of the outermost columns; sums over bins reach half a bin further.
 *
 * Faults (field data FaultedLinks) of any horizon cut all layers, with walls on both sides of a strip of one column
 * that is left out (AreaAtFaults, VolumeAtFaults). A dipping fault cuts each horizon along another line; between these
 * lines the thickness is that of two blocks.
 *
 * Errors: fewer than two horizons, points between the columns of another horizon, different coordinate systems, domains
 * or units, no common column, or no clear order.
 *
 * @sa vtkHorizonCrossings vtkHorizonThickness vtkHorizonSurface
 */

#ifndef vtkHorizonLayers_h
#define vtkHorizonLayers_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonStackStage.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <string> // for the results

namespace SeismicHorizons
{
struct LayerStageOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonLayers : public vtkHorizonStackStage
{
public:
  static vtkHorizonLayers* New();
  vtkTypeMacro(vtkHorizonLayers, vtkHorizonStackStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Largest vertical distance of horizon points from the layers. -1: automatic, six times the noise of the noisiest
   * horizon. Unit: HeightUnit. Range: at least 0, or -1. Default: -1.
   */
  vtkHorizonNumberMacro(MaximumError, double);

  /**
   * Keep thickness within MaximumError, too. Off: within twice that, with fewer cells. Default: off.
   */
  vtkHorizonFlagMacro(BoundThickness);

  /**
   * End layers at lines through the outermost columns without them. Off: in thin feathers beyond. Default: on.
   */
  vtkHorizonFlagMacro(PinchOutLines);

  /**
   * Smallest area without a layer that gets a pinch-out line. Unit: columns. Range: at least 1. Default: 25.
   */
  vtkHorizonNumberMacro(SmallestPinch, int);

  /**
   * EachLayer: layers are where both their horizons are. Common: where all horizons are, with small holes closed and
   * outlines simplified within MaximumError, in map view at most 0.75 columns. Default: EachLayer.
   */
  vtkHorizonChoice2Macro(Domain, Domains, EachLayer, Common);

  /**
   * With Domain Common, keep outlines unchanged in map view. Default: off.
   *
   * Volumes then differ by heights alone.
   */
  vtkHorizonFlagMacro(KeepOutlines);

  /**
   * Divide layers at faults of the horizons (field data FaultedLinks). Default: on.
   */
  vtkHorizonFlagMacro(TearAtFaults);

  /**
   * Void: layers beside missing points are absent. Interpolate: holes and gaps are closed, up to LargestHoleSize and
   * LargestGap. Follow: also, a horizon missing between two others follows the nearer one, so that no rock is lost.
   * See "Where points are missing" in HorizonLayers.md. Default: Follow.
   */
  vtkHorizonChoice3Macro(Missing, MissingPolicies, Void, Interpolate, Follow);

  /**
   * Enclosed holes up to this size are closed, as by vtkHorizonHoleFilling. Unit: columns. Range: at least 0. Default:
   * 2500.
   */
  vtkHorizonNumberMacro(LargestHoleSize, int);

  /**
   * Gaps up to this width along rows or columns are interpolated linearly. Unit: columns. Range: 0 to 255. Default:
   * 10.
   */
  vtkHorizonNumberMacro(LargestGap, int);

  /**
   * How thoroughly the plan is optimised: Best leaves fewer cells than Fast, and takes longer. Default: Best.
   *
   * Fast inserts points where a horizon is farthest; Best then removes points, flips edges and fits heights.
   */
  vtkHorizonChoice2Macro(Effort, Efforts, Fast, Best);

  /**
   * Smallest angle in map view that optimisation may create. Points are added at sharper ones: all with the effort
   * Fast, below 2 degrees with Best. Unit: degrees. Range: 0 to 60. Default: 10.
   *
   * A change may leave a smaller angle where there was a smaller one before.
   */
  vtkHorizonNumberMacro(SmallestAngle, double);

  /**
   * For even cells: longest inner edge of the plan, as in vtkHorizonSurface. 0: off. Unit: columns. Range: 0, or at
   * least 4. Default: 0.
   */
  vtkHorizonNumberMacro(EdgeLength, double);

  /**
   * Growth of edges with distance from outlines, faults and pinch-out lines, as in vtkHorizonSurface. Range: 0 to 1.
   * Default: 0.
   */
  vtkHorizonNumberMacro(EdgeGrowth, double);

  /**
   * Fit heights of inner vertices to nearby points. Off: use those of points. Default: on.
   */
  vtkHorizonFlagMacro(FitHeights);

  /**
   * Sublayers of equal thickness: one number for all layers, or one each from the uppermost down, as "1 4 2"; empty:
   * 1. Range: numbers from 1 to 1000. Default: empty.
   */
  vtkHorizonTextMacro(Sublayers);

  /**
   * Sublayers are added until none is thicker. 0: no limit. Unit: HeightUnit. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(LargestSublayerThickness, double);

  /**
   * Split all cells into tetrahedra: a conforming mesh of the same volume. Default: off.
   */
  vtkHorizonFlagMacro(Tetrahedra);

  /**
   * Add the volume above Contact (VolumeAboveContact) to figures. Default: off.
   */
  vtkHorizonFlagMacro(MeasureAboveContact);

  /**
   * Height of a level fluid contact. Unit: that of z, upwards. Range: any. Default: 0.
   */
  vtkHorizonNumberMacro(Contact, double);

  /**
   * Cells, volume and thickness of each layer.
   *
   * Lines of text. Empty before the first update, and after an error.
   */
  const char* GetResults() { return this->Results.c_str(); }

protected:
  vtkHorizonLayers();
  ~vtkHorizonLayers() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonLayers(const vtkHorizonLayers&) = delete;
  void operator=(const vtkHorizonLayers&) = delete;

  SeismicHorizons::LayerStageOptions MakeOptions() const;

  double MaximumError = -1.0;
  bool BoundThickness = false;
  bool PinchOutLines = true;
  int SmallestPinch = 25;
  int Domain = EachLayer;
  bool KeepOutlines = false;
  bool TearAtFaults = true;
  int Missing = Follow;
  int LargestHoleSize = 2500;
  int LargestGap = 10;
  int Effort = Best;
  double SmallestAngle = 10.0;
  double EdgeLength = 0.0;
  double EdgeGrowth = 0.0;
  bool FitHeights = true;
  char* Sublayers = nullptr;
  double LargestSublayerThickness = 0.0;
  bool Tetrahedra = false;
  bool MeasureAboveContact = false;
  double Contact = 0.0;
  std::string Results;
};

#endif
