// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsInputFile_h
#define SeismicHorizonsInputFile_h

#include "FileErrors.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>

namespace SeismicHorizons
{
struct FileStamp
{
  std::string Name;
  std::filesystem::file_time_type Time;
  std::uintmax_t Size = 0;

  bool operator==(const FileStamp& other) const
  {
    return this->Name == other.Name && this->Time == other.Time && this->Size == other.Size;
  }
};

/// Throws InputError unless the file is regular.
FileStamp MakeFileStamp(const std::string& name);

/// Decodes gzip (GzipStream.h). Throws InputError on failure, and unless the file is regular.
std::unique_ptr<std::istream> OpenInputFile(const std::string& name);

/// Returns "a" for "b/a.vsm" and "b/a.vsm.gz".
std::string StemOf(const std::string& name);

/// Returns "vsm" for "b/a.VSM" and "b/a.vsm.gz".
std::string ExtensionOf(const std::string& name);

/// Skips a byte order mark. The stream keeps its position.
std::string PeekText(std::istream& stream, std::size_t most);

constexpr std::size_t BytesToRecognise = 64 * 1024;

/// Omits an incomplete last line.
std::string PeekLines(std::istream& stream, std::size_t most = BytesToRecognise);

void RequireFileName(const char* name);

std::string FilePrefix(const char* name);

/// Returns false if the file is not regular or recognise(stream) throws.
template <typename Recognise>
bool IsRecognised(const char* name, Recognise&& recognise)
{
  try
  {
    return recognise(*OpenInputFile(name ? name : ""));
  }
  catch (const std::exception&)
  {
    return false;
  }
}
}

#endif
