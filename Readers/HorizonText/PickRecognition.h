// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Programs that open files ask this of every file, so that tables and other formats must not be taken for picks.

#ifndef SeismicHorizonsPickRecognition_h
#define SeismicHorizonsPickRecognition_h

#include <istream>
#include <string>

namespace SeismicHorizons
{
/// Rewinds the stream. With an extension of picks, or none, ambiguous fields are accepted. Others need a recognised
/// format, or picks on a lattice without header or below complete names, in the first 256 kilobytes.
bool ArePicks(std::istream& stream, const std::string& extension);
}

#endif
