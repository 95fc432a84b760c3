// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsOutputFile_h
#define SeismicHorizonsOutputFile_h

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace SeismicHorizons
{
/// The file is written under a temporary name in the same folder, and renamed by Keep(). Otherwise it is removed, and
/// an existing file stays. Devices are written directly. Throws InputError if the file cannot be written.
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
  std::filesystem::path Temporary;
};

void WriteOutputFile(const std::string& name, const std::function<void(std::ostream&)>& write);
}

#endif
