// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files are written as a whole or not at all.

#include "Common/Base/Errors.h"
#include "Common/Text/OutputFile.h"
#include "Tools/Check.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#ifndef _WIN32
#include <sys/stat.h>
#endif

using namespace SeismicHorizons;

namespace
{
namespace fs = std::filesystem;

const fs::path Folder = fs::absolute("TestOutputFile");

void Write(const fs::path& path, const std::string& text)
{
  WriteOutputFile(path.u8string(), [&text](std::ostream& stream) { stream << text; });
}

std::string Read(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

std::size_t CountFiles()
{
  return std::size_t(std::distance(fs::directory_iterator(Folder), fs::directory_iterator()));
}

void FilesAreReplaced()
{
  const fs::path file = Folder / fs::u8path("H\xC3\xB6he.ts");
  Write(file, "one");
  Write(file, "two");
  CHECK_EQUAL(Read(file), "two");
  CHECK_EQUAL(CountFiles(), 1u);
}

void NothingIsLeftOfAnError()
{
  const fs::path file = Folder / fs::u8path("H\xC3\xB6he.ts");
  const auto fail = [](std::ostream& stream)
  {
    stream << "half of it";
    throw InputError("broken");
  };
  CHECK_THROWS_WITH(WriteOutputFile(file.u8string(), fail), "broken");
  CHECK_EQUAL(Read(file), "two");
  CHECK_EQUAL(CountFiles(), 1u);
}

void LinksStay()
{
  const fs::path link = Folder / "link.ts";
  fs::create_symlink("target.ts", link);
  Write(Folder / "target.ts", "old");
  Write(link, "new");
  CHECK(fs::is_symlink(link));
  CHECK_EQUAL(Read(Folder / "target.ts"), "new");
}

void PermissionsStay()
{
  const fs::path file = Folder / "target.ts";
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  Write(file, "again");
  CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

void WrongPlacesAreRefused()
{
  CHECK_THROWS_WITH(Write(Folder, "x"), "a directory, expected a file");
  CHECK_THROWS_WITH(
    Write(Folder / "none" / "x.ts", "x"), "folder \"" + (Folder / "none").u8string() + "\" does not exist");
  CHECK_THROWS_WITH(Write(Folder / std::string(300, 'x'), "x"), "a name of 300 bytes, expected at most 255");
}

/// A file with a name as long as may be is written all the same, and neighbours stay, whatever they are called.
void NamesAreFree()
{
  const std::string name(255, 'x');
  Write(Folder / (name.substr(5) + ".part"), "neighbour");
  Write(Folder / name, "long");
  CHECK_EQUAL(Read(Folder / name), "long");
  CHECK_EQUAL(Read(Folder / (name.substr(5) + ".part")), "neighbour");
}

#ifndef _WIN32
/// Opening one would wait for a reader.
void PipesAreRefused()
{
  const fs::path pipe = Folder / "pipe.ts";
  CHECK_EQUAL(mkfifo(pipe.c_str(), 0600), 0);
  CHECK_THROWS_WITH(Write(pipe, "x"), "a pipe or socket, expected a file");
  CHECK(fs::is_fifo(pipe));
}
#endif

/// A device is written to directly, and never replaced.
void FullDisksAreNoticed()
{
  if (fs::exists("/dev/full"))
  {
    CHECK_THROWS_WITH(Write("/dev/full", "x"), "closing the file failed, expected disk space for the rest");
    CHECK(fs::is_character_file("/dev/full"));
  }
}
}

int TestOutputFile(int, char*[])
{
  fs::remove_all(Folder);
  fs::create_directories(Folder);
  FilesAreReplaced();
  NothingIsLeftOfAnError();
  LinksStay();
  PermissionsStay();
  WrongPlacesAreRefused();
  NamesAreFree();
#ifndef _WIN32
  PipesAreRefused();
#endif
  FullDisksAreNoticed();
  return Check::Result();
}
