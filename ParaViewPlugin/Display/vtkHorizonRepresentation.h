// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonRepresentation
 * @brief   shows horizons as lit surfaces with contours
 *
 * Points on columns are drawn as a surface (see HorizonSheet.h) with contours, unless the representation is "Points".
 * It is thinned to 500,000 points, or 200,000 while the view is moved, which may hide holes and faults between the
 * columns that are shown; the data are not thinned.
 *
 * Images and volumes get their heights as an array, as horizons have it (see VerticalAxis.h), so that all are coloured
 * on one scale. Thickness and throw are there in the unit of z, too, with it in their names. The boundary of simplified
 * outlines is also there as "Simplified Boundary", to have other colours than the outlines it was made of. Fault lines
 * are shown at the upper edge of the step, not in its middle, where the horizon hides them.
 */

#ifndef vtkHorizonRepresentation_h
#define vtkHorizonRepresentation_h

#include "vtkPVCompositeRepresentation.h"
#include "vtkSmartPointer.h"

class vtkHorizonHeights;

class vtkHorizonRepresentation : public vtkPVCompositeRepresentation
{
public:
  static vtkHorizonRepresentation* New();
  vtkTypeMacro(vtkHorizonRepresentation, vtkPVCompositeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets ParaView make objects of this class, by its name in the XML, and call them like those of the base.
  static void Register();

  /// Distance of contours in units of z; every fifth is bold. 0: none.
  void SetContourInterval(double interval);

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output) override;
  vtkDataObject* GetRenderedDataObject(int port) override;

protected:
  vtkHorizonRepresentation();
  ~vtkHorizonRepresentation() override;

private:
  vtkHorizonRepresentation(const vtkHorizonRepresentation&) = delete;
  void operator=(const vtkHorizonRepresentation&) = delete;

  /// Inserts the heights between the pipeline and the mapper. Returns false if nothing is drawn.
  bool InsertHeights();

  vtkSmartPointer<vtkHorizonHeights> Heights;
};

#endif
