// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Accounts for all columns of a horizon, a mesh or a layer: each column is in exactly one of five entries.

#ifndef SeismicHorizonsLedger_h
#define SeismicHorizonsLedger_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// In the order of the components of its arrays.
enum class LedgerEntry
{
  Known, // The column has a point that was read, and is in the result.
  Filled, // Hole filling or gridding computed a height between known columns.
  Bridged, // Triangles or cells cover the column, which has no point.
  Extrapolated, // A height was computed outside the known columns.
  LeftOut // The column has a point that the result does not cover.
};

constexpr std::size_t LedgerEntries = 5;
constexpr std::array<const char*, LedgerEntries> LedgerNames = { "Known", "Filled", "Bridged", "Extrapolated",
  "LeftOut" };
/// The same as texts have them.
constexpr std::array<const char*, LedgerEntries> LedgerWords = { "known", "filled", "bridged", "extrapolated",
  "left out" };

/// Columns per entry; the area is their number times the area of a bin.
struct Ledger
{
  std::array<std::int64_t, LedgerEntries> Columns{};

  std::int64_t& operator[](LedgerEntry entry) { return this->Columns[std::size_t(entry)]; }
  std::int64_t operator[](LedgerEntry entry) const { return this->Columns[std::size_t(entry)]; }

  std::int64_t Covered() const
  {
    std::int64_t sum = 0;
    for (std::size_t entry = 0; entry < LedgerEntries; ++entry)
    {
      sum += LedgerEntry(entry) == LedgerEntry::LeftOut ? 0 : this->Columns[entry];
    }
    return sum;
  }

  std::int64_t Read() const { return (*this)[LedgerEntry::Known] + (*this)[LedgerEntry::LeftOut]; }

  void Add(const Ledger& other)
  {
    for (std::size_t entry = 0; entry < LedgerEntries; ++entry)
    {
      this->Columns[entry] += other.Columns[entry];
    }
  }

  /// Sets the covered columns to n if it is unknown which have points; Bridged changes first.
  void CoverOnly(std::int64_t n)
  {
    (*this)[LedgerEntry::Bridged] += std::max<std::int64_t>(0, n - this->Covered());
    for (const LedgerEntry entry :
      { LedgerEntry::Bridged, LedgerEntry::Known, LedgerEntry::Filled, LedgerEntry::Extrapolated })
    {
      const std::int64_t less = std::min((*this)[entry], this->Covered() - n);
      (*this)[entry] -= less;
      (*this)[LedgerEntry::LeftOut] += entry == LedgerEntry::Known ? less : 0;
    }
  }
};

/// `filled` is the value of the array Filled.
constexpr LedgerEntry EntryOf(unsigned char filled)
{
  return filled == 0 ? LedgerEntry::Known : filled == 1 ? LedgerEntry::Filled : LedgerEntry::Extrapolated;
}

/// Fraction of the covered columns above which an entry other than Known deserves a warning.
constexpr double LedgerWarningFraction = 0.001;

struct LedgerWarning
{
  LedgerEntry Entry;
  std::string Text; // "8.123 % filled", of the covered columns
};

/// The entries that deserve a warning, in their order.
std::vector<LedgerWarning> FindWarnings(const Ledger& ledger);
}

#endif
