// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Without libFuzzer: tries the methods on the files of a folder. So the programs are built by every compiler, and
// inputs that once showed a fault are tested.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char* argv[])
{
  int files = 0;
  for (int n = 1; n < argc; ++n)
  {
    for (const auto& entry : std::filesystem::directory_iterator(argv[n]))
    {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::vector<char> bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
      std::cout << entry.path() << std::endl; // the last one is the one that fails
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++files;
    }
  }
  return files == 0 ? 1 : 0;
}
