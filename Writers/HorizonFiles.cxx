// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFiles.h"

#include "Common/Text/TextWords.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <list>
#include <unordered_set>

namespace SeismicHorizons
{
namespace
{
/// Underscores replace characters that some file systems forbid; other alphabets remain.
std::string MakeFileName(std::string text)
{
  const auto isKept = [](char c)
  {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::isalnum(byte) || c == '.' || c == '+' || c == '-';
  };
  std::replace_if(
    text.begin(), text.end(), [&](char c) { return !isKept(c); }, '_');
  return text;
}

std::string Shorten(const std::string& text, std::size_t most)
{
  std::size_t size = std::min(text.size(), most);
  while (size > 0 && size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U)
  {
    --size;
  }
  return text.substr(0, size);
}

}

//----------------------------------------------------------------------------------------------------------------------
/// Names that differ in case alone are equal on some systems, and get a number, as equal names do.
std::vector<std::string> NameFiles(const std::string& path, const std::vector<std::string>& horizons)
{
  const std::filesystem::path file = std::filesystem::u8path(path);
  constexpr std::size_t longest = 255; // Bytes of a name that all usual systems allow.
  constexpr std::size_t numberSize = 12;
  const std::string stem = file.stem().u8string() + '_';
  const std::string extension = file.extension().u8string();
  const std::size_t taken = std::min(longest - 1, stem.size() + extension.size() + numberSize);
  std::vector<std::string> paths;
  std::unordered_set<std::string> small;
  for (const std::string& horizon : horizons)
  {
    const std::string first = Shorten(MakeFileName(horizon), longest - taken);
    std::string name = first;
    for (int number = 2; !small.insert(ToLower(name)).second; ++number)
    {
      name = first + " (" + std::to_string(number) + ')';
    }
    paths.push_back((file.parent_path() / std::filesystem::u8path(stem + name + extension)).u8string());
  }
  return paths;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteFiles(const std::vector<std::string>& paths,
  const std::function<void(std::size_t, std::ostream&, const Monitor&)>& print, const Monitor& monitor,
  std::string& subject)
{
  std::list<OutputFile> files;
  for (std::size_t n = 0; n < paths.size(); ++n)
  {
    const auto part = [&](std::size_t number) { return double(number) / double(paths.size()); };
    subject = paths[n];
    files.emplace_back(paths[n], [&](std::ostream& stream) { print(n, stream, monitor.Step(part(n), part(n + 1))); });
  }
  auto path = paths.begin();
  for (OutputFile& file : files)
  {
    subject = *path++;
    file.Keep();
  }
}
}
