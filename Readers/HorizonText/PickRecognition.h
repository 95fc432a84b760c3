// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a file is one of picks, whatever its name. Programs that open files ask this of each file, so that a table or
// another format must not be taken for picks.

#ifndef SeismicHorizonsPickRecognition_h
#define SeismicHorizonsPickRecognition_h

#include <istream>
#include <string>

namespace SeismicHorizons
{
/// Looks at the first 256 kilobytes. Where the extension (ExtensionOf) is one that picks often have, or none, columns
/// of numbers are taken even if it is doubtful how to read them: the reader says what to do about it. Under any other
/// name picks have to be in a format that is recognised, or to stand on a lattice below names that say what they are,
/// or below none. Goes back to the beginning.
bool ArePicks(std::istream& stream, const std::string& extension);
}

#endif
