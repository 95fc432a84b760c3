// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Columns without names are known by what their values look like. What looks like something else as well is refused: a
// wrong guess would make a horizon that is none.

#ifndef SeismicHorizonsColumnDoubts_h
#define SeismicHorizonsColumnDoubts_h

#include "ColumnGuess.h"
#include "TextLayout.h"

#include <string>

namespace SeismicHorizons
{
/// Throws InputError where columns without names are more, and more alike, than those of picks are: rows of a grid.
void RefuseMatrix(const TextLines& sample, const TextLayout& layout);

/// Throws InputError, which says what to set, where guessed columns may be others: places that stand elsewhere, numbers
/// that touch or have decimal commas, line numbers that may be places, and a z that counts lines or is the same in all
/// while another column is not.
void RefuseDoubtfulColumns(const TextLines& sample, const TextLayout& layout);

/// What users should know of columns that were guessed; empty where there is nothing.
std::string DoubtOfColumns(const TextLines& sample, const TextLayout& layout);
}

#endif
