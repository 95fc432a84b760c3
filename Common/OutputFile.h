// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that writers write, by names in UTF-8.

#ifndef SeismicHorizonsOutputFile_h
#define SeismicHorizonsOutputFile_h

#include <functional>
#include <ostream>
#include <string>

namespace SeismicHorizons
{
/// Writes a file by `write`, under a name of its own in the same folder that becomes the right one at the end. So a
/// file of that name stays as it was until then, and also when `write` throws, which removes what was written. What is
/// no regular file, as a device, is written to directly. Throws InputError when the file can not be written.
void WriteOutputFile(const std::string& name, const std::function<void(std::ostream&)>& write);
}

#endif
