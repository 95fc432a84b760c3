// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OutputFile.h"

#include "Errors.h"

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
    throw InputError("a file that can not be written, expected a folder with permission to");
  }
  write(stream);
  stream.close();
  if (!stream)
  {
    throw InputError("a file that could not be written to its end, expected room for it");
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
    throw InputError("a file that can not be replaced, expected permission to: " + error.message());
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteOutputFile(const std::string& name, const std::function<void(std::ostream&)>& write)
{
  std::error_code ignored;
  const fs::path given = fs::u8path(name);
  const fs::path path = fs::is_symlink(given, ignored) ? fs::weakly_canonical(given, ignored) : given;
  if (fs::is_directory(path, ignored))
  {
    throw InputError("a directory, expected a file");
  }
  if (path.has_parent_path() && !fs::is_directory(path.parent_path(), ignored))
  {
    throw InputError("a file in a folder that is not there, expected an existing folder");
  }
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
  {
    WriteStream(path, write);
    return;
  }
  const fs::path temporary = MakeTemporaryPath(path);
  try
  {
    WriteStream(temporary, write);
    Replace(temporary, path);
  }
  catch (...)
  {
    fs::remove(temporary, ignored);
    throw;
  }
}
}
