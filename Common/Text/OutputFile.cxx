// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OutputFile.h"

#include "FileErrors.h"

#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

namespace SeismicHorizons
{
namespace
{
namespace fs = std::filesystem;

void WriteStream(const fs::path& path, const std::function<void(std::ostream&)>& write)
{
  std::ofstream stream(path, std::ios::binary);
  if (!stream)
  {
    throw FileError(FileProblem::CannotOpen, "the file cannot be written, expected write permission in its folder");
  }
  try
  {
    write(stream);
  }
  catch (const InputError& error)
  {
    if (stream)
    {
      throw;
    }
    throw FileError(FileProblem::NoRoom, error.what());
  }
  stream.close();
  if (!stream)
  {
    throw FileError(FileProblem::NoRoom, "closing the file failed, expected disk space for the rest");
  }
}

/// The path is in the same folder, and short since names have 255 bytes at most.
fs::path MakeTemporaryPath(const fs::path& path)
{
  std::random_device random;
  std::error_code error;
  fs::path temporary;
  do
  {
    const std::string number = std::to_string(random()) + std::to_string(random());
    temporary = path.parent_path() / ("." + number + ".part");
  } while (fs::exists(fs::symlink_status(temporary, error)));
  return temporary;
}

/// Renames the written file, and keeps the permissions of a replaced file.
void Replace(const fs::path& written, const fs::path& path)
{
  std::error_code error;
  if (fs::exists(path, error))
  {
    fs::permissions(written, fs::status(path, error).permissions(), error);
  }
  fs::rename(written, path, error);
  if (error)
  {
    throw FileError(FileProblem::CannotOpen, "the file cannot be replaced, expected permission: " + error.message());
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& name, const std::function<void(std::ostream&)>& write)
{
  std::error_code ignored;
  const fs::path given = fs::u8path(name);
  this->Path = fs::is_symlink(given, ignored) ? fs::weakly_canonical(given, ignored) : given;
  if (fs::is_directory(this->Path, ignored))
  {
    throw FileError(FileProblem::CannotOpen, "a directory, expected a file");
  }
  if (this->Path.has_parent_path() && !fs::is_directory(this->Path.parent_path(), ignored))
  {
    throw FileError(FileProblem::CannotOpen, "folder \"" + this->Path.parent_path().u8string() + "\" does not exist");
  }
  constexpr std::size_t longest = 255; // Bytes of a name on all usual systems.
  if (const std::size_t length = this->Path.filename().u8string().size(); length > longest)
  {
    throw FileError(FileProblem::CannotOpen,
      "a name of " + std::to_string(length) + " bytes, expected at most " + std::to_string(longest));
  }
  const fs::file_status status = fs::status(this->Path, ignored);
  if (fs::is_fifo(status) || fs::is_socket(status))
  {
    throw FileError(FileProblem::CannotOpen, "a pipe or socket, expected a file"); // Opening a pipe may block.
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    WriteStream(this->Path, write);
    return;
  }
  this->Temporary = MakeTemporaryPath(this->Path);
  try
  {
    WriteStream(this->Temporary, write);
  }
  catch (...)
  {
    fs::remove(this->Temporary, ignored);
    throw;
  }
}

//----------------------------------------------------------------------------------------------------------------------
OutputFile::~OutputFile()
{
  std::error_code ignored;
  if (!this->Temporary.empty())
  {
    fs::remove(this->Temporary, ignored);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void OutputFile::Keep()
{
  if (!this->Temporary.empty())
  {
    Replace(this->Temporary, this->Path);
    this->Temporary.clear();
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WriteOutputFile(const std::string& name, const std::function<void(std::ostream&)>& write)
{
  OutputFile(name, write).Keep();
}
}
