// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the fields of line numbers and places, on which programs do not agree.
//
// Fields form a grid if both vary and repeat, at most 5 % of the traces share a bin, and at least 10 % of the bins have
// traces. Among pairs within 0.15 of the fullest grid the first of the usual pairs is used; the fields of x and y only
// with numbers up to 99,999. A line has one constant field and another that differs for each trace.

#ifndef SeismicHorizonsLineFields_h
#define SeismicHorizonsLineFields_h

#include "Common/Base/Monitor.h"
#include "TraceTable.h"

#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// First bytes of two fields, from 1.
struct FieldPair
{
  int First = 0;
  int Second = 0;
};

constexpr int NoField = -1;

std::vector<int> ListFields();

/// Returns the preferred fields first.
std::vector<FieldPair> ListPlaceFields();

/// Some programs pad files with dead traces without line numbers.
bool IsFiller(const TraceTable& table, const FieldPair& lines, std::int64_t trace);

/// Finds fields of a grid or a line. `mayRepeat` allows 50 % of the traces to share a bin. Throws InputError for
/// different offsets (pre-stack data).
std::optional<FieldPair> FindLineFields(
  const TraceTable& table, bool mayRepeat = false, const Monitor& monitor = Monitor());

/// `other` is a candidate.
std::string OtherLinesText(const std::optional<FieldPair>& other);

bool IsPlacePair(const FieldPair& pair);

std::optional<FieldPair> FindAnyGrid(const TraceTable& table);

/// Throws InputError; `other` is a candidate.
[[noreturn]] void RefuseLines(const TraceTable& table, const std::optional<FieldPair>& other);
}

#endif
