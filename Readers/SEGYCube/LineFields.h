// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which fields of trace headers have the line numbers and the places of a cube. Programs agree on none.

#ifndef SeismicHorizonsLineFields_h
#define SeismicHorizonsLineFields_h

#include "Common/Monitor.h"
#include "TraceTable.h"

#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A pair of fields, by the bytes where they begin.
struct FieldPair
{
  int First = 0;
  int Second = 0;
};

/// Stands for a field that no trace has.
constexpr int NoField = -1;

/// All fields of line numbers and places that are looked at.
std::vector<int> ListFields();

/// Where x and y of traces may be, those that are tried first in front.
std::vector<FieldPair> ListPlaceFields();

/// Whether a trace says that it is dead, and has no line numbers: some programs fill up files with such traces.
bool IsFiller(const TraceTable& table, const FieldPair& lines, std::int64_t trace);

/// The fields of inlines and crosslines: a pair that makes a grid. Both have more than one number, and less than there
/// are traces; at most a twentieth of the traces are at the place of another one, or half of them where `mayRepeat`;
/// and the grid of their steps is full to a tenth at least. Of several pairs those whose grids are full to 0.15 of the
/// fullest count, and of these the first of the usual ones; that of x and y only with numbers up to 99,999. Where there
/// is none, a line: one field of a pair is the same for all traces, and the other different for each. Nothing where
/// there is neither. Throws InputError where traces have different offsets, as before stacking.
std::optional<FieldPair> FindLineFields(
  const TraceTable& table, bool mayRepeat = false, const Monitor& monitor = Monitor());

/// What to do where the fields of lines are others than those that were found. `other` is a pair that may be meant.
std::string OtherLinesText(const std::optional<FieldPair>& other);

/// Whether a pair is usual for x and y as well.
bool IsPlacePair(const FieldPair& pair);

/// A pair that makes a grid, of all fields of a table but those of x and y.
std::optional<FieldPair> FindAnyGrid(const TraceTable& table);

/// Throws InputError that says what was found. `other` is a pair that may be meant.
[[noreturn]] void RefuseLines(const TraceTable& table, const std::optional<FieldPair>& other);
}

#endif
