// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that readers read: opened by names in UTF-8, and recognised while they stay as they were.

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
/// What is compared to see whether a file is still the one that was read.
struct FileStamp
{
  std::string Name;
  std::filesystem::file_time_type Time; // of the last change
  std::uintmax_t Size = 0; // bytes

  bool operator==(const FileStamp& other) const
  {
    return this->Name == other.Name && this->Time == other.Time && this->Size == other.Size;
  }
};

/// The stamp of a file as it is now. Throws InputError when there is no regular file of that name.
FileStamp MakeFileStamp(const std::string& name);

/// Opens a file to read its bytes or, where gzip compressed it, what they were made from (GzipStream.h). Throws
/// InputError when that fails.
std::unique_ptr<std::istream> OpenInputFile(const std::string& name);

/// The name of a file without its folder and extension: "a" for "b/a.vsm", and for "b/a.vsm.gz".
std::string StemOf(const std::string& name);

/// The extension of a name in lower case: "vsm" for "b/a.VSM", and for "b/a.vsm.gz"; empty where there is none.
std::string ExtensionOf(const std::string& name);

/// The first bytes of a stream, at most that many, without a byte order mark. Goes back to where it was.
std::string PeekText(std::istream& stream, std::size_t most);

/// The same without a last line that is cut off there.
std::string PeekLines(std::istream& stream, std::size_t most);

/// Refuses a name that was not set.
void RequireFileName(const char* name);

/// What errors about a file begin with: its name, and a colon.
std::string FilePrefix(const char* name);

/// Whether recognise(stream) says so of a regular file that can be opened; false where that throws.
template <typename Recognise>
bool IsRecognised(const char* name, Recognise&& recognise)
{
  try
  {
    const std::string text = name ? name : "";
    MakeFileStamp(text); // refuses what is no regular file
    return recognise(*OpenInputFile(text));
  }
  catch (const std::exception&)
  {
    return false;
  }
}
}

#endif
