// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonHoleFilling
 * @brief   new points in the gaps of a horizon
 *
 * Input: a horizon before it has an outline, or a composite dataset of such; at most one point in a column of the
 * lattice. Output: the same points with their arrays, bit by bit, and after them a new point on each column of the
 * holes that are filled; a vertex cell for each point. A hole is a group of empty columns, connected side by side, that
 * a patch encloses: what vtkHorizonExteriorBoundary with a radius of 1 takes for one. Empty columns around patches stay
 * empty. Where a patch lies in a hole of another one, both are the rim of the hole.
 *
 * Point arrays:
 *  - Filled (unsigned char): 1 at new points, else 0;
 *  - PointCount (vtkIdType): 0 at new points, as they stand for no voxel; so they weigh nothing in means;
 *  - VerticalIndex, RealZ: those of the new surface; floating point numbers: by a membrane, or nan (see Attributes);
 *    all else, which are labels: that of the nearest point of the rim;
 *  - PatchId and Boundary of an outline before are left out, as it is that of the holes.
 * Field data, one vtkIdType each: NumberOfFilledHoles, NumberOfFilledPoints, and NumberOfOpenHoles, those that are too
 * large.
 *
 * Each hole is filled for itself; where the field data array CutLinks (Documentation/DataModel.md) cuts links of the
 * lattice, each side of the cuts alone. With Plate, the least energy of bending of a thin plate over the hole and a
 * ring of known columns around it, held to their heights by springs (Briggs 1974; of RimSmoothing 0 it goes through
 * them), and then a membrane that carries what is left at the rim inwards. With Membrane, each new point is the mean of
 * its four neighbours (Laplace's equation). Holes of few columns are solved directly, large ones by multigrid: time is
 * linear in the points, the columns of the bounding box, and the columns filled. Memory beyond input and output: 24
 * bytes per point, 4 per column of the bounding box, and about 1000 per column of the largest hole.
 *
 * Errors: two points in one column, a point between columns or off the lattice, no lattice in the field data, a
 * parameter out of its range, cut links that are not on the lattice.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonDespiking
 */

#ifndef vtkHorizonHoleFilling_h
#define vtkHorizonHoleFilling_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

namespace SeismicHorizons
{
struct HoleFillingOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkHorizonHoleFilling : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonHoleFilling* New();
  vtkTypeMacro(vtkHorizonHoleFilling, vtkHorizonAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// By what surface holes are filled.
  enum Methods
  {
    Plate = 0,
    Membrane = 1
  };

  /// What new points get in the arrays of the input.
  enum AttributeChoices
  {
    FromRim = 0,
    NotANumber = 1
  };

  ///@{
  /**
   * Holes of more columns stay open. The error of a filled column grows with its distance from the rim. At least 1.
   * Default: 2500, which is a square of 50 columns.
   */
  vtkSetMacro(LargestHoleSize, vtkIdType);
  vtkGetMacro(LargestHoleSize, vtkIdType);
  ///@}

  ///@{
  /**
   * The same as an area: columns of the hole times the area of a column, in square units of the world. Holes above
   * either limit stay open. At least 0, which sets no limit. Default: 0.
   */
  vtkSetMacro(LargestHoleArea, double);
  vtkGetMacro(LargestHoleArea, double);
  ///@}

  ///@{
  /**
   * The surface over a hole. Plate goes on with the dip and the bend of the rim; Membrane rises and falls no further
   * than the rim does. Default: Plate.
   */
  vtkSetClampMacro(Method, int, Plate, Membrane);
  vtkGetMacro(Method, int);
  void SetMethodToPlate() { this->SetMethod(Plate); }
  void SetMethodToMembrane() { this->SetMethod(Membrane); }
  ///@}

  ///@{
  /**
   * How much the plate smooths the heights of the ring: the inverse of the strength of its springs. 0 (and all below a
   * millionth) makes it go through all heights, for data without noise; 16 suits heights with a noise of more than half
   * a vertical index. Known points keep their heights in any case. 0 to 1e6. Default: 1.
   */
  vtkSetMacro(RimSmoothing, double);
  vtkGetMacro(RimSmoothing, double);
  ///@}

  ///@{
  /**
   * How many columns wide the ring of known columns is that a plate goes on from. 1 to 64; below 2 it has no dip from a
   * rim that is straight. Default: 3.
   */
  vtkSetMacro(RimWidth, int);
  vtkGetMacro(RimWidth, int);
  ///@}

  ///@{
  /**
   * What attributes of floating point numbers are at new points. FromRim: carried inwards from the rim by a membrane,
   * where values that are not finite count as unknown. NotANumber: nan. Default: FromRim.
   */
  vtkSetClampMacro(Attributes, int, FromRim, NotANumber);
  vtkGetMacro(Attributes, int);
  void SetAttributesToFromRim() { this->SetAttributes(FromRim); }
  void SetAttributesToNotANumber() { this->SetAttributes(NotANumber); }
  ///@}

  ///@{
  /**
   * Of the last update, over all horizons: how many holes were filled, with how many points, and how many are left.
   */
  vtkGetMacro(NumberOfFilledHoles, vtkIdType);
  vtkGetMacro(NumberOfFilledPoints, vtkIdType);
  vtkGetMacro(NumberOfOpenHoles, vtkIdType);
  ///@}

protected:
  vtkHorizonHoleFilling() = default;
  ~vtkHorizonHoleFilling() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void ProcessHorizon(vtkPolyData* input, const Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonHoleFilling(const vtkHorizonHoleFilling&) = delete;
  void operator=(const vtkHorizonHoleFilling&) = delete;

  SeismicHorizons::HoleFillingOptions MakeOptions(double columnArea) const;

  vtkIdType LargestHoleSize = 2500;
  double LargestHoleArea = 0.0;
  int Method = Plate;
  double RimSmoothing = 1.0;
  int RimWidth = 3;
  int Attributes = FromRim;
  vtkIdType NumberOfFilledHoles = 0;
  vtkIdType NumberOfFilledPoints = 0;
  vtkIdType NumberOfOpenHoles = 0;
};

#endif
