// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "InputFile.h"

#include "GzipStream.h"
#include "TextWords.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <system_error>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
FileStamp MakeFileStamp(const std::string& name)
{
  const std::filesystem::path path = std::filesystem::u8path(name);
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status))
  {
    const bool isLink = std::filesystem::is_symlink(path, ignored);
    throw FileError(FileProblem::NotFound, isLink ? "a link to a file that does not exist" : "no such file");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw FileError(FileProblem::CannotOpen,
      std::filesystem::is_directory(status) ? "a directory, expected a file"
                                            : "a special file, expected a regular one");
  }
  return { name, std::filesystem::last_write_time(path, ignored), std::filesystem::file_size(path, ignored) };
}

//----------------------------------------------------------------------------------------------------------------------
std::unique_ptr<std::istream> OpenInputFile(const std::string& name)
{
  MakeFileStamp(name); // Refuses folders and devices.
  auto stream = std::make_unique<std::ifstream>(std::filesystem::u8path(name), std::ios::binary);
  if (!*stream)
  {
    throw FileError(FileProblem::CannotOpen, "the file cannot be opened, expected a readable one");
  }
  if (BeginsAsGzip(*stream))
  {
    return std::make_unique<GzipStream>(std::move(stream));
  }
  return stream;
}

//----------------------------------------------------------------------------------------------------------------------
std::string StemOf(const std::string& name)
{
  std::filesystem::path path = std::filesystem::u8path(name);
  if (ToLower(path.extension().u8string()) == ".gz")
  {
    path.replace_extension();
  }
  return path.stem().u8string();
}

//----------------------------------------------------------------------------------------------------------------------
std::string ExtensionOf(const std::string& name)
{
  std::filesystem::path path = std::filesystem::u8path(name);
  if (ToLower(path.extension().u8string()) == ".gz")
  {
    path.replace_extension();
  }
  const std::string extension = ToLower(path.extension().u8string());
  return extension.substr(std::min<std::size_t>(1, extension.size()));
}

//----------------------------------------------------------------------------------------------------------------------
std::string PeekText(std::istream& stream, std::size_t most)
{
  const std::istream::pos_type here = stream.tellg();
  std::string bytes;
  try
  {
    for (char c = 0; bytes.size() < most && stream.get(c);)
    {
      bytes += c;
    }
  }
  catch (const std::exception&)
  {
    // A truncated compressed file ends early here; reading reports it.
  }
  stream.clear();
  stream.seekg(here);
  return std::string(WithoutByteOrderMark(bytes));
}

//----------------------------------------------------------------------------------------------------------------------
std::string PeekLines(std::istream& stream, std::size_t most)
{
  std::string text = PeekText(stream, most);
  if (text.size() + ByteOrderMark.size() >= most)
  {
    text.resize(text.rfind('\n') + 1); // npos + 1 is 0.
  }
  return text;
}

//----------------------------------------------------------------------------------------------------------------------
void RequireFileName(const char* name)
{
  if (!name)
  {
    throw FileError(FileProblem::NoName, "no FileName, expected the path of a file");
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string FilePrefix(const char* name)
{
  return name ? std::string(name) + ": " : std::string();
}
}
