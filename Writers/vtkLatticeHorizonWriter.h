// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLatticeHorizonWriter
 * @brief   base of the writers of horizons at the columns of their lattice
 *
 * Horizons without triangles are written as they are; their points must be on columns. Meshes are sampled: each column
 * that a triangle covers gets the z of the mesh there, so that a simplified horizon becomes regular again. Points on
 * other columns are also written. The lattice is that of the field data LatticeToWorld and LatticeDimensions.
 */

#ifndef vtkLatticeHorizonWriter_h
#define vtkLatticeHorizonWriter_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonWriter.h"
#include "vtkSeismicHorizonsModule.h"

namespace SeismicHorizons
{
enum class WrittenSense;
}

class VTKSEISMICHORIZONS_EXPORT vtkLatticeHorizonWriter : public vtkHorizonWriter
{
public:
  vtkTypeMacro(vtkLatticeHorizonWriter, vtkHorizonWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Direction of increasing z in the file. AsRead: as in the horizon's file, else up. Elevation: up. Depth: down.
   * Default: AsRead.
   */
  vtkHorizonChoice3Macro(VerticalPositive, VerticalSense, AsRead, Elevation, Depth);

protected:
  vtkLatticeHorizonWriter() = default;
  ~vtkLatticeHorizonWriter() override = default;

  SeismicHorizons::WrittenSense Sense() const;

private:
  vtkLatticeHorizonWriter(const vtkLatticeHorizonWriter&) = delete;
  void operator=(const vtkLatticeHorizonWriter&) = delete;

  int VerticalPositive = AsRead;
};

#endif
