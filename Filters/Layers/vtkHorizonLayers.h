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
   * The largest vertical distance of a point of any horizon from the layers. -1: automatic, six times the noise of the
   * horizon that has the most. Unit: HeightUnit. Range: at least 0, or -1. Default: -1.
   */
  vtkHorizonNumberMacro(MaximumError, double);

  /**
   * Whether the thickness of each layer is within MaximumError, too. Off: within twice that, with fewer cells. Default:
   * off.
   */
  vtkHorizonFlagMacro(BoundThickness);

  /**
   * Whether layers end along lines through the outermost columns without them. Off: they end in thin feathers beyond.
   * Default: on.
   */
  vtkHorizonFlagMacro(PinchOutLines);

  /**
   * The smallest area without a layer that has a pinch-out line. Unit: columns. Range: at least 1. Default: 25.
   */
  vtkHorizonNumberMacro(SmallestPinch, int);

  /**
   * Where layers are. EachLayer: where both horizons of a layer are. Common: where all horizons are, with outlines simplified within MaximumError, at most 0.75 columns on the map, and small holes closed. Default:
   * EachLayer.
   */
  vtkHorizonChoice2Macro(Domain, Domains, EachLayer, Common);

  /**
   * Whether outlines of the domain Common stay unchanged on the map: volumes then differ by heights alone. Default:
   * off.
   */
  vtkHorizonFlagMacro(KeepOutlines);

  /**
   * Whether faults of the horizons (field data FaultedLinks) divide layers. Default: on.
   */
  vtkHorizonFlagMacro(TearAtFaults);

  /**
   * What happens where a horizon has no points. Void: both layers beside it are absent. Interpolate: its holes and gaps
   * are closed, up to LargestHoleSize and LargestGap. Follow: in addition, a horizon that is absent between two others
   * follows the one that it is nearer to along the border of the area, so that no rock between these is lost. Default:
   * Follow.
   */
  vtkHorizonChoice3Macro(Missing, MissingPolicies, Void, Interpolate, Follow);

  /**
   * Enclosed holes of up to this size are closed, by a smooth surface as in Horizon Hole Filling. Unit: columns. Range:
   * at least 0. Default: 2500.
   */
  vtkHorizonNumberMacro(LargestHoleSize, int);

  /**
   * Gaps that are at most this wide along rows or columns, as at faults and between sparse lines, are closed by linear
   * interpolation. Unit: columns. Range: 0 to 255. Default: 10.
   */
  vtkHorizonNumberMacro(LargestGap, int);

  /**
   * How thoroughly the plan is optimised. Fast: points are inserted where a horizon is farthest. Best: then they are
   * removed, edges flipped and heights fitted. Default: Best.
   */
  vtkHorizonChoice2Macro(Effort, Efforts, Fast, Best);

  /**
   * No flip or removal makes a smaller angle on the map, unless a smaller one was there before. Points are inserted
   * beside smaller ones: all with the effort Fast, those below 2 degrees with Best. Unit: degrees. Range: 0 to 60. Default: 10.
   */
  vtkHorizonNumberMacro(SmallestAngle, double);

  /**
   * For even cells: the longest inner edge of the plan, as in Horizon Surface. 0: as long as the error allows. Unit:
   * columns. Range: 0, or at least 4. Default: 0.
   */
  vtkHorizonNumberMacro(EdgeLength, double);

  /**
   * How edges grow with the distance from outlines, faults and pinch-out lines, as in Horizon Surface. Range: 0 to 1.
   * Default: 0.
   */
  vtkHorizonNumberMacro(EdgeGrowth, double);

  /**
   * Whether heights of inner vertices are fitted to the points around them. Off: they are those of the points.
   * Default: on.
   */
  vtkHorizonFlagMacro(FitHeights);

  /**
   * The number of sublayers of each layer: one for all, or one for each layer from the uppermost on, separated by
   * spaces, such as "1 4 2". They divide its thickness equally at each point on the map, and end where it ends; empty:
   * 1. Range: numbers from 1 to 1000. Default: empty.
   */
  vtkHorizonTextMacro(Sublayers);

  /**
   * Layers get more sublayers until none is thicker anywhere. 0: any. Unit: HeightUnit. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(LargestSublayerThickness, double);

  /**
   * Whether all cells are split into tetrahedra, which fit those of neighbours and fill the same volume. Default: off.
   */
  vtkHorizonFlagMacro(Tetrahedra);

  /**
   * Whether figures include the volume above Contact (VolumeAboveContact). Default: off.
   */
  vtkHorizonFlagMacro(MeasureAboveContact);

  /**
   * A level contact, as of gas and oil. Unit: that of z, upwards. Range: any. Default: 0.
   */
  vtkHorizonNumberMacro(Contact, double);

  /**
   * What the last update made: cells, and of each layer volume and thickness.
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
