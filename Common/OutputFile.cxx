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

/// The path with something behind it that no other file has.
fs::path MakeTemporaryPath(fs::path path)
{
  path += "." + std::to_string(std::random_device()()) + ".part";
  return path;
}

/// Gives the file that was written the name of the other one, and the permissions of a file that was there.
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
  if (fs::exists(this->Path, ignored) && !fs::is_regular_file(this->Path, ignored))
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
