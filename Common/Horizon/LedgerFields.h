// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLedgerFields_h
#define SeismicHorizonsLedgerFields_h

#include "Horizon.h"
#include "Ledger.h"

#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// Empty without the array Filled.
std::vector<unsigned char> ReadFilled(const Horizon& points);

Ledger CountPoints(const Horizon& points);

std::optional<Ledger> ReadLedger(const ArrayTable& data);

/// Adds areas if the field data have a lattice.
void WriteLedger(const Ledger& ledger, ArrayTable& data);
}

#endif
