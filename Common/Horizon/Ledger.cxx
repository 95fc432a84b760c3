// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Ledger.h"

#include <iomanip>
#include <locale>
#include <sstream>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::vector<LedgerWarning> FindWarnings(const Ledger& ledger)
{
  std::vector<LedgerWarning> warnings;
  for (std::size_t entry = std::size_t(LedgerEntry::Known) + 1; entry < LedgerEntries; ++entry)
  {
    const bool isLeftOut = LedgerEntry(entry) == LedgerEntry::LeftOut;
    const std::int64_t whole = isLeftOut ? ledger.Read() : ledger.Covered();
    const double fraction = double(ledger.Columns[entry]) / double(std::max<std::int64_t>(whole, 1));
    if (fraction > LedgerWarningFraction)
    {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text << std::setprecision(4) << 100.0 * fraction << " % " << (isLeftOut ? "of the points " : "") << LedgerWords[entry];
      warnings.push_back({ LedgerEntry(entry), text.str() });
    }
  }
  return warnings;
}
}
