// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fields without names are recognised by their values. Ambiguous fields are refused, since a wrong guess gives a wrong
// horizon.

#ifndef SeismicHorizonsFieldWarnings_h
#define SeismicHorizonsFieldWarnings_h

#include "FieldGuess.h"
#include "TextLayout.h"

#include <string>

namespace SeismicHorizons
{
/// Throws InputError for rows of a grid: too many and too similar unnamed fields.
void RefuseMatrix(const TextLines& sample, const TextLayout& layout);

/// Throws InputError, which says what to set, if guessed fields may be wrong: places in other fields, numbers that
/// touch or have decimal commas, line numbers that may be places, or a z that is constant or counts lines.
void RefuseDoubtfulColumns(const TextLines& sample, const TextLayout& layout);

std::string DoubtOfColumns(const TextLines& sample, const TextLayout& layout);
}

#endif
