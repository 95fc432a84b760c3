// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLedgerOutput_h
#define SeismicHorizonsLedgerOutput_h

#include "Common/Horizon/CoveredColumns.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Ledger.h"
#include "LatticePoints.h"

#include <optional>

namespace SeismicHorizons
{
/// `covered` are the columns of the output. After merging or dropping, points have no columns, and the ledger of the
/// input is adapted; without it none is written.
/// Only points that are kept can be known.
void WriteLedger(const LatticePoints& points, const KeptPoints& kept, const CoveredColumns& covered, Horizon& output);

/// The ledger of points that are added in parts and are not merged.
class PointLedger
{
public:
  /// `covered` must outlive this.
  explicit PointLedger(const CoveredColumns& covered)
    : Covered(covered)
  {
  }

  void Add(const Horizon& points, PlanePoints columns, const KeptPoints& kept);
  void Write(ArrayTable& figures) const;

private:
  const CoveredColumns& Covered;
  Ledger Counted;
  Ledger Points;
  std::optional<Ledger> Given; // of the input
};

/// For outputs of points alone, unless the stage has written a ledger. Loops and meshes keep the ledger of the input.
void WriteLedgerOfPoints(const Horizon& input, Horizon& output);
}

#endif
