// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Small lattices with cracks of all kinds.

#ifndef SeismicHorizonsCrackedPatches_h
#define SeismicHorizonsCrackedPatches_h

#include "Common/Horizon/LinkCuts.h"
#include "Patches.h"

namespace CrackedPatches
{
using SeismicHorizons::LinkCuts;
using SeismicHorizons::PlanePoint;

struct CrackedPatch
{
  Patches::Columns Columns;
  LinkCuts Cuts;
};

/// How many lattices a test tries: 300, or the number in the environment variable SEISMICHORIZONS_CRACKED_LATTICES.
int NumberOfLattices();

/// Cracks with tips inside, with branches and crossings, closed ones, and ones that are open at the border, in a full
/// lattice, in one with gaps, gaps beside the cracks among them, and in random sets of points.
CrackedPatch Make(Patches::Random& random);
}

#endif
