// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that writers write, by names in UTF-8.

#ifndef SeismicHorizonsOutputFile_h
#define SeismicHorizonsOutputFile_h

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace SeismicHorizons
{
/// A file that is written under a name of its own in the same folder, and gets the right one by Keep(). Without that,
/// nothing is left of it, and a file of that name stays as it was. A device is written to directly. Throws InputError
/// when the file cannot be written.
class OutputFile
{
public:
  OutputFile(const std::string& name, const std::function<void(std::ostream&)>& write);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void Keep();

private:
  std::filesystem::path Path;
  std::filesystem::path Temporary; // empty where there is none
};

/// Writes a file as a whole or not at all.
void WriteOutputFile(const std::string& name, const std::function<void(std::ostream&)>& write);
}

#endif
